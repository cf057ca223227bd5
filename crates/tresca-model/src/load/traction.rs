//! Tractions.

use tresca_fem::loads;

use super::kind::{ActsAsLoad, add};
use super::region::{Region, Target};
use crate::amount::{Amount, Shape};
use crate::body::Bodies;
use crate::vector_field::VectorField;

/// A force per area of the undeformed surface, global components.
#[derive(Debug, Clone)]
pub struct Traction {
    /// The traction.
    pub value: VectorField,
}

impl Traction {
    /// The same everywhere, or a function of the undeformed position.
    pub fn new(value: impl Into<VectorField>) -> Self {
        let value = value.into();
        Self { value }
    }
}

impl ActsAsLoad for Traction {
    fn word(&self) -> &'static str {
        "traction"
    }

    fn value_word(&self) -> &'static str {
        "the traction"
    }

    fn target(&self) -> Target {
        Target::Surfaces
    }

    fn shape(&self) -> Shape {
        Shape::Vector
    }

    fn constant(&self) -> Option<Amount> {
        self.value.constant().map(Amount::Vector)
    }

    fn add_forces(
        &self,
        on: &Region,
        bodies: &Bodies,
        body: usize,
        amount: Amount,
        forces: &mut [f64],
    ) {
        let mesh = &bodies[body].mesh;
        for surface in on.surfaces_of(body) {
            let faces = bodies.faces(surface);
            match (amount, &self.value) {
                (Amount::Factor(factor), VectorField::Constant(own)) => {
                    add(factor, &loads::traction(mesh, faces, *own), forces);
                }
                (Amount::Factor(factor), VectorField::Function(own)) => {
                    add(factor, &loads::traction_field(mesh, faces, |x| own(x)), forces);
                }
                (value, _) => {
                    let value = value.of_vector([0.0; 3]);
                    add(1.0, &loads::traction(mesh, faces, value), forces);
                }
            }
        }
    }
}
