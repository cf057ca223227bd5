//! What kind of body a mesh describes.

use std::fmt;

/// The space that a mesh lives in, and with it the meaning of every measure taken on the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// A body in space; components x, y, z.
    Solid,
    /// A plane body in the xy plane; components x, y. Every measure is per unit thickness: areas
    /// stand for volumes, lengths for areas, forces are forces per thickness. Plane strain or plane
    /// stress is the material's choice (see [`crate::material::Isotropic::plane_stress`]).
    Plane,
    /// A body of revolution without torsion, given by its meridian section: x is the radius
    /// (not negative), y runs along the axis; components radial and axial. Every measure is that of
    /// the full circumference, so that volumes are volumes and forces are forces.
    Axisymmetric,
}

impl Space {
    /// Dimension of the mesh, 2 or 3: the number of coordinates and of displacement components.
    pub fn dimension(self) -> usize {
        match self {
            Space::Solid => 3,
            Space::Plane | Space::Axisymmetric => 2,
        }
    }

    /// What a length or area of the mesh at a point is multiplied by to become the measure of the
    /// body: the circumference 2πr in an axisymmetric space, 1 otherwise.
    #[inline]
    pub fn circumference(self, point: [f64; 3]) -> f64 {
        match self {
            Space::Solid | Space::Plane => 1.0,
            Space::Axisymmetric => 2.0 * std::f64::consts::PI * point[0],
        }
    }
}

impl fmt::Display for Space {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Space::Solid => "solid",
            Space::Plane => "plane",
            Space::Axisymmetric => "axisymmetric",
        })
    }
}
