//! Linear algebra for `tresca`: vectors, symmetric sparse matrices, orderings,
//! sparse Cholesky with a trailing (Schur) block, and Krylov methods.
//!
//! Storage and kernels are faer's; what lives here is what the contact problem
//! needs on top of them.

pub mod krylov;
mod operator;
mod symmetric;
pub mod vector;

pub use operator::LinearOperator;
pub use symmetric::SymmetricMatrix;
