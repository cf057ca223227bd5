//! What can be wrong with the geometry of a contact.

use tresca_fem::mesh::CellKind;

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
    /// Quadratic faces cannot be coupled node by node.
    #[error(
        "surfaces of {kind} faces cannot be coupled node by node (corner nodes have no area of their \
         own); use mortar coupling"
    )]
    QuadraticFaces {
        /// The faces' kind.
        kind: CellKind,
    },
    /// A cell that is no face of the space at hand, or a face with a wrong number of nodes.
    #[error("a contact surface cannot have faces of kind {kind} with {nodes} nodes here")]
    FaceKind {
        /// What was given.
        kind: CellKind,
        /// With that many nodes.
        nodes: usize,
    },
    /// A face refers to a point that is not there or not finite.
    #[error(
        "a face of a contact surface refers to point {node}, which does not exist or is not finite"
    )]
    FaceNode {
        /// Number of the point.
        node: usize,
    },
    /// A face without area, or a quadrilateral with a corner that points inwards.
    #[error(
        "a face of the contact surface has no area, or a corner that points inwards, at ({}, {}, {})",
        point[0], point[1], point[2]
    )]
    DegenerateFace {
        /// Its centre.
        point: [f64; 3],
    },
    /// Nothing lies in front of the slave surface.
    #[error(
        "the two surfaces are too far apart, or face away from each other: nothing lies in front of the \
         slave surface within the search distance"
    )]
    Apart,
    /// The search distance is no length.
    #[error("the search distance must be a length > 0, found {search}")]
    Search {
        /// What was given.
        search: f64,
    },
    /// An obstacle whose numbers make no sense.
    #[error("{what}")]
    Obstacle {
        /// What is wrong.
        what: &'static str,
    },
    /// A slave node is too deep in an obstacle for the nearest point of it to mean anything.
    #[error(
        "the slave node at ({}, {}, {}) is {depth} deep inside of the obstacle, beyond half of its radius \
         {radius}",
        point[0], point[1], point[2]
    )]
    TooDeep {
        /// The node's position.
        point: [f64; 3],
        /// How deep it is.
        depth: f64,
        /// The obstacle's radius.
        radius: f64,
    },
    /// A slave node at the centre of a round cavity sees it in no direction.
    #[error(
        "the slave node at ({}, {}, {}) lies at the centre of the obstacle's cavity, which has no nearest \
         point there; choose a smaller search distance",
        point[0], point[1], point[2]
    )]
    AtCenter {
        /// The node's position.
        point: [f64; 3],
    },
    /// Patches of another surface.
    #[error(
        "the smooth patches are those of a surface of {found} faces, the surface has {expected}"
    )]
    PatchFaces {
        /// Faces of the surface.
        expected: usize,
        /// Faces that the patches were made for.
        found: usize,
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
