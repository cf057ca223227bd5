//! The connected parts of a mesh.

use super::data::Mesh;
use super::disjoint_sets::DisjointSets;
use super::geometry::BoundingBox;

/// A connected part of a mesh: nodes that are linked through cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its nodes, ascending.
    pub nodes: Vec<usize>,
}

impl Part {
    /// The smallest axis-parallel box around the part.
    pub fn bounding_box(&self, mesh: &Mesh) -> BoundingBox {
        BoundingBox::around(self.nodes.iter().map(|&node| mesh.points[node]))
    }
}

impl Mesh {
    /// The connected parts, ordered by their lowest nodes. Cells that share a node are connected.
    pub fn parts(&self) -> Vec<Part> {
        let mut sets = DisjointSets::new(self.node_count());
        for cell in self.iter_cells() {
            for &node in &cell.nodes[1..] {
                sets.join(cell.nodes[0], node);
            }
        }
        let mut part_of_root = vec![usize::MAX; self.node_count()];
        let mut parts: Vec<Part> = Vec::new();
        for node in 0..self.node_count() {
            let root = sets.root(node);
            if root == node {
                part_of_root[node] = parts.len();
                parts.push(Part { nodes: Vec::new() });
            }
            parts[part_of_root[root]].nodes.push(node);
        }
        parts
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::brick::{BrickSpec, brick};

    #[test]
    fn parts_are_ordered_by_their_lowest_nodes() {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [4.0, 1.0, 1.0],
            nodes: [5, 2, 2],
        };
        let mut mesh = brick(&spec).unwrap();
        assert_eq!(mesh.parts().len(), 1);
        assert_eq!(mesh.parts()[0].nodes.len(), 20);
        // Take the second of the four cells out: the first one stands alone.
        mesh.cells[0].connectivity.drain(8..16);
        mesh.cells[0].connectivity.rotate_left(8);
        let parts = mesh.parts();
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[0].nodes, [0, 1, 5, 6, 10, 11, 15, 16]);
        assert_eq!(parts[1].nodes, [2, 3, 4, 7, 8, 9, 12, 13, 14, 17, 18, 19]);
        let bounds = parts[1].bounding_box(&mesh);
        assert_eq!((bounds.min, bounds.max), ([2.0, 0.0, 0.0], [4.0, 1.0, 1.0]));
    }
}
