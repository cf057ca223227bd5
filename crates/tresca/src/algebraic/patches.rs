//! Patches of neighbouring pairs without any geometry: neighbours in the graph of K.

use std::collections::VecDeque;

use tresca_qcqp::operator::groups;

use super::Matrix;
use crate::dual::PAIRS_PER_PATCH;

/// The unknowns in patches, for the local model of A: by the points of the pairs where these are known, by
/// distances in the graph of K else.
pub(super) fn patches(
    k: &Matrix,
    b: &Matrix,
    dimension: usize,
    points: Option<&[[f64; 3]]>,
) -> Vec<Vec<usize>> {
    let pairs = b.rows() / dimension;
    let patches = match points {
        Some(points) => groups::neighbours(points, PAIRS_PER_PATCH),
        None => groups::neighbours(&coordinates(&neighbours(k, b, pairs)), PAIRS_PER_PATCH),
    };
    groups::unknowns_of_pairs(&patches, dimension)
}

/// Pairs that touch dofs which K couples.
fn neighbours(k: &Matrix, b: &Matrix, pairs: usize) -> Vec<Vec<usize>> {
    let tangents = b.rows() / pairs - 1;
    let rows_of = |pair: usize| {
        std::iter::once(pair).chain((0..tangents).map(move |t| pairs + tangents * pair + t))
    };
    let mut pairs_of_dof: Vec<Vec<usize>> = vec![Vec::new(); k.rows()];
    for pair in 0..pairs {
        for (dof, value) in rows_of(pair).flat_map(|row| b.row(row)) {
            if value != 0.0 && pairs_of_dof[dof].last() != Some(&pair) {
                pairs_of_dof[dof].push(pair);
            }
        }
    }
    let of_pair = |pair: usize| {
        let mut dofs: Vec<usize> = rows_of(pair)
            .flat_map(|row| b.row(row))
            .map(|(dof, _)| dof)
            .collect();
        dofs.sort_unstable();
        dofs.dedup();
        let mut found: Vec<usize> = dofs
            .iter()
            .flat_map(|&dof| k.row(dof).filter(|(_, value)| *value != 0.0))
            .flat_map(|(dof, _)| &pairs_of_dof[dof])
            .copied()
            .filter(|&other| other != pair)
            .collect();
        found.sort_unstable();
        found.dedup();
        found
    };
    (0..pairs).map(of_pair).collect()
}

/// Coordinates in which neighbours are near: the numbers of steps from three pairs that lie far apart.
/// What is not connected lies far away.
fn coordinates(neighbours: &[Vec<usize>]) -> Vec<[f64; 3]> {
    let count = neighbours.len();
    let mut points = vec![[f64::NAN; 3]; count];
    let far = 2.0 * count as f64;
    let mut part = 0.0;
    for start in 0..count {
        if !points[start][0].is_nan() {
            continue;
        }
        if neighbours[start].is_empty() {
            points[start] = [part * far, 0.0, 0.0];
            part += 1.0;
            continue;
        }
        let from_start = steps(neighbours, start);
        let farthest = |distance: &dyn Fn(usize) -> usize| {
            let reached = (0..count).filter(|&pair| from_start[pair] != usize::MAX);
            // The first of the farthest.
            reached.fold(start, |best, pair| {
                if distance(pair) > distance(best) {
                    pair
                } else {
                    best
                }
            })
        };
        let a = steps(neighbours, farthest(&|pair| from_start[pair]));
        let b = steps(neighbours, farthest(&|pair| a[pair]));
        let c = steps(neighbours, farthest(&|pair| a[pair].min(b[pair])));
        for pair in (0..count).filter(|&pair| from_start[pair] != usize::MAX) {
            points[pair] = [part * far + a[pair] as f64, b[pair] as f64, c[pair] as f64];
        }
        part += 1.0;
    }
    points
}

/// Steps from a pair to every other; `usize::MAX` where there is no way.
fn steps(neighbours: &[Vec<usize>], start: usize) -> Vec<usize> {
    let mut steps = vec![usize::MAX; neighbours.len()];
    steps[start] = 0;
    let mut queue = VecDeque::from([start]);
    while let Some(pair) = queue.pop_front() {
        for &other in &neighbours[pair] {
            if steps[other] == usize::MAX {
                steps[other] = steps[pair] + 1;
                queue.push_back(other);
            }
        }
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_known_by_its_graph_alone_falls_into_compact_patches() {
        let (width, height) = (20, 20);
        let at = |x: usize, y: usize| x + width * y;
        let neighbours: Vec<Vec<usize>> = (0..width * height)
            .map(|i| {
                let (x, y) = (i % width, i / width);
                let near = |a: usize, b: usize| a.abs_diff(b) <= 1;
                let all = (0..height).flat_map(|v| (0..width).map(move |u| (u, v)));
                all.filter(|&(u, v)| (u, v) != (x, y) && near(u, x) && near(v, y))
                    .map(|(u, v)| at(u, v))
                    .collect()
            })
            .collect();
        let patches = groups::neighbours(&coordinates(&neighbours), PAIRS_PER_PATCH);
        assert_eq!(patches.iter().map(Vec::len).sum::<usize>(), width * height);
        for patch in patches {
            let side = |value: &dyn Fn(usize) -> usize| {
                let values = patch.iter().map(|&i| value(i));
                values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
            };
            let (x, y) = (side(&|i| i % width), side(&|i| i / width));
            assert!(
                x < 12 && y < 12,
                "a patch of {} pairs spans {x} × {y}",
                patch.len()
            );
        }
    }
}
