//! Patches of neighbouring pairs without any geometry: neighbours in the graph of K.

use tresca_qcqp::operator::groups;

use super::matrix::Matrix;
use crate::engine::PAIRS_PER_PATCH;

/// The unknowns in patches, for the local model of A: by the points of the pairs where these are known, by
/// the graph of K else.
pub(super) fn patches(
    k: &Matrix,
    b: &Matrix,
    dimension: usize,
    points: Option<&[[f64; 3]]>,
) -> Vec<Vec<usize>> {
    let pairs = b.rows() / dimension;
    let patches = match points {
        Some(points) => groups::neighbours(points, PAIRS_PER_PATCH),
        None => grown(&neighbours(k, b, pairs), PAIRS_PER_PATCH),
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

/// Compact groups of at most `largest` neighbours, grown one by one: from a pair at the edge of what is
/// left, always by the pair that most of the group are neighbours of.
fn grown(neighbours: &[Vec<usize>], largest: usize) -> Vec<Vec<usize>> {
    // How many neighbours of each pair are in no group yet.
    let mut free: Vec<usize> = neighbours.iter().map(Vec::len).collect();
    let mut taken = vec![false; neighbours.len()];
    // Links of a candidate to the group that grows; 0 of all others.
    let mut links = vec![0_usize; neighbours.len()];
    let mut groups = Vec::new();
    while let Some(seed) = (0..taken.len())
        .filter(|&i| !taken[i])
        .min_by_key(|&i| (free[i], i))
    {
        let mut group = Vec::with_capacity(largest);
        let mut candidates = vec![seed];
        while group.len() < largest {
            // Few neighbours left: a pair that would be left behind alone.
            let rank = |&i: &usize| (links[i], std::cmp::Reverse((free[i], i)));
            let Some(at) = (0..candidates.len()).max_by_key(|&at| rank(&candidates[at])) else {
                break;
            };
            let pair = candidates.swap_remove(at);
            taken[pair] = true;
            group.push(pair);
            for &other in &neighbours[pair] {
                free[other] -= 1;
                if !taken[other] {
                    if links[other] == 0 {
                        candidates.push(other);
                    }
                    links[other] += 1;
                }
            }
        }
        candidates.into_iter().for_each(|i| links[i] = 0);
        groups.push(group);
    }
    groups
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
        let patches = grown(&neighbours, PAIRS_PER_PATCH);
        let mut all = patches.concat();
        all.sort_unstable();
        assert_eq!(all, (0..width * height).collect::<Vec<_>>());
        assert!(patches.len() < 2 * width * height / PAIRS_PER_PATCH);
        assert_eq!(grown(&[vec![], vec![2], vec![1]], 1).len(), 3);
        for patch in patches {
            let side = |value: &dyn Fn(usize) -> usize| {
                let values = patch.iter().map(|&i| value(i));
                values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
            };
            let (x, y) = (side(&|i| i % width), side(&|i| i / width));
            assert!(
                x < 10 && y < 10,
                "a patch of {} pairs spans {x} × {y}",
                patch.len()
            );
        }
    }
}
