//! Contact as linear algebra: the floor on which every door meets.
//!
//! | module | what it has |
//! |---|---|
//! | [`body`] | a body as K, its grounding, its share of B |
//! | [`factors`] | K⁻¹ of all bodies; displacements from forces |
//! | [`layout`] | where every pair stands in λ, and which convex sets its law becomes |
//! | [`engine`] | how A is applied, and why so |
//! | [`load_case`] | what acts in one solve: loads, gaps, laws, the slip of the step before |
//! | [`prepared`] | bodies that are factored and posed as a dual problem; solved as often as need be |
//! | [`solved`] | forces, displacements, states and certificate of a solve |
//! | [`certificate`] | is this a solution? |
//! | [`matrices`] | problems of matrices alone, checked at the door: K, B and laws, or A and b |
//! | [`progress`] | what a run tells while it goes on, and how it is stopped |

pub mod body;
pub mod certificate;
pub mod contradiction;
pub mod description;
mod ellipse;
pub mod engine;
pub mod factors;
mod judge;
pub mod layout;
pub mod load_case;
pub mod matrices;
mod measures;
pub mod prepared;
pub mod progress;
pub mod run;
pub mod solved;
mod tame;
mod units;
