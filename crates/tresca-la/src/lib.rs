//! Linear algebra for `tresca`: vectors, symmetric sparse matrices, orderings,
//! sparse Cholesky with a trailing (Schur) block, and Krylov methods.
//!
//! Storage and kernels are faer's; what lives here is what the contact problem
//! needs on top of them.

mod cholesky;
mod kernels;
pub mod krylov;
mod operator;
mod ordering;
mod packed;
mod parallelism;
mod square;
mod symmetric;
pub mod vector;

pub use cholesky::{FactorError, SparseCholesky, TrailingBlock};
pub use operator::{LinearOperator, SymmetricEntries};
pub use ordering::{Ordering, OrderingError};
pub use packed::PackedLower;
pub use parallelism::Parallelism;
pub use square::{SquareMatrix, SquareReport};
pub use symmetric::SymmetricMatrix;
