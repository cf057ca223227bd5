//! Who touches whom: cells around a node, faces on the boundary.

use super::{Face, Mesh};

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

    /// The faces that belong to one cell only, ascending.
    pub fn boundary_faces(&self) -> Vec<Face> {
        // A face is known by its three lowest corners: two faces of a valid mesh that share three
        // corners are the same one (of all nodes, two quadratic faces with a common edge share three).
        // In the plane two corners are all there are.
        let mut keyed: Vec<([usize; 3], Face)> = Vec::new();
        for (cell, of) in self.iter_cells().enumerate() {
            for (local, face) in of.kind.faces().iter().enumerate() {
                let mut lowest = [usize::MAX; 3];
                for &a in &face.nodes[..face.kind.corner_count()] {
                    let mut node = of.nodes[a];
                    for slot in &mut lowest {
                        if node < *slot {
                            std::mem::swap(slot, &mut node);
                        }
                    }
                }
                keyed.push((lowest, Face { cell, local }));
            }
        }
        keyed.sort_unstable();
        let mut boundary: Vec<Face> = keyed
            .chunk_by(|a, b| a.0 == b.0)
            .filter(|same| same.len() == 1)
            .map(|same| same[0].1)
            .collect();
        boundary.sort_unstable();
        boundary
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::{BrickSpec, brick};

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
