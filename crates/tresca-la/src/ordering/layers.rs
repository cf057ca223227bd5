//! A first cut parallel to the trailing dofs.
//!
//! The trailing dofs stay in every front that touches them. Dissection that
//! does not know of them cuts across them first, and all of them are carried
//! through the largest fronts. Cutting off the near third of the body first
//! keeps them out of the fronts of the other two thirds: 6 % fewer operations
//! for a brick with one face trailing, all but what straight cuts can reach at
//! all (by dynamic programming over them).

use super::graph::Graph;
use std::ops::RangeInclusive;

/// Part of the vertices on the near side of the cut. A third is best for a
/// brick; the flat optimum leaves room to look for a small cut.
const NEAR_SHARE: RangeInclusive<f64> = 0.26..=0.40;

/// Largest cut worth making, relative to n^(2/3), the midplane of a cube of n
/// vertices. Bodies that are thin across the trailing dofs exceed it: they are
/// cut cheaper the other way.
const LARGEST_CUT: f64 = 1.3;

/// The vertices of a graph in three parts; no edge joins `far` and `near`.
pub(super) struct Layers {
    pub(super) far: Vec<usize>,
    pub(super) near: Vec<usize>,
    pub(super) cut: Vec<usize>,
}

impl Layers {
    /// Cuts at a set of vertices of equal distance from the trailing dofs.
    /// `None` when there is no cut worth making.
    pub(super) fn of(graph: &Graph) -> Option<Self> {
        let count = graph.len();
        let distance = distances(graph);
        let deepest = distance.iter().copied().filter(|&d| d < usize::MAX).max()?;
        let mut sizes = vec![0; deepest + 1];
        for &d in distance.iter().filter(|&&d| d < usize::MAX) {
            sizes[d] += 1;
        }
        let mut near = 0;
        let mut best: Option<(usize, usize)> = None;
        for (d, &size) in sizes.iter().enumerate() {
            let share = near as f64 / (count - size).max(1) as f64;
            if NEAR_SHARE.contains(&share) && best.is_none_or(|(_, smallest)| size < smallest) {
                best = Some((d, size));
            }
            near += size;
        }
        let (level, size) = best?;
        if size as f64 > LARGEST_CUT * (count as f64).powf(2.0 / 3.0) {
            return None;
        }
        let is_near = |v: usize| {
            distance[v] < level
                || distance[v] == level
                    && graph.neighbours_of(v).iter().all(|&w| distance[w] <= level)
        };
        let mut layers = Layers {
            far: Vec::new(),
            near: Vec::new(),
            cut: Vec::new(),
        };
        for (v, &d) in distance.iter().enumerate() {
            let part = if is_near(v) {
                &mut layers.near
            } else if d == level {
                &mut layers.cut
            } else {
                &mut layers.far
            };
            part.push(v);
        }
        Some(layers)
    }
}

/// Edges between each vertex and the nearest one that couples to a trailing
/// dof; `usize::MAX` where there is no way.
fn distances(graph: &Graph) -> Vec<usize> {
    let mut distance = vec![usize::MAX; graph.len()];
    let mut queue: Vec<usize> = (0..graph.len())
        .filter(|&v| graph.touches_left_out(v))
        .collect();
    for &v in &queue {
        distance[v] = 0;
    }
    let mut head = 0;
    while let Some(&v) = queue.get(head) {
        head += 1;
        for &w in graph.neighbours_of(v) {
            if distance[w] == usize::MAX {
                distance[w] = distance[v] + 1;
                queue.push(w);
            }
        }
    }
    distance
}
