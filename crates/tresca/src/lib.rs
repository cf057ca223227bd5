//! Contact with Tresca friction between linear elastic bodies.
//!
//! A [`Model`] (bodies, supports, loads, contacts; built by hand or read by [`case::Case`])
//! goes into [`solve`] together with [`Settings`]; out comes an [`Outcome`]: displacements,
//! the state of every contact pair, the iteration history, and a [`Certificate`] that was computed
//! from the displacements and forces alone.
//!
//! ```
//! use tresca::{FrictionLaw, Model, SurfaceRef};
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
//! let outcome = tresca::solve(&model)?;
//! assert!(outcome.converged());
//! assert!(outcome.last().certificate.worst() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod algebraic;
pub mod assemble;
mod balance;
pub mod case;
mod check;
mod error;
pub mod fclib;
mod floating;
mod load_step;
pub mod memory;
mod outcome;
pub mod output;
mod pair_state;
mod reactions;
mod solve;
mod summary;
mod surface_fields;

pub use check::{BodyCheck, Check, ContactCheck, LoadCheck, SupportCheck, check};
pub use error::SolveError;
pub use floating::UnresistedMotion;
pub use load_step::Acting;
pub use outcome::{Outcome, StepOutcome};
pub use pair_state::PairState;
pub use reactions::SupportReaction;
pub use solve::{PreparedModel, factor_error, prepare, solve, solve_with};
pub use summary::Summary;
pub use surface_fields::SurfaceFields;

pub use tresca_contact::{CouplingMethod, Field, Frame, FrictionLaw, Obstacle, Sliding};
pub use tresca_fem::assembly::Formulation;
pub use tresca_fem::{material, mesh, rigid};
pub use tresca_model::{self as model, Model, ModelError, SurfaceRef};
pub use tresca_qcqp::{
    CoulombMethod, DualSolution, Engine, Figures, InnerSolver, IterationRecord, Method, OptionInfo,
    Settings, StateCounts, Status, record,
};
pub use tresca_system::certificate::{self, Certificate};
pub use tresca_system::description::{Description, Times};
pub use tresca_system::engine::EngineChoice;
pub use tresca_system::factors::{FactorWork, Factors};
pub use tresca_system::layout::Layout;
pub use tresca_system::progress::{self, Progress, Silent, Stage, StepInfo, Stopped};

/// Version of the library, written into every result file.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
