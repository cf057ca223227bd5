//! Weight.

use super::kind::{ActsAsLoad, Share, Traits};
use super::region::{Region, Target};
use crate::amount::{Amount, Shape};
use crate::body::Bodies;
use crate::error::ModelError;

/// Weight: density × acceleration. It acts on bodies that have a density.
#[derive(Debug, Clone)]
pub struct Gravity {
    /// The acceleration, global components.
    pub value: [f64; 3],
}

impl Gravity {
    /// By the acceleration of the field of gravity, downwards.
    pub fn new(value: [f64; 3]) -> Self {
        Self { value }
    }
}

impl ActsAsLoad for Gravity {
    fn traits(&self) -> Traits {
        Traits {
            word: "gravity",
            value_word: "the acceleration",
            target: Target::Bodies,
            shape: Shape::Vector,
        }
    }

    fn constant(&self) -> Option<Amount> {
        Some(Amount::Vector(self.value))
    }

    fn check(&self, on: &Region, bodies: &Bodies) -> Result<(), ModelError> {
        let heavy = on.bodies().iter().map(|&body| &bodies[body]);
        match heavy.into_iter().find(|body| body.density.is_none()) {
            None => Ok(()),
            Some(body) => Err(ModelError::NoDensity {
                body: body.name.clone(),
            }),
        }
    }

    fn add_forces(&self, share: &Share<'_>, amount: Amount, forces: &mut [f64]) {
        let density = share.bodies[share.body].density.unwrap_or(0.0);
        let force = amount.of_vector(self.value).map(|g| density * g);
        share.add_body_force(force, forces);
    }
}
