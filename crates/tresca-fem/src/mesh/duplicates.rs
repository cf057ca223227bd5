//! Nodes at one place.

use super::data::Mesh;
use rstar::RTree;
use rstar::primitives::GeomWithData;

impl Mesh {
    /// Pairs `[a, b]`, a < b, of nodes whose distance is at most `relative_tolerance` times the diagonal
    /// of the bounding box, ascending. A mesh that was glued together without merging the nodes of its
    /// parts has them all along the joint, and falls apart there.
    ///
    /// Every pair is listed: three nodes at one place make three.
    pub fn duplicate_nodes(&self, relative_tolerance: f64) -> Vec<[usize; 2]> {
        let tolerance = relative_tolerance * self.bounding_box().diagonal();
        let points = self.points.iter().enumerate();
        let tree = RTree::bulk_load(
            points
                .map(|(node, &point)| GeomWithData::new(point, node))
                .collect(),
        );
        let mut pairs: Vec<[usize; 2]> = tree
            .iter()
            .flat_map(|here| {
                let near = tree.locate_within_distance(*here.geom(), tolerance * tolerance);
                near.filter(|other| here.data < other.data)
                    .map(|other| [here.data, other.data])
            })
            .collect();
        pairs.sort_unstable();
        pairs
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::brick::{BrickSpec, brick};

    #[test]
    fn nodes_at_one_place_are_paired() {
        let mut mesh = brick(&BrickSpec {
            min: [0.0; 3],
            max: [1.0; 3],
            nodes: [4, 3, 3],
        })
        .unwrap();
        assert!(mesh.duplicate_nodes(1e-6).is_empty());
        let near = mesh.points[7].map(|x| x + 1e-9);
        mesh.points.push(near);
        mesh.points.push(mesh.points[20]);
        assert_eq!(mesh.duplicate_nodes(1e-6), [[7, 36], [20, 37]]);
        assert_eq!(mesh.duplicate_nodes(0.0), [[20, 37]]);
    }
}
