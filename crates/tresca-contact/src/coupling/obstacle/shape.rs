//! The shapes of rigid obstacles.

use tresca_fem::mesh::CellKind;

/// A rigid obstacle.
///
/// In the plane (and in the meridian section of an axisymmetric space) a plane is a line, spheres and
/// cylinders are circles; the axis of such a cylinder is the z axis.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum RigidShape {
    /// The half-space behind a plane.
    Plane {
        /// A point of the plane.
        point: [f64; 3],
        /// Direction out of the obstacle, of any length.
        normal: [f64; 3],
    },
    /// A ball, or everything but a ball.
    Sphere {
        /// The centre.
        center: [f64; 3],
        /// The radius.
        radius: f64,
        /// Is the body in a spherical cavity?
        inside: bool,
    },
    /// A round bar of infinite length, or everything around a round hole.
    Cylinder {
        /// A point of the axis.
        point: [f64; 3],
        /// Direction of the axis, of any length.
        axis: [f64; 3],
        /// The radius.
        radius: f64,
        /// Is the body in the hole?
        inside: bool,
    },
    /// A surface of faces.
    Surface(RigidSurface),
}

/// The surface of an obstacle as faces.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidSurface {
    /// Points; the third coordinate is zero in the plane.
    pub points: Vec<[f64; 3]>,
    /// Faces with their nodes (numbers of points), counter-clockwise as seen from outside of the
    /// obstacle. In the plane lines, with the outside on the right.
    pub faces: Vec<(CellKind, Vec<usize>)>,
}
