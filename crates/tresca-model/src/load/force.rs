//! Total forces.

use tresca_fem::loads;

use super::kind::{ActsAsLoad, Share, Traits, add};
use super::region::Target;
use crate::amount::{Amount, Shape};

/// A force, spread evenly over all its surfaces: on each area it is the traction force / total undeformed area. Global
/// components; in the plane per unit thickness, in an axisymmetric space that of the whole circumference.
#[derive(Debug, Clone)]
pub struct Force {
    /// The total force.
    pub value: [f64; 3],
}

impl Force {
    /// That acts on all surfaces together.
    pub fn new(value: [f64; 3]) -> Self {
        Self { value }
    }
}

impl ActsAsLoad for Force {
    fn traits(&self) -> Traits {
        Traits {
            word: "force",
            value_word: "the force",
            target: Target::Surfaces,
            shape: Shape::Vector,
        }
    }

    fn constant(&self) -> Option<Amount> {
        Some(Amount::Vector(self.value))
    }

    fn add_forces(&self, share: &Share<'_>, amount: Amount, forces: &mut [f64]) {
        let area = share.total_area();
        let traction = amount.of_vector(self.value).map(|force| force / area);
        for faces in share.surfaces() {
            add(1.0, &loads::traction(share.mesh(), faces, traction), forces);
        }
    }
}
