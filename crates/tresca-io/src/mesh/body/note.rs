//! What the user of a mesh should know about it.

use std::fmt;

/// Something about a mesh that its user should know.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshNote {
    /// Two nodes of one body at one place: it falls apart there.
    DuplicateNodes {
        /// How many pairs.
        pairs: usize,
        /// The numbers of the first pair in the file.
        first: [u64; 2],
        /// Their place, after placement (length).
        at: [f64; 3],
    },
    /// Plane elements that ran clockwise were turned over.
    Clockwise {
        /// How many.
        cells: usize,
    },
}

impl fmt::Display for MeshNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MeshNote::DuplicateNodes { pairs, first, at } => write!(
                f,
                "{pairs} pairs of nodes lie on one another inside of the body, such as {} and {} at {at:?}: it is not \
                 connected there. If it should be, merge the parts before meshing (Gmsh: `Coherence;` or \
                 `BooleanFragments`, afterwards `Coherence Mesh;`)",
                first[0], first[1]
            ),
            MeshNote::Clockwise { cells } => write!(
                f,
                "{cells} elements of plane surfaces that run clockwise were turned over"
            ),
        }
    }
}
