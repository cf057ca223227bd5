//! Who touches whom: cells around a node, faces on the boundary.

use super::data::{Face, Mesh};
use rayon::prelude::*;

/// The cells around every node.
#[derive(Clone, Debug)]
pub struct Incidence {
    starts: Vec<usize>,
    cells: Vec<usize>,
}

impl Incidence {
    /// Global numbers of the cells at a node, ascending.
    pub fn cells_at(&self, node: usize) -> &[usize] {
        &self.cells[self.starts[node]..self.starts[node + 1]]
    }
}

impl Mesh {
    /// The cells around every node.
    pub fn incidence(&self) -> Incidence {
        let mut starts = vec![0; self.node_count() + 1];
        for block in &self.cells {
            for &node in &block.connectivity {
                starts[node + 1] += 1;
            }
        }
        for node in 0..self.node_count() {
            starts[node + 1] += starts[node];
        }
        let mut next = starts.clone();
        let mut cells = vec![0; starts[self.node_count()]];
        for (cell, of) in self.iter_cells().enumerate() {
            for &node in of.nodes {
                cells[next[node]] = cell;
                next[node] += 1;
            }
        }
        Incidence { starts, cells }
    }

    /// The faces that belong to one cell only, the surface of the body, ascending.
    pub fn boundary_faces(&self) -> Vec<Face> {
        FaceLookup::new(self).boundary()
    }
}

/// All faces of a mesh, found by their corners.
///
/// Two faces with the same corners are the two sides of one face inside the body. (Of all nodes, two
/// quadratic faces with a common edge share three.)
#[derive(Clone, Debug)]
pub struct FaceLookup {
    /// Corners of each face, ascending, filled up; ascending themselves.
    keys: Vec<FaceKey>,
    /// The face with each key.
    faces: Vec<Face>,
}

/// The corners of a face in ascending order, the free places filled with the largest number.
type FaceKey = [usize; 4];

fn face_key(corners: impl IntoIterator<Item = usize>) -> FaceKey {
    let mut key = [usize::MAX; 4];
    for (slot, node) in key.iter_mut().zip(corners) {
        *slot = node;
    }
    key.sort_unstable();
    key
}

impl FaceLookup {
    /// Notes every face of every cell.
    pub fn new(mesh: &Mesh) -> Self {
        let mut keyed: Vec<(FaceKey, Face)> = Vec::new();
        for (cell, of) in mesh.iter_cells().enumerate() {
            for (local, face) in of.kind.faces().iter().enumerate() {
                let corners = &face.nodes[..face.kind.corner_count()];
                let key = face_key(corners.iter().map(|&a| of.nodes[a]));
                keyed.push((key, Face { cell, local }));
            }
        }
        keyed.par_sort_unstable();
        let (keys, faces) = keyed.into_iter().unzip();
        Self { keys, faces }
    }

    /// The faces with the given corners (in any order, without the middle nodes of a quadratic face):
    /// none, the one face of a surface, or the two sides of a face inside the body, the lower cell
    /// first.
    pub fn sides(&self, corners: &[usize]) -> &[Face] {
        if corners.len() > 4 {
            return &[];
        }
        let key = face_key(corners.iter().copied());
        let start = self.keys.partition_point(|other| *other < key);
        let count = self.keys[start..].iter().take_while(|k| **k == key).count();
        &self.faces[start..start + count]
    }

    /// The face of the surface with the given corners; `None` where there is no such face and where it
    /// lies inside the body, which [`FaceLookup::sides`] tells apart.
    pub fn find(&self, corners: &[usize]) -> Option<Face> {
        match self.sides(corners) {
            [face] => Some(*face),
            _ => None,
        }
    }

    /// The faces without a second side, ascending.
    fn boundary(&self) -> Vec<Face> {
        let mut start = 0;
        let mut boundary = Vec::new();
        for same in self.keys.chunk_by(|a, b| a == b) {
            if let [_] = same {
                boundary.push(self.faces[start]);
            }
            start += same.len();
        }
        boundary.sort_unstable();
        boundary
    }
}

#[cfg(test)]
mod tests {
    use super::FaceLookup;
    use crate::mesh::brick::{BrickSpec, brick};
    use crate::mesh::data::Face;
    use crate::mesh::kind::CellKind;

    #[test]
    fn faces_are_found_by_their_corners() {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [1.0; 3],
            nodes: [3, 2, 2],
        };
        for kind in [CellKind::Hex8, CellKind::Hex27] {
            let mesh = brick(&spec).unwrap().with_cells(kind).unwrap();
            let lookup = FaceLookup::new(&mesh);
            let left = Face { cell: 0, local: 0 };
            assert_eq!(lookup.find(&[3, 9, 0, 6]), Some(left));
            assert_eq!(lookup.sides(&[3, 9, 0, 6]), [left]);
            // Between the cells, and nowhere.
            let between = [Face { cell: 0, local: 1 }, Face { cell: 1, local: 0 }];
            assert_eq!(lookup.sides(&[1, 4, 7, 10]), between);
            assert_eq!(lookup.find(&[1, 4, 7, 10]), None);
            for nowhere in [&[0, 1, 2, 3][..], &[3, 9, 0], &[0, 1, 2, 3, 4], &[]] {
                assert!(lookup.sides(nowhere).is_empty());
            }
        }
    }

    #[test]
    fn a_node_knows_its_cells() {
        let mesh = brick(&BrickSpec {
            min: [0.0; 3],
            max: [1.0; 3],
            nodes: [3, 3, 3],
        })
        .unwrap();
        let incidence = mesh.incidence();
        assert_eq!(incidence.cells_at(13), &[0, 1, 2, 3, 4, 5, 6, 7]);
        assert_eq!(incidence.cells_at(0), &[0]);
        assert_eq!(incidence.cells_at(14), &[1, 3, 5, 7]);
    }
}
