//! The dual operator A = B K⁻¹ Bᵀ and its engines.
//!
//! | engine | one multiplication | set-up |
//! |---|---|---|
//! | [`Factored`] | one solve with K, whatever the [`BodySolver`](tresca_la::BodySolver) | none beyond the solver |
//! | [`Condensed`] | two triangular solves with the trailing block | contact dofs ordered last |
//! | [`Dense`] | one symmetric matrix–vector product | the matrix, formed once |

mod bodies;
mod condensed;
pub(crate) mod coupling;
pub(crate) mod dense;
pub(crate) mod dual_operator;
mod factored;
pub mod groups;
pub(crate) mod local_model;

pub use condensed::Condensed;
pub use coupling::Coupling;
pub use dense::Dense;
pub use dual_operator::{DualOperator, Tally};
pub use factored::Factored;
pub use local_model::{LocalBlock, LocalModel};
