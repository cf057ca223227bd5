//! Friction laws, as the user states them.

use crate::ContactError;

/// The friction law of a contact surface.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum FrictionLaw {
    /// Tresca's law: the tangential traction stays below a bound that is given beforehand and
    /// does not know the contact pressure.
    Tresca {
        /// Slip bound as a stress (force per area) ≥ 0; 0 is the frictionless contact.
        bound: f64,
    },
}

impl FrictionLaw {
    /// The slip bound of a pair *as a force*: g_i = ∫ g φ_i for a pair of area ∫ φ_i.
    ///
    /// # Errors
    /// [`ContactError::SlipBound`] when the bound is negative or not finite.
    pub fn slip_bound(&self, area: f64) -> Result<f64, ContactError> {
        match *self {
            FrictionLaw::Tresca { bound } if bound.is_finite() && bound >= 0.0 => Ok(bound * area),
            FrictionLaw::Tresca { bound } => Err(ContactError::SlipBound { bound }),
        }
    }
}
