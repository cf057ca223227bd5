//! Problems of others: FCLIB and the text files of Siconos, solved by the methods of this project.
//!
//! The file formats are those of [`tresca_io::fclib`]; here a problem becomes a
//! [`Dual`](tresca_system::matrices::Dual). In the words of the file, u = W r + q with r the contact
//! forces; in ours, r(λ) = Aλ − b. So A is W and b is −q, up to the order: contact by contact in the
//! file, all normals before all tangents in λ. Friction opposes sliding in both, and u_T = −c r_T with
//! c ≥ 0 where a contact slips.
//!
//! Coulomb's law is taken as it is posed, nonassociated: a fixed point on the slip bounds μ r_N. With
//! [`FclibLaw::Tresca`] the bound is the same given force at all contacts.
//!
//! ```
//! use tresca::{Settings, Silent, fclib};
//! use fclib::{FclibLaw, FclibMatrix, FclibProblem, LocalProblem};
//!
//! // A block pressed down with 1 and pulled aside with 2: W = I, u without forces is q.
//! let identity = FclibMatrix::new(3, 3, (0..3).map(|i| (i, i, 1.0)).collect())?;
//! let problem = FclibProblem::Local(LocalProblem {
//!     dimension: 3,
//!     w: identity,
//!     q: vec![-1.0, 2.0, 0.0],
//!     friction: vec![0.5],
//! });
//! let outcome = fclib::solve(&problem, FclibLaw::Coulomb, &Settings::default(), &mut Silent)?;
//! assert!(outcome.solution.status.is_converged());
//! // It slides: friction reaches μ r_N = 0.5, and 1.5 of the velocity is left.
//! for (found, expected) in outcome.forces.iter().zip([1.0, -0.5, 0.0]) {
//!     assert!((found - expected).abs() < 1e-6);
//! }
//! assert!((outcome.velocities[1] - 1.5).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod error;
mod export;
pub(crate) mod law;
pub(crate) mod reduced;
pub(crate) mod residual;
pub(crate) mod solve;

pub use error::FclibProblemError;
pub use export::{document, local_problem};
pub use law::FclibLaw;
pub use reduced::MatrixFacts;
pub use residual::Residuals;
pub use solve::{FclibOutcome, solve};
pub use tresca_io::fclib::{
    Defect, Document, FclibError, FclibFault, FclibMatrix, FclibProblem, GlobalProblem, Info,
    LocalProblem, State, read,
};
