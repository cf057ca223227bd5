//! Contact with Tresca friction between linear elastic bodies.
//!
//! A [`Model`] (bodies, supports, loads, contacts; built by hand or read by [`case::Case`])
//! goes into [`solve`] together with [`Settings`]; out comes an [`Outcome`]: displacements,
//! the state of every contact pair, the iteration history, and a [`Certificate`] that was computed
//! from the displacements and forces alone.
//!
//! ```
//! use tresca::{FrictionLaw, Model, Run, Settings, Silent, SurfaceRef, solve};
//! use tresca::mesh::{BrickSpec, brick};
//! use tresca::material::Isotropic;
//!
//! let block = |low: f64| BrickSpec { min: [0.0, 0.0, low], max: [2.0, 1.0, low + 1.0], nodes: [5; 3] };
//! let steel = Isotropic::new(2.1e5, 0.3)?;
//! let face = |body, faces| SurfaceRef { body, faces };
//!
//! let mut model = Model::new("a block on a block");
//! model.add_body("upper", brick(&block(1.0))?, steel)?;
//! model.add_body("lower", brick(&block(0.0))?, steel)?;
//! model.clamp(face("upper", "x+"))?.clamp(face("lower", "z-"))?;
//! model.add_traction(&[face("upper", "z+")], [0.0, 0.0, -1.0])?;
//! model.add_contact(face("upper", "z-"), face("lower", "z+"), FrictionLaw::tresca(0.1))?;
//!
//! let Run::Finished(outcome) = solve(&model, &Settings::default(), &mut Silent)? else {
//!     unreachable!("nobody stops this run")
//! };
//! assert!(outcome.converged());
//! assert!(outcome.last().certificate.worst() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod algebraic;
pub mod assemble;
pub mod case;
pub mod certificate;
mod check;
pub mod dual;
mod elastic;
mod ellipse;
mod error;
pub mod fclib;
mod floating;
mod layout;
pub mod linear;
mod load_step;
mod measures;
pub mod memory;
mod outcome;
pub mod output;
pub mod progress;
pub mod report;
mod solve;
pub mod two_bricks;

pub use certificate::Certificate;
pub use check::{BodyCheck, Check, ContactCheck, LoadCheck, SupportCheck, check};
pub use error::SolveError;
pub use floating::{Floating, UnresistedMotion};
pub use layout::Layout;
pub use load_step::Acting;
pub use outcome::surface_fields::SurfaceFields;
pub use outcome::{Outcome, PairState, StepOutcome, Times};
pub use progress::{Progress, Silent, Stage};
pub use report::RunReport;
pub use solve::{Description, Prepared, Run, prepare, solve};
pub use tresca_model::{self as model, Model, ModelError, SurfaceRef};
pub use two_bricks::two_bricks;

pub use tresca_contact::{CouplingMethod, Field, Frame, FrictionLaw, Obstacle, Sliding};
pub use tresca_fem::assembly::Formulation;
pub use tresca_fem::{material, mesh, rigid};
pub use tresca_qcqp::{
    CoulombMethod, Engine, InnerSolver, IterationRecord, Method, OptionInfo, Settings, StateCounts,
    Status,
};

/// Version of the library, written into every result file.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
