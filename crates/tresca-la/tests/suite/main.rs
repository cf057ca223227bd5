//! Factorisation and Krylov methods against dense linear algebra.
//!
//! One binary for all of them: what they share is compiled and linked once.

mod body_solvers;
mod cholesky;
mod common;
mod krylov;
