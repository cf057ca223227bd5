//! Rigid obstacles.

mod analytic;
pub(crate) mod couple;
pub(crate) mod shape;
