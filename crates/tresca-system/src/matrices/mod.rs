//! The solver for matrices that were assembled elsewhere: K, f, the contact rows N and T, gaps and friction
//! in; displacements, contact forces, the state of every pair and a certificate out.
//!
//! <div>
//! $$\begin{aligned}
//! &amp;K u + N^T \lambda_\nu + T^T \lambda_\tau = f &amp;&amp; \text{equilibrium} \\
//! &amp;N u \le d,\quad \lambda_\nu \ge 0,\quad \lambda_\nu^T (N u - d) = 0 &amp;&amp; \text{no penetration, no adhesion} \\
//! &amp;\|\lambda_{\tau,i}\| \le g_i,\quad \text{slip only at the bound, against } \lambda_\tau &amp;&amp; \text{friction on } T u
//! \end{aligned}$$
//! </div>
//!
//! | | shape | meaning |
//! |---|---|---|
//! | K | n × n, or a list of diagonal blocks | stiffness, symmetric, positive (semi)definite, both triangles |
//! | f | n | load: what pushes along +u |
//! | N | m × n | N u is the approach of the two sides along the normal; positive closes the gap |
//! | T | (d−1)m × n | T u is the slip, rows of a pair adjacent; d = 2 or 3; without it there is no friction |
//! | d | m | gap at u = 0; negative where the sides overlap |
//! | λν | m | normal forces, positive in compression: they act on the bodies by −Nᵀλν |
//! | λτ | (d−1)m | friction forces: they act on the bodies by −Tᵀλτ, against the slip |
//!
//! Units are the caller's: f, λ and slip bounds in one unit of force, u and d in one of length. All
//! bounds are forces of the pair, not stresses. docs/bring-your-own-matrices.md has the same with files.
//!
//! ```
//! use tresca_qcqp::Settings;
//! use tresca_system::matrices::{Matrix, MatrixProblem, PairLaw, solve};
//! use tresca_system::progress::Silent;
//!
//! // A mass on two springs (1 N/m along the normal, 2 N/m along the tangent), 0.5 m above a rough wall.
//! let k = Matrix::from_dense((2, 2), &[1.0, 0.0, 0.0, 2.0])?;
//! let n = Matrix::from_dense((1, 2), &[1.0, 0.0])?;
//! let t = Matrix::from_dense((1, 2), &[0.0, 1.0])?;
//! let problem = MatrixProblem::new(k, n, vec![2.0, 1.0])
//!     .with_tangential(t)
//!     .with_gap(vec![0.5])
//!     .with_friction(PairLaw::coulomb(0.2));
//!
//! let solution = solve(&problem, &Settings::default(), &mut Silent)?;
//! assert!(solution.status.is_converged());
//! // The wall takes 2 − 0.5, friction a fifth of it, and the mass slips.
//! assert!((solution.normal_force[0] - 1.5).abs() < 1e-8);
//! assert!((solution.tangential_force[0] - 0.3).abs() < 1e-8);
//! assert!((solution.slip[0] - 0.35).abs() < 1e-8);
//! assert!(solution.closed[0] && !solution.stick[0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`solve`] does it in one go. [`prepare`] factors once, and [`PreparedProblem::solve`] then takes other loads, gaps
//! and bounds: load steps. [`Dual`] is the same for those who have A, b and the bounds alone.

mod bodies;
mod check;
mod dual;
mod error;
mod friction;
mod grounding;
mod kernel;
mod lengths;
mod matrix;
mod note;
mod operator;
mod parts;
mod patches;
mod prepared;
mod problem;
mod rank;
mod solution;

pub use dual::{Dual, solve_dual};
pub use error::{AlgebraicError, MatrixError};
pub use friction::{Friction, PairLaw};
pub use matrix::{Index, Matrix};
pub use note::{Note, Row};
pub use operator::{Operator, Product};
pub use prepared::{PreparedProblem, prepare, solve};
pub use problem::{Blocks, Conditions, Kernel, MatrixProblem};
pub use solution::{Forces, Solution};
