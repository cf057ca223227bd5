//! What every kind of load says of itself.

use std::fmt::Debug;

use tresca_fem::loads;
use tresca_fem::mesh::{Face, Mesh};

use super::region::{Region, Target};
use crate::amount::{Amount, Shape};
use crate::body::Bodies;
use crate::error::ModelError;

/// A kind of load in words and shapes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Traits {
    /// The word for it in reports, as in "the *traction* on `lower.z+` is not finite".
    pub word: &'static str,
    /// What its value is called, with its article.
    pub value_word: &'static str,
    /// What it acts on.
    pub target: Target,
    /// What load steps can put in the place of its value.
    pub shape: Shape,
}

/// A kind of load: what acts, apart from where.
pub trait ActsAsLoad: Debug {
    /// What it is.
    fn traits(&self) -> Traits;

    /// Its value where it is the same everywhere: of its [`Traits::shape`].
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
    fn add_forces(&self, share: &Share<'_>, amount: Amount, forces: &mut [f64]);
}

/// The share that a body has of a load.
#[derive(Debug, Clone, Copy)]
pub struct Share<'m> {
    /// Where the load acts.
    pub on: &'m Region,
    /// All bodies.
    pub bodies: &'m Bodies,
    /// Index of the body.
    pub body: usize,
}

impl<'m> Share<'m> {
    /// The mesh of the body.
    pub fn mesh(&self) -> &'m Mesh {
        &self.bodies[self.body].mesh
    }

    /// The loaded surfaces of the body.
    pub fn surfaces(&self) -> impl Iterator<Item = &'m [Face]> {
        let (bodies, body) = (self.bodies, self.body);
        let own = self.on.surfaces().iter().filter(move |on| on.body == body);
        own.map(move |on| bodies.faces(on))
    }

    /// Whether the body is loaded as a whole.
    pub fn is_whole(&self) -> bool {
        self.on.bodies().contains(&self.body)
    }

    /// The area of the loaded surfaces of all bodies.
    pub fn total_area(&self) -> f64 {
        let surfaces = self.on.surfaces().iter();
        surfaces
            .flat_map(|on| loads::nodal_areas(&self.bodies[on.body].mesh, self.bodies.faces(on)))
            .sum()
    }

    /// forces ← forces + the force per volume, where the body is loaded as a whole.
    pub(super) fn add_body_force(&self, per_volume: [f64; 3], forces: &mut [f64]) {
        if self.is_whole() {
            add(1.0, &loads::body_force(self.mesh(), |_| per_volume), forces);
        }
    }
}

/// forces ← forces + factor · part.
pub(super) fn add(factor: f64, part: &[f64], forces: &mut [f64]) {
    for (force, part) in forces.iter_mut().zip(part) {
        *force += factor * part;
    }
}
