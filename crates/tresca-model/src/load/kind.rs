//! What every kind of load says of itself.

use std::fmt::Debug;

use crate::amount::{Amount, Shape};
use crate::body::Bodies;
use crate::error::ModelError;

use super::region::{Region, Target};

/// A kind of load: what acts, apart from where.
pub trait ActsAsLoad: Debug {
    /// The word for it in reports, as in "the *traction* on `lower.z+` is not finite".
    fn word(&self) -> &'static str;

    /// What its value is called, with its article.
    fn value_word(&self) -> &'static str;

    /// What it acts on.
    fn target(&self) -> Target;

    /// What load steps can put in the place of its value.
    fn shape(&self) -> Shape;

    /// Its value where it is the same everywhere: of its [`ActsAsLoad::shape`].
    fn constant(&self) -> Option<Amount>;

    /// Refuses what makes no sense on these bodies. Values that are constant and not finite, or leave the plane, are
    /// refused beforehand.
    ///
    /// # Errors
    /// When the load cannot act there.
    fn check(&self, on: &Region, bodies: &Bodies) -> Result<(), ModelError> {
        let _ = (on, bodies);
        Ok(())
    }

    /// Adds an amount of the load to the forces at the dofs of a body, held ones too. Where an expression gives no
    /// number, they become NaN or infinite.
    fn add_forces(
        &self,
        on: &Region,
        bodies: &Bodies,
        body: usize,
        amount: Amount,
        forces: &mut [f64],
    );
}

/// forces ← forces + factor · part.
pub(super) fn add(factor: f64, part: &[f64], forces: &mut [f64]) {
    for (force, part) in forces.iter_mut().zip(part) {
        *force += factor * part;
    }
}
