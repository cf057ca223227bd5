//! The dual contact problem and the methods that solve it.
//!
//! <div>
//! $$
//! \min_{\lambda \in \Lambda}\; q(\lambda) = \tfrac12 \lambda^T A \lambda - \lambda^T b
//! $$
//! </div>
//!
//! with Λ a product of lines, half-lines, intervals and discs, and A symmetric positive (semi)definite and known by its products alone.
//! Nothing here knows a mesh: a matrix from a file is as good as two bricks.
//!
//! - [`DualProblem`] holds the operator A, the right-hand side b and the set Λ ([`ProductSet`]).
//! - [`operator`]: the [`DualOperator`] trait, which counts the multiplications n_A, and its engines.
//! - [`solve`] runs the [`Method`] named in [`Settings`], tells an [`Observer`] about every
//!   iteration and returns a [`DualSolution`] whose [`Status`] says how it ended.
//!
//! A problem may have more to it:
//!
//! - [`DualProblem::with_equality`]: Gλ = e, the equilibrium of bodies that float ([`Equality`]);
//! - [`DualProblem::with_coulomb`]: slip bounds that follow from normal forces ([`CoulombBound`]).
//!
//! Then problems of the plain kind are solved one after another, on the same A, of which
//! everything learnt is kept, also from one call of [`solve`] to the next.
//!
//! All methods start, measure and stop alike: the reported figure is
//! ‖r̃(λ)‖/‖r̃(0)‖ at a feasible λ, with the reduced gradient
//!
//! <div>
//! $$
//! \tilde r(\lambda) = \tfrac1\rho \bigl(\lambda - P_\Lambda(\lambda - \rho\, r(\lambda))\bigr), \qquad r(\lambda) = A\lambda - b,
//! $$
//! </div>
//!
//! P_Λ the projection and ρ = 1/σmax, σmax estimated by a few Lanczos steps.
//!
//! ```
//! use tresca_la::PackedLower;
//! use tresca_qcqp::{DualProblem, ProductSet, Settings, Unobserved, operator::Dense, solve};
//!
//! // One pair with slip bound 1 and A = I: the solution is the projection of b.
//! let mut a = PackedLower::zeros(3);
//! (0..3).for_each(|i| a.set(i, i, 1.0));
//! let set = ProductSet::contact_3d(&[1.0])?;
//! let mut problem = DualProblem::new(Dense::new(a), vec![2.0, 3.0, 4.0], set)?;
//! let solution = solve(&mut problem, &Settings::default(), None, &mut Unobserved)?;
//!
//! assert!(solution.status.is_converged());
//! for (found, expected) in solution.lambda.iter().zip([2.0, 0.6, 0.8]) {
//!     assert!((found - expected).abs() < 1e-8);
//! }
//! # Ok::<(), tresca_qcqp::QcqpError>(())
//! ```
//!
//! # Symbols
//!
//! | in the code | meaning |
//! |---|---|
//! | `lambda`, `gradient` | λ and r(λ) = Aλ − b |
//! | `y` | λ − ρ r(λ), the point that is projected and whose place decides the active set |
//! | `rho`, `sigma` | ρ and (an upper estimate of) σmax, the largest eigenvalue of A |
//! | `alpha`, `beta` | multiplier α of Gλ = e, and the same in coordinates where the metric S is the identity |
//! | `n_a` | number of multiplications by A |
//! | `s`, `Z`, `C` | unknowns, basis and curvature of the reduced Newton system (ZᵀAZ + C) s = −Zᵀ(Ax − b) |

mod active_set;
mod coulomb;
mod equality;
mod error;
mod figures;
mod inner_problem;
mod inner_solve;
mod methods;
mod newton;
mod observe;
pub mod operator;
mod point;
mod problem;
pub mod record;
mod session;
pub mod sets;
mod settings;
mod singular;
mod solution;
mod solve;
mod spectrum;
mod start;
mod status;

pub use active_set::{ActiveSet, StateCounts};
pub use coulomb::CoulombBound;
pub use equality::{Equality, Statics};
pub use error::QcqpError;
pub use figures::Figures;
pub use newton::tangent::Tangent;
pub use observe::{Observer, Unobserved};
pub use operator::{DualOperator, Tally};
pub use problem::DualProblem;
pub use record::IterationRecord;
pub use sets::ProductSet;
pub use settings::{CoulombMethod, Engine, InnerSolver, Method, OptionInfo, Settings};
pub use solution::DualSolution;
pub use solve::solve;
pub use start::Start;
pub use status::Status;
