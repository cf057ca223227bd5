//! The report of a run in figures: what `summary.json` holds and what the terminal shows, the same through every
//! door. docs/summary.md explains each key.

mod contact;
mod contradiction;
mod motion;
mod of_fclib;
mod of_matrices;
mod of_model;
mod posed;
mod reactions;
pub(crate) mod run;
mod system;
mod times;

pub use contact::{ContactReport, ContactResultant};
pub use motion::{BodyMotion, ContactMotion, MotionReport};
pub use posed::{FclibReport, LawReport, Reference};
pub use reactions::SupportReaction;
pub use run::{RunReport, SCHEMA, Source, StepReport};
pub use system::{FactorReport, SystemReport};
pub use times::TimesReport;
