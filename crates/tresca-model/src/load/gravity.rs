//! Weight.

use tresca_fem::loads;

use super::kind::{ActsAsLoad, add};
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
    fn word(&self) -> &'static str {
        "gravity"
    }

    fn value_word(&self) -> &'static str {
        "the acceleration"
    }

    fn target(&self) -> Target {
        Target::Bodies
    }

    fn shape(&self) -> Shape {
        Shape::Vector
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

    fn add_forces(
        &self,
        on: &Region,
        bodies: &Bodies,
        body: usize,
        amount: Amount,
        forces: &mut [f64],
    ) {
        if on.bodies().contains(&body) {
            let density = bodies[body].density.unwrap_or(0.0);
            let force = amount.of_vector(self.value).map(|g| density * g);
            add(1.0, &loads::body_force(&bodies[body].mesh, |_| force), forces);
        }
    }
}
