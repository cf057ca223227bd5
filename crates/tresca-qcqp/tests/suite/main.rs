//! The methods against theory, oracles and each other.
//!
//! One binary for all of them: what they share is compiled and linked once.

mod agreement;
mod common;
mod coulomb;
mod equality;
mod operators;
mod outcomes;
mod sets;
mod singular;
mod tangent;
mod theory;
mod work;
