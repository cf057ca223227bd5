//! The equality constraint Gλ = e: equilibrium of bodies that float.
//!
//! A body without enough supports has rigid motions R; G = RᵀBᵀ maps contact forces to their
//! resultants, e = Rᵀf are the resultants of the loads, and the multiplier α of the constraint is
//! the motion itself. The operator contains GᵀSG, so that q is the augmented Lagrangian.

pub(crate) mod attainable;
pub(crate) mod balance;
mod compliance;
mod conic;
mod dual_ascent;
mod equilibrium;
pub(crate) mod first_guess;
mod foundation;
pub(crate) mod multiplier;
mod statics;

pub use balance::Equality;
pub use statics::Statics;
