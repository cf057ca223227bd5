//! Coulomb's law: slip bounds that follow from the normal forces.
//!
//! g(λ) = min(F max(λν, 0), limit). A λ solves the problem with friction by Coulomb when it solves
//! the one with the frozen bounds g = g(λ). The bounds are found by problems with frozen bounds one
//! after another ([`fixed_point`]), or follow λ inside of the Newton loop ([`in_loop`]). Where neither gets there,
//! contacts are solved one by one ([`sweeps`]).

mod exact;
mod fixed_point;
pub(crate) mod frictional;
mod history;
mod in_loop;
pub(crate) mod law;
mod local;
pub(crate) mod solve;
mod sweeps;

pub use law::CoulombBound;
