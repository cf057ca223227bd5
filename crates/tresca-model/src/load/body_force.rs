//! Forces per volume.

use tresca_fem::loads;

use super::kind::{ActsAsLoad, add};
use super::region::{Region, Target};
use crate::amount::{Amount, Shape};
use crate::body::Bodies;

/// A force per volume, global components.
#[derive(Debug, Clone)]
pub struct BodyForce {
    /// The force per volume.
    pub value: [f64; 3],
}

impl BodyForce {
    /// The same everywhere.
    pub fn new(value: [f64; 3]) -> Self {
        Self { value }
    }
}

impl ActsAsLoad for BodyForce {
    fn word(&self) -> &'static str {
        "body force"
    }

    fn value_word(&self) -> &'static str {
        "the body force"
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

    fn add_forces(
        &self,
        on: &Region,
        bodies: &Bodies,
        body: usize,
        amount: Amount,
        forces: &mut [f64],
    ) {
        if on.bodies().contains(&body) {
            let force = amount.of_vector(self.value);
            add(1.0, &loads::body_force(&bodies[body].mesh, |_| force), forces);
        }
    }
}
