//! Linear algebra for `tresca`: vectors, symmetric sparse matrices, orderings,
//! solvers of bodies (sparse Cholesky with a trailing Schur block), and Krylov methods.
//!
//! Storage and kernels are faer's; what lives here is what the contact problem
//! needs on top of them.

mod kernels;
pub mod krylov;
mod operator;
mod ordering;
mod packed;
mod parallelism;
mod solver;
mod square;
mod symmetric;
pub mod vector;

pub use operator::{LinearOperator, SymmetricEntries};
pub use ordering::Ordering;
pub use ordering::error::OrderingError;
pub use packed::PackedLower;
pub use parallelism::Parallelism;
pub use solver::cholesky::{FactorError, SparseCholesky};
pub use solver::{BodySolver, SolverWork, TrailingBlock};
pub use square::{SquareMatrix, SquareReport};
pub use symmetric::SymmetricMatrix;
