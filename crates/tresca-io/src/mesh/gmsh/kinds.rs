//! Gmsh's numbers of element types.

use tresca_fem::mesh::CellKind;

/// What an element type is to us.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A single node.
    Point,
    Cell(CellKind),
    /// Known to Gmsh, by name.
    Unsupported(&'static str),
}

/// By the number of the type (Gmsh's header `GmshDefines.h`).
pub(super) fn kind(number: i32) -> Kind {
    Kind::Cell(match number {
        1 => CellKind::Line2,
        2 => CellKind::Tri3,
        3 => CellKind::Quad4,
        4 => CellKind::Tet4,
        5 => CellKind::Hex8,
        6 => CellKind::Wedge6,
        8 => CellKind::Line3,
        9 => CellKind::Tri6,
        10 => CellKind::Quad9,
        11 => CellKind::Tet10,
        12 => CellKind::Hex27,
        16 => CellKind::Quad8,
        17 => CellKind::Hex20,
        15 => return Kind::Point,
        7 => return Kind::Unsupported("pyramid with 5 nodes"),
        13 => return Kind::Unsupported("prism with 18 nodes"),
        14 => return Kind::Unsupported("pyramid with 14 nodes"),
        18 => return Kind::Unsupported("prism with 15 nodes"),
        19 => return Kind::Unsupported("pyramid with 13 nodes"),
        20 | 21 | 26 | 29 | 36 | 90 | 92 => return Kind::Unsupported("element of order 3"),
        22..=25 | 27 | 28 | 30..=35 | 37..=89 | 91 | 93..=98 => {
            return Kind::Unsupported("element of order 4 or more");
        }
        _ => return Kind::Unsupported("element of a type for other purposes"),
    })
}
