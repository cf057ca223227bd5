//! The reference element of each kind of cells.

use super::hex8::Hex8;
use super::hex20::Hex20;
use super::hex27::Hex27;
use super::line2::Line2;
use super::line3::Line3;
use super::quad4::Quad4;
use super::quad8::Quad8;
use super::quad9::Quad9;
use super::reference::{Element, ReferenceFace};
use super::tet4::Tet4;
use super::tet10::Tet10;
use super::tri3::Tri3;
use super::tri6::Tri6;
use super::wedge6::Wedge6;
use crate::mesh::kind::CellKind;

impl CellKind {
    /// The reference element.
    pub fn element(self) -> &'static dyn Element {
        match self {
            CellKind::Line2 => &Line2,
            CellKind::Line3 => &Line3,
            CellKind::Tri3 => &Tri3,
            CellKind::Tri6 => &Tri6,
            CellKind::Quad4 => &Quad4,
            CellKind::Quad8 => &Quad8,
            CellKind::Quad9 => &Quad9,
            CellKind::Tet4 => &Tet4,
            CellKind::Tet10 => &Tet10,
            CellKind::Wedge6 => &Wedge6,
            CellKind::Hex8 => &Hex8,
            CellKind::Hex20 => &Hex20,
            CellKind::Hex27 => &Hex27,
        }
    }

    /// Number of nodes.
    pub fn node_count(self) -> usize {
        self.element().nodes().len()
    }

    /// Dimension of the reference domain.
    pub fn dimension(self) -> usize {
        self.element().dimension()
    }

    /// The faces of a cell of this kind.
    pub fn faces(self) -> &'static [ReferenceFace] {
        self.element().faces()
    }
}

/// For each node of a kind the corners that it lies amid: itself for a corner.
pub(crate) fn corners_of_nodes(kind: CellKind) -> Vec<Vec<usize>> {
    let mut values = vec![0.0; kind.corner_count()];
    let nodes = kind.element().nodes().iter();
    nodes
        .map(|&xi| {
            kind.linear().element().shape(xi, &mut values);
            (0..values.len()).filter(|&a| values[a] != 0.0).collect()
        })
        .collect()
}
