//! Pressures.

use tresca_contact::ScalarField;
use tresca_fem::loads;

use super::kind::{ActsAsLoad, Share, Traits, add};
use super::region::{Region, Target};
use crate::amount::{Amount, Shape};
use crate::body::Bodies;
use crate::error::ModelError;

/// A force per area against the surface; positive presses on the body.
#[derive(Debug, Clone)]
pub struct Pressure {
    /// The pressure: a constant, or a function of the undeformed position.
    pub value: ScalarField,
}

impl Pressure {
    /// The same everywhere, or a function of the undeformed position.
    pub fn new(value: impl Into<ScalarField>) -> Self {
        let value = value.into();
        Self { value }
    }
}

impl ActsAsLoad for Pressure {
    fn traits(&self) -> Traits {
        Traits {
            word: "pressure",
            value_word: "the pressure",
            target: Target::Surfaces,
            shape: Shape::Scalar,
        }
    }

    fn constant(&self) -> Option<Amount> {
        match self.value {
            ScalarField::Constant(value) => Some(Amount::Scalar(value)),
            _ => None,
        }
    }

    fn check(&self, _: &Region, _: &Bodies) -> Result<(), ModelError> {
        match self.value {
            ScalarField::Values(_) => Err(ModelError::PressureByValues),
            _ => Ok(()),
        }
    }

    fn add_forces(&self, share: &Share<'_>, amount: Amount, forces: &mut [f64]) {
        let own = |x| match &self.value {
            ScalarField::Constant(value) => *value,
            ScalarField::Function(function) => function(x),
            // `check` refuses it.
            ScalarField::Values(_) => f64::NAN,
        };
        let (factor, value) = match amount {
            Amount::Factor(factor) => (factor, None),
            value => (1.0, Some(value.of_scalar(0.0))),
        };
        for faces in share.surfaces() {
            let pressure = |x| value.unwrap_or_else(|| own(x));
            add(factor, &loads::pressure_field(share.mesh(), faces, pressure), forces);
        }
    }
}
