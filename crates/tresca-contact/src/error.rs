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
    #[error("the slip bound must be a number ≥ 0, found {bound}")]
    SlipBound {
        /// What was given.
        bound: f64,
    },
}
