//! Who faces whom: node-by-node pairing of two matching surfaces.

use rstar::RTree;
use rstar::primitives::GeomWithData;

use crate::error::ContactError;
use crate::surface::nodes::ContactSurface;

/// Two nodes are at one place when they are closer than this share of the distance to the next node
/// of the face. Mesh generators write coordinates with six digits or more.
const RELATIVE_TOLERANCE: f64 = 1e-5;

/// For each slave node (once, whatever its patches) the index (into `master.nodes`) of the master node at its
/// place. The master is one patch.
pub(crate) fn match_nodes(
    slave: &ContactSurface,
    master: &ContactSurface,
) -> Result<Vec<usize>, ContactError> {
    if slave.node_count() != master.nodes.len() {
        return Err(ContactError::NodeCounts {
            slave: slave.node_count(),
            master: master.nodes.len(),
        });
    }
    let tree = RTree::bulk_load(
        master
            .nodes
            .iter()
            .enumerate()
            .map(|(i, node)| GeomWithData::new(node.point, i))
            .collect(),
    );
    let mut taken = vec![false; master.nodes.len()];
    let places = slave.nodes.chunk_by(|a, b| a.node == b.node);
    places
        .map(|of_node| &of_node[0])
        .map(|node| {
            let tolerance = RELATIVE_TOLERANCE * node.spacing;
            let (distance, partner) = tree
                .nearest_neighbor_iter_with_distance_2(node.point)
                .next()
                .map_or((f64::INFINITY, 0), |(entry, squared)| {
                    (squared.sqrt(), entry.data)
                });
            if distance > tolerance {
                return Err(ContactError::NoPartner {
                    point: node.point,
                    distance,
                    tolerance,
                });
            }
            if std::mem::replace(&mut taken[partner], true) {
                return Err(ContactError::SharedPartner {
                    point: master.nodes[partner].point,
                });
            }
            Ok(partner)
        })
        .collect()
}
