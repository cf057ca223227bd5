//! Groups of unknowns for the local model.

/// The unknowns of contact pairs in groups, for λ = [λν (m); λτ ((d−1) m)] in d dimensions:
/// `pairs` lists the pairs of each group.
pub fn unknowns_of_pairs(pairs: &[Vec<usize>], dimension: usize) -> Vec<Vec<usize>> {
    let m: usize = pairs.iter().map(Vec::len).sum();
    let tangents = dimension - 1;
    let of_group = |group: &Vec<usize>| {
        let normals = group.iter().copied();
        normals
            .chain(
                group
                    .iter()
                    .flat_map(|i| (0..tangents).map(move |t| m + tangents * i + t)),
            )
            .collect()
    };
    pairs.iter().map(of_group).collect()
}

/// Groups of at most `largest` neighbouring points, by recursive bisection
/// across the longest side of the bounding box. Deterministic.
///
/// # Panics
/// When `largest` is 0.
pub fn neighbours(points: &[[f64; 3]], largest: usize) -> Vec<Vec<usize>> {
    assert!(largest > 0, "a group holds at least one point");
    let mut groups = Vec::new();
    let mut pending = vec![(0..points.len()).collect::<Vec<_>>()];
    while let Some(mut group) = pending.pop() {
        if group.len() <= largest {
            if !group.is_empty() {
                groups.push(group);
            }
            continue;
        }
        let axis = longest_axis(points, &group);
        group.sort_by(|&a, &b| points[a][axis].total_cmp(&points[b][axis]));
        pending.push(group.split_off(group.len() / 2));
        pending.push(group);
    }
    groups
}

fn longest_axis(points: &[[f64; 3]], group: &[usize]) -> usize {
    let side = |axis: usize| {
        let coordinates = || group.iter().map(|&i| points[i][axis]);
        coordinates().fold(f64::NEG_INFINITY, f64::max)
            - coordinates().fold(f64::INFINITY, f64::min)
    };
    // The first of equal sides.
    (1..3).fold(
        0,
        |best, axis| if side(axis) > side(best) { axis } else { best },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_partition_a_grid_into_neighbours() {
        let points: Vec<[f64; 3]> = (0..120)
            .map(|i| [(i % 12) as f64, (i / 12) as f64, 1.0])
            .collect();
        let groups = neighbours(&points, 24);
        let mut all: Vec<usize> = groups.concat();
        all.sort_unstable();
        assert_eq!(all, (0..120).collect::<Vec<_>>());
        for group in &groups {
            assert!(group.len() <= 24 && group.len() > 11);
            let reach = group.iter().map(|&i| points[i][0]).fold(0.0, f64::max)
                - group.iter().map(|&i| points[i][0]).fold(99.0, f64::min);
            assert!(reach <= 5.0, "a group reaches over {reach}");
        }
        assert!(neighbours(&[], 4).is_empty());
        // Points that coincide are still separated.
        assert_eq!(neighbours(&[[0.0; 3]; 5], 1).len(), 5);
    }

    #[test]
    fn pairs_become_unknowns() {
        let pairs = vec![vec![1], vec![0, 2]];
        assert_eq!(
            unknowns_of_pairs(&pairs, 3),
            [vec![1, 5, 6], vec![0, 2, 3, 4, 7, 8]]
        );
        assert_eq!(unknowns_of_pairs(&pairs, 2), [vec![1, 4], vec![0, 2, 3, 5]]);
    }
}
