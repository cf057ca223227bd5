//! What can be wrong with the geometry of a contact.

/// Why two surfaces could not be coupled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// The two surfaces do not have the same number of nodes.
    #[error(
        "the two surfaces do not match node by node: the slave has {slave} nodes, the master {master}"
    )]
    NodeCounts {
        /// Nodes of the slave surface.
        slave: usize,
        /// Nodes of the master surface.
        master: usize,
    },
    /// A slave node has no partner at its place.
    #[error(
        "the two surfaces do not match node by node: the slave node at ({}, {}, {}) has no master \
         node at its place (the nearest is {distance:e} away, the tolerance is {tolerance:e})",
        point[0], point[1], point[2]
    )]
    NoPartner {
        /// The slave node's position.
        point: [f64; 3],
        /// Distance to the nearest master node.
        distance: f64,
        /// Largest distance at which two nodes count as one place.
        tolerance: f64,
    },
    /// Two slave nodes found the same master node.
    #[error(
        "two nodes of the slave surface have the same partner, the master node at ({}, {}, {})",
        point[0], point[1], point[2]
    )]
    SharedPartner {
        /// The master node's position.
        point: [f64; 3],
    },
    /// The normal vectors of the faces around a node cancel out.
    #[error(
        "the contact surface has no normal at ({}, {}, {}): the faces around that node cancel out",
        point[0], point[1], point[2]
    )]
    NoNormal {
        /// The node's position.
        point: [f64; 3],
    },
    /// The surface has no faces.
    #[error("the contact surface has no faces")]
    Empty,
    /// The slip bound is negative or not a number.
    #[error("the slip bound must be a number ≥ 0, found {bound}{}", at(*point))]
    SlipBound {
        /// What was given.
        bound: f64,
        /// Where on the surface, if it varies.
        point: Option<[f64; 3]>,
    },
    /// A friction coefficient is negative or not a number.
    #[error("a friction coefficient must be a number ≥ 0, found {value}")]
    Coefficient {
        /// What was given.
        value: f64,
    },
    /// The axis of an orthotropic law has no projection on the tangent plane.
    #[error(
        "the axis ({}, {}, {}) of the friction law is no direction in the tangent plane{}",
        axis[0], axis[1], axis[2], at(*point)
    )]
    Axis {
        /// What was given.
        axis: [f64; 3],
        /// Where on the surface, if the axis is a direction at all.
        point: Option<[f64; 3]>,
    },
    /// The initial gap is no finite number.
    #[error("the initial gap must be a finite number, found {gap} at ({}, {}, {})", point[0], point[1], point[2])]
    Gap {
        /// What was given.
        gap: f64,
        /// Where on the surface.
        point: [f64; 3],
    },
    /// A field is given by another number of values than the slave surface has nodes.
    #[error(
        "expected one value for each of the {expected} nodes of the slave surface, found {found}"
    )]
    ValueCount {
        /// Nodes of the slave surface.
        expected: usize,
        /// Values given.
        found: usize,
    },
}

fn at(point: Option<[f64; 3]>) -> String {
    point.map_or_else(String::new, |[x, y, z]| format!(" at ({x}, {y}, {z})"))
}
