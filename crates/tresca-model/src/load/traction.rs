//! Tractions.

use tresca_fem::loads;

use super::kind::{ActsAsLoad, Share, Traits, add};
use super::region::Target;
use crate::amount::{Amount, Shape};
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
    fn traits(&self) -> Traits {
        Traits {
            word: "traction",
            value_word: "the traction",
            target: Target::Surfaces,
            shape: Shape::Vector,
        }
    }

    fn constant(&self) -> Option<Amount> {
        self.value.constant().map(Amount::Vector)
    }

    fn add_forces(&self, share: &Share<'_>, amount: Amount, forces: &mut [f64]) {
        for faces in share.surfaces() {
            let (factor, part) = match (amount, &self.value) {
                (Amount::Factor(factor), VectorField::Constant(own)) => {
                    (factor, loads::traction(share.mesh(), faces, *own))
                }
                (Amount::Factor(factor), VectorField::Function(own)) => {
                    (factor, loads::traction_field(share.mesh(), faces, |x| own(x)))
                }
                (value, _) => {
                    let value = value.of_vector([0.0; 3]);
                    (1.0, loads::traction(share.mesh(), faces, value))
                }
            };
            add(factor, &part, forces);
        }
    }
}
