//! Total forces.

use tresca_fem::loads;

use super::kind::{ActsAsLoad, add};
use super::region::{Region, Target};
use crate::amount::{Amount, Shape};
use crate::body::Bodies;

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
    fn word(&self) -> &'static str {
        "force"
    }

    fn value_word(&self) -> &'static str {
        "the force"
    }

    fn target(&self) -> Target {
        Target::Surfaces
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
        let area: f64 = on
            .surfaces()
            .iter()
            .flat_map(|on| loads::nodal_areas(&bodies[on.body].mesh, bodies.faces(on)))
            .sum();
        let traction = amount.of_vector(self.value).map(|force| force / area);
        let mesh = &bodies[body].mesh;
        for surface in on.surfaces_of(body) {
            let part = loads::traction(mesh, bodies.faces(surface), traction);
            add(1.0, &part, forces);
        }
    }
}
