//! Forces per volume.

use super::kind::{ActsAsLoad, Share, Traits};
use super::region::Target;
use crate::amount::{Amount, Shape};

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
    fn traits(&self) -> Traits {
        Traits {
            word: "body force",
            value_word: "the body force",
            target: Target::Bodies,
            shape: Shape::Vector,
        }
    }

    fn constant(&self) -> Option<Amount> {
        Some(Amount::Vector(self.value))
    }

    fn add_forces(&self, share: &Share<'_>, amount: Amount, forces: &mut [f64]) {
        share.add_body_force(amount.of_vector(self.value), forces);
    }
}
