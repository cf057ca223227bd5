//! What a load acts on.

use crate::body::Bodies;
use crate::error::ModelError;
use crate::place::{Place, PlaceNames};

/// What a load acts on.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Region {
    /// Surfaces of bodies.
    Surfaces(Vec<Place>),
    /// Whole bodies, by their indices.
    Bodies(Vec<usize>),
}

/// What a kind of load wants to act on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// Surfaces.
    Surfaces,
    /// Bodies; all of them without names.
    Bodies,
}

impl Region {
    pub(super) fn find(
        target: Target,
        names: &PlaceNames,
        bodies: &Bodies,
    ) -> Result<Self, ModelError> {
        let names = names.0.iter();
        match target {
            Target::Surfaces => {
                let surfaces = names.map(|name| bodies.surface(name));
                Ok(Region::Surfaces(surfaces.collect::<Result<_, _>>()?))
            }
            Target::Bodies if names.len() == 0 => Ok(Region::Bodies((0..bodies.len()).collect())),
            Target::Bodies => {
                let indices = names.map(|name| bodies.index(&name.to_string()));
                Ok(Region::Bodies(indices.collect::<Result<_, _>>()?))
            }
        }
    }

    /// The surfaces; none of a load on bodies.
    pub fn surfaces(&self) -> &[Place] {
        match self {
            Region::Surfaces(surfaces) => surfaces,
            Region::Bodies(_) => &[],
        }
    }

    /// The bodies that are loaded as a whole; none of a load on surfaces.
    pub fn bodies(&self) -> &[usize] {
        match self {
            Region::Surfaces(_) => &[],
            Region::Bodies(bodies) => bodies,
        }
    }

    /// Names of the places, as in case files.
    pub fn names(&self, bodies: &Bodies) -> Vec<String> {
        let name = |body: usize| bodies[body].name.as_str();
        let surfaces = self.surfaces().iter();
        let surfaces = surfaces.map(|on| format!("{}.{}", name(on.body), on.set));
        let whole = self.bodies().iter().map(|&body| name(body).to_owned());
        surfaces.chain(whole).collect()
    }
}
