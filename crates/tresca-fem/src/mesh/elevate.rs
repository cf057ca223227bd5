//! Quadratic cells out of linear ones.

use super::data::Mesh;
use super::kind::CellKind;
use crate::element::kinds::corners_of_nodes;
use std::collections::HashMap;

/// Cells share the nodes amid two or four corners; the node amid eight is a cell's own.
const SHARED: usize = 4;

impl Mesh {
    /// Puts nodes amid the corners of linear cells, which have been checked to have the shape of `kind`.
    pub(super) fn elevate(&mut self, kind: CellKind) {
        let corners_of_nodes = corners_of_nodes(kind);
        let mut known: HashMap<[usize; SHARED], usize> = HashMap::new();
        // The corners that each new node lies amid.
        let mut amid: Vec<Vec<usize>> = Vec::new();
        let first_new = self.points.len();
        for block in self.cells.iter_mut().filter(|block| block.kind != kind) {
            let mut connectivity = Vec::with_capacity(block.len() * kind.node_count());
            for cell in block.cells() {
                for corners in &corners_of_nodes {
                    if let [corner] = corners[..] {
                        connectivity.push(cell[corner]);
                        continue;
                    }
                    let mut around: Vec<usize> = corners.iter().map(|&a| cell[a]).collect();
                    around.sort_unstable();
                    let mut key = [usize::MAX; SHARED];
                    let node = if around.len() <= SHARED {
                        key[..around.len()].copy_from_slice(&around);
                        *known.entry(key).or_insert(first_new + amid.len())
                    } else {
                        first_new + amid.len()
                    };
                    if node == first_new + amid.len() {
                        amid.push(around);
                    }
                    connectivity.push(node);
                }
            }
            block.kind = kind;
            block.connectivity = connectivity;
        }
        for around in &amid {
            let share = 1.0 / around.len() as f64;
            let middle = std::array::from_fn(|i| {
                around.iter().map(|&a| self.points[a][i]).sum::<f64>() * share
            });
            self.points.push(middle);
        }
        for nodes in self.node_sets.values_mut() {
            let mut in_set = vec![false; first_new];
            nodes.iter().for_each(|&node| in_set[node] = true);
            let new = amid.iter().enumerate();
            let joined = new.filter(|(_, around)| around.iter().all(|&a| in_set[a]));
            nodes.extend(joined.map(|(new, _)| first_new + new));
        }
    }
}
