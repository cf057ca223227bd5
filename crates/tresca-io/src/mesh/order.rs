//! From other programs' order of the nodes of an element to ours, which is VTK's.

use tresca_fem::mesh::CellKind;

/// For each of our nodes, the node of Gmsh that is it; `None` where the orders agree. Source: the
/// Gmsh reference manual, chapter "Gmsh file formats", section "Node ordering".
pub(super) fn from_gmsh(kind: CellKind) -> Option<&'static [usize]> {
    match kind {
        // The mid nodes of the edges 1–3 and 2–3 are exchanged.
        CellKind::Tet10 => Some(&[0, 1, 2, 3, 4, 5, 6, 7, 9, 8]),
        // Gmsh goes through the edges by their lower corner; VTK around the bottom, around the
        // top, then upwards.
        CellKind::Hex20 => Some(&HEX_FROM_GMSH[..20]),
        // Faces: VTK has x−, x+, y−, y+, z−, z+, Gmsh z−, y−, x−, x+, y+, z+.
        CellKind::Hex27 => Some(&HEX_FROM_GMSH),
        CellKind::Wedge6 => Some(&WEDGE_TURNED),
        _ => None,
    }
}

const HEX_FROM_GMSH: [usize; 27] = [
    0, 1, 2, 3, 4, 5, 6, 7, // corners
    8, 11, 13, 9, // bottom
    16, 18, 19, 17, // top
    10, 12, 14, 15, // upright
    22, 23, 21, 24, 20, 25, 26,
];

/// The same for Abaqus and CalculiX. Source: the Abaqus Elements Guide, sections "Node ordering and
/// face numbering on elements"; CalculiX CrunchiX user's manual, section "Element types".
pub(super) fn from_abaqus(kind: CellKind) -> Option<&'static [usize]> {
    match kind {
        // From end to end.
        CellKind::Line3 => Some(&[0, 2, 1]),
        CellKind::Wedge6 => Some(&WEDGE_TURNED),
        _ => None,
    }
}

/// The bottom triangle of a wedge is seen counter-clockwise from outside in VTK, from inside elsewhere.
const WEDGE_TURNED: [usize; 6] = [0, 2, 1, 3, 5, 4];

/// For each node of a turned over line or surface element, the node that it was; its first node
/// stays (of a line: its mid node).
pub(super) fn turned_over(kind: CellKind) -> Option<&'static [usize]> {
    match kind {
        CellKind::Line2 => Some(&[1, 0]),
        CellKind::Line3 => Some(&[1, 0, 2]),
        CellKind::Tri3 => Some(&[0, 2, 1]),
        CellKind::Tri6 => Some(&[0, 2, 1, 5, 4, 3]),
        CellKind::Quad4 => Some(&[0, 3, 2, 1]),
        CellKind::Quad8 => Some(&[0, 3, 2, 1, 7, 6, 5, 4]),
        CellKind::Quad9 => Some(&[0, 3, 2, 1, 7, 6, 5, 4, 8]),
        _ => None,
    }
}

/// Brings nodes into our order; `scratch` is work memory.
pub(super) fn reorder<T: Copy>(order: Option<&[usize]>, nodes: &mut [T], scratch: &mut Vec<T>) {
    let Some(order) = order else { return };
    scratch.clear();
    scratch.extend_from_slice(nodes);
    for (node, &from) in nodes.iter_mut().zip(order) {
        *node = scratch[from];
    }
}
