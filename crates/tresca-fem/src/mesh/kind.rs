//! The kinds of cells.

use std::fmt;

/// Kinds of cells and of their faces; nodes and faces are numbered like VTK's (see the elements in
/// [`crate::element`]).
///
/// Plane kinds are the faces of solid ones and the cells of plane bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum CellKind {
    /// Two-node line: the face of linear plane cells.
    Line2,
    /// Three-node line: the face of quadratic plane cells.
    Line3,
    /// Linear triangle.
    Tri3,
    /// Quadratic triangle.
    Tri6,
    /// Bilinear quadrilateral.
    Quad4,
    /// Quadratic serendipity quadrilateral.
    Quad8,
    /// Biquadratic quadrilateral.
    Quad9,
    /// Linear tetrahedron.
    Tet4,
    /// Quadratic tetrahedron.
    Tet10,
    /// Linear wedge.
    Wedge6,
    /// Trilinear hexahedron.
    Hex8,
    /// Quadratic serendipity hexahedron.
    Hex20,
    /// Triquadratic hexahedron.
    Hex27,
}

impl CellKind {
    /// Every kind, in the order of the dimension.
    pub const ALL: [CellKind; 13] = [
        CellKind::Line2,
        CellKind::Line3,
        CellKind::Tri3,
        CellKind::Tri6,
        CellKind::Quad4,
        CellKind::Quad8,
        CellKind::Quad9,
        CellKind::Tet4,
        CellKind::Tet10,
        CellKind::Wedge6,
        CellKind::Hex8,
        CellKind::Hex20,
        CellKind::Hex27,
    ];

    /// The name: shape and number of nodes, "tet10".
    pub fn name(self) -> &'static str {
        match self {
            CellKind::Line2 => "line2",
            CellKind::Line3 => "line3",
            CellKind::Tri3 => "tri3",
            CellKind::Tri6 => "tri6",
            CellKind::Quad4 => "quad4",
            CellKind::Quad8 => "quad8",
            CellKind::Quad9 => "quad9",
            CellKind::Tet4 => "tet4",
            CellKind::Tet10 => "tet10",
            CellKind::Wedge6 => "wedge6",
            CellKind::Hex8 => "hex8",
            CellKind::Hex20 => "hex20",
            CellKind::Hex27 => "hex27",
        }
    }

    /// The linear kind of the same shape: its nodes are the first of this kind's, the corners.
    pub fn linear(self) -> CellKind {
        match self {
            CellKind::Line2 | CellKind::Line3 => CellKind::Line2,
            CellKind::Tri3 | CellKind::Tri6 => CellKind::Tri3,
            CellKind::Quad4 | CellKind::Quad8 | CellKind::Quad9 => CellKind::Quad4,
            CellKind::Tet4 | CellKind::Tet10 => CellKind::Tet4,
            CellKind::Wedge6 => CellKind::Wedge6,
            CellKind::Hex8 | CellKind::Hex20 | CellKind::Hex27 => CellKind::Hex8,
        }
    }

    /// Degree of the complete polynomials that the shape functions contain: 1 or 2.
    pub fn order(self) -> usize {
        if self == self.linear() { 1 } else { 2 }
    }

    /// Number of corners; the corners are the first nodes.
    pub fn corner_count(self) -> usize {
        self.linear().node_count()
    }
}

impl fmt::Display for CellKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
