//! Cells cut into simpler ones.

use super::data::{Cell, CellBlock, Face, Mesh};
use super::kind::CellKind;
use crate::error::FemError;

/// The nodes of the two triangles of a quadrilateral on both sides of the diagonal from `corner`.
fn halves(quad: &[usize], corner: usize) -> [[usize; 3]; 2] {
    let at = |i: usize| quad[(corner + i) % 4];
    [[at(0), at(1), at(2)], [at(0), at(2), at(3)]]
}

/// Cuts a cell (hexahedron or wedge) into tetrahedra: the pyramids from its lowest node to the faces
/// that do not have it, each quadrilateral being halved from its own lowest node. Both sides of a face
/// halve it the same way because they see the same numbers (Dompierre, Labbé, Vallet, Camarero: *How to
/// subdivide pyramids, prisms, and hexahedra into tetrahedra*, 1999).
fn tetrahedra(cell: Cell<'_>, connectivity: &mut Vec<usize>) {
    let Some(&apex) = cell.nodes.iter().min() else {
        return;
    };
    for face in cell.kind.faces() {
        let nodes: Vec<usize> = face.nodes.iter().map(|&a| cell.nodes[a]).collect();
        if nodes.contains(&apex) {
            continue;
        }
        // Seen from outside a face runs counter-clockwise, and the base of a tetrahedron clockwise.
        let mut add = |[a, b, c]: [usize; 3]| connectivity.extend([a, c, b, apex]);
        match nodes[..] {
            [a, b, c] => add([a, b, c]),
            _ => {
                let lowest = (0..nodes.len()).min_by_key(|&i| nodes[i]).unwrap_or(0);
                halves(&nodes, lowest).into_iter().for_each(add);
            }
        }
    }
}

/// Cuts a hexahedron into two wedges by the plane through its edges 0–4 and 2–6.
fn wedges(nodes: &[usize], connectivity: &mut Vec<usize>) {
    for [a, b, c] in [[0, 2, 1], [0, 3, 2]] {
        connectivity.extend([a, b, c, a + 4, b + 4, c + 4].map(|a| nodes[a]));
    }
}

impl Mesh {
    /// Cuts all cells that are not of the (linear) kind `to` into such; which kinds can be cut has been
    /// checked.
    pub(super) fn cut(self, to: CellKind) -> Result<Mesh, FemError> {
        let mut connectivity = Vec::new();
        // Where the pieces of each cell start.
        let mut starts = vec![0];
        for cell in self.iter_cells() {
            match (cell.kind, to) {
                (CellKind::Hex8 | CellKind::Wedge6, CellKind::Tet4) => {
                    tetrahedra(cell, &mut connectivity);
                }
                (CellKind::Hex8, CellKind::Wedge6) => wedges(cell.nodes, &mut connectivity),
                (CellKind::Quad4, CellKind::Tri3) => {
                    connectivity.extend(halves(cell.nodes, 0).as_flattened());
                }
                _ => connectivity.extend_from_slice(cell.nodes),
            }
            starts.push(connectivity.len() / to.node_count());
        }
        let surface = self.boundary_faces();
        let block = CellBlock {
            kind: to,
            connectivity,
        };
        let mut mesh = Mesh {
            space: self.space,
            points: self.points.clone(),
            cells: vec![block],
            face_sets: Default::default(),
            node_sets: self.node_sets.clone(),
        };
        let pieces = |faces: &[Face]| -> Vec<Face> {
            let of_face = |&face: &Face| {
                let whole = self.face_nodes(face);
                let range = starts[face.cell]..starts[face.cell + 1];
                mesh.faces_within(range, whole)
            };
            faces.iter().flat_map(of_face).collect()
        };
        let mut expected = pieces(&surface);
        expected.sort_unstable();
        let sets = self.face_sets.iter();
        let face_sets = sets
            .map(|(name, faces)| (name.clone(), pieces(faces)))
            .collect();
        mesh.face_sets = face_sets;
        if mesh.boundary_faces() == expected {
            Ok(mesh)
        } else {
            Err(FemError::CutsDoNotMatch { to })
        }
    }

    /// The faces of some cells that have no other nodes than the given ones.
    fn faces_within(&self, cells: std::ops::Range<usize>, nodes: Vec<usize>) -> Vec<Face> {
        let all = cells.flat_map(|cell| {
            (0..self.cell(cell).kind.faces().len()).map(move |local| Face { cell, local })
        });
        let within = |&face: &Face| self.face_nodes(face).iter().all(|a| nodes.contains(a));
        all.filter(within).collect()
    }
}
