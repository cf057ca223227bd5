//! What almost every program that uses this crate names: `use tresca::prelude::*`.

pub use tresca_contact::{CouplingMethod, FrictionLaw, RigidShape, ScalarField};
pub use tresca_fem::assembly::Formulation;
pub use tresca_fem::material::Isotropic;
pub use tresca_fem::mesh::{BrickSpec, CellKind, Mesh, RectangleSpec, Space, brick, rectangle};
pub use tresca_model::{
    Amount, Body, BodyForce, Contact, Force, Gravity, Model, Obstacle, Pressure, Step, Support,
    Traction, VectorField,
};
pub use tresca_qcqp::{CoulombMethod, Engine, Method, Settings, Status};
pub use tresca_system::progress::{Progress, Silent, Stage, Stopped};

pub use crate::outcome::{Outcome, StepOutcome};
pub use crate::pair_state::PairState;
