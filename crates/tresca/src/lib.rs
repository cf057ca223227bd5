//! Contact with Tresca friction between linear elastic bodies.
//!
//! A [`Model`] (bodies, supports, loads, contacts; built by hand or read by [`case::Case`])
//! goes into [`solve`] together with [`Settings`]; out comes an [`Outcome`]: displacements,
//! the state of every contact pair, the iteration history, and a [`Certificate`] that was computed
//! from the displacements and forces alone.
//!
//! ```
//! use tresca::{Body, Contact, FrictionLaw, Model, Support, Traction};
//! use tresca::mesh::{BrickSpec, brick};
//! use tresca::material::Isotropic;
//!
//! let block = |low: f64| BrickSpec { min: [0.0, 0.0, low], max: [2.0, 1.0, low + 1.0], nodes: [5; 3] };
//! let steel = Isotropic::new(2.1e5, 0.3)?;
//!
//! let mut model = Model::new("a block on a block");
//! model.add_body(Body::new("upper", brick(&block(1.0))?, steel))?;
//! model.add_body(Body::new("lower", brick(&block(0.0))?, steel))?;
//! model.add_support(Support::clamp(["upper.x+", "lower.z-"]))?;
//! model.add_load(Traction::new([0.0, 0.0, -1.0]).on("upper.z+"))?;
//! model.add_contact(Contact::new("upper.z-", "lower.z+", FrictionLaw::tresca(0.1)))?;
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
pub mod prelude;
pub mod report;
mod solve;
mod unresisted;
mod version;

pub use check::{BodyCheck, Check, ContactCheck, LoadCheck, SupportCheck, check};
pub use error::SolveError;
pub use load_step::Acting;
pub use outcome::surface_fields::SurfaceFields;
pub use outcome::{Outcome, StepOutcome};
pub use pair_state::PairState;
pub use report::RunReport;
pub use solve::{PreparedModel, factor_error, prepare, solve, solve_with};
pub use unresisted::UnresistedMotion;

pub use tresca_contact::{CouplingMethod, Frame, FrictionLaw, RigidShape, ScalarField, Sliding};
pub use tresca_fem::assembly::Formulation;
pub use tresca_fem::{material, mesh, rigid};
pub use tresca_model::{self as model, Body, Contact, Model, ModelError, Step, Support, Traction};
pub use tresca_qcqp::{
    CoulombMethod, DualProblem, DualSolution, Engine, Figures, InnerSolver, IterationRecord,
    Method, OptionInfo, Settings, StateCounts, Status, record,
};
pub use tresca_system::certificate::{self, Certificate};
pub use tresca_system::description::{Description, EngineChoice, Times};
pub use tresca_system::factors::{FactorWork, Factors};
pub use tresca_system::layout::Layout;
pub use tresca_system::progress::{self, Progress, Silent, Stage, StepInfo, Stopped};
pub use tresca_system::{self as system};
pub use version::VERSION;
