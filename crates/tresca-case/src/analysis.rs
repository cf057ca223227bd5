//! What the coordinates of a case mean.

use serde::Deserialize;
use tresca_fem::mesh::Space;

/// `analysis`: what the coordinates of a case mean, and how many there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case", expecting = "the name of an analysis")]
pub enum Analysis {
    /// Bodies in space.
    #[default]
    Solid,
    /// Slices of long bodies, of unit thickness; no strain across the plane.
    PlaneStrain,
    /// Thin sheets, of unit thickness; no stress across the plane.
    PlaneStress,
    /// Bodies of revolution: x is the radius, y the axis; forces are those of the whole circumference.
    Axisymmetric,
}

impl Analysis {
    /// Number of coordinates: 3 in space, otherwise 2.
    pub fn dimension(self) -> usize {
        self.space().dimension()
    }

    /// What bodies live in.
    pub fn space(self) -> Space {
        match self {
            Analysis::Solid => Space::Solid,
            Analysis::PlaneStrain | Analysis::PlaneStress => Space::Plane,
            Analysis::Axisymmetric => Space::Axisymmetric,
        }
    }

    /// The word that stands for it in a case file.
    pub fn word(self) -> &'static str {
        match self {
            Analysis::Solid => "solid",
            Analysis::PlaneStrain => "plane_strain",
            Analysis::PlaneStress => "plane_stress",
            Analysis::Axisymmetric => "axisymmetric",
        }
    }
}
