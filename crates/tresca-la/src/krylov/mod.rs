//! Krylov methods, one file each, all of one shape: reference, record,
//! workspace, method.
//!
//! A preconditioner is a [`LinearOperator`](crate::LinearOperator) that applies
//! the approximate inverse: z = M⁻¹ r. [`Identity`] and [`InverseDiagonal`] are
//! the two simple ones.

pub mod bicgstab;
pub mod cg;
pub mod lanczos;
mod preconditioner;

pub use preconditioner::{Identity, InverseDiagonal};
