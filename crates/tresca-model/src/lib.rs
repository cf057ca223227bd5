//! The mechanical model: bodies, supports, loads and contacts, by name, and the load steps.
//!
//! Everything is made by `new` and words that say more, and added by `add_…`, which checks it and finds its names:
//!
//! ```
//! use tresca_contact::FrictionLaw;
//! use tresca_fem::material::Isotropic;
//! use tresca_fem::mesh::{BrickSpec, brick};
//! use tresca_model::{Amount, Body, Contact, Gravity, Model, Step, Support, Traction};
//!
//! let block = |low: f64| BrickSpec { min: [0.0, 0.0, low], max: [2.0, 1.0, low + 1.0], nodes: [5; 3] };
//! let steel = Isotropic::new(2.1e5, 0.3)?;
//!
//! let mut model = Model::new("a block on a block");
//! model.add_body(Body::new("upper", brick(&block(1.0))?, steel).density(7.8e-9))?;
//! model.add_body(Body::new("lower", brick(&block(0.0))?, steel))?;
//! model.add_support(Support::clamp("lower.z-"))?;
//! model.add_support(Support::x(["upper.x+"], 0.001).named("drag"))?;
//! let push = model.add_load(Traction::new([0.0, 0.0, -1.0]).on("upper.z+").named("push"))?;
//! model.add_load(Gravity::new([0.0, 0.0, -9810.0]).on("upper"))?;
//! model.add_contact(Contact::new("upper.z-", "lower.z+", FrictionLaw::coulomb(0.3)))?;
//! model.add_step(Step::new(1.0).with(push, Amount::Factor(0.5)))?;
//! model.add_step(Step::new(2.0).with(push, Amount::Vector([0.0, 0.5, -1.0])))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod amount;
mod body;
mod contact;
mod error;
mod identity;
mod load;
mod model;
mod obstacle;
mod place;
mod step;
mod support;
mod vector_field;

pub use amount::{Amount, Shape};
pub use body::{Bodies, Body};
pub use contact::{Contact, ContactWithin, Nearby, Partner};
pub use error::ModelError;
pub use identity::{ContactId, LoadId, ObstacleId, Quantity, Subject, SupportId};
pub use load::{
    ActsAsLoad, BodyForce, Force, Gravity, Load, LoadKind, Pressure, Region, Share, Target,
    Traction, Traits,
};
pub use model::Model;
pub use obstacle::Obstacle;
pub use place::{Place, PlaceName, PlaceNames};
pub use step::Step;
pub use support::Support;
pub use vector_field::VectorField;
