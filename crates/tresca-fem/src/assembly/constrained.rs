//! K̂ = CᵀKC for a C that is a selection but for the rows of dependent dofs.

use super::sum::sum_of_columns;
use crate::dofs::DofMap;
use tresca_la::SymmetricMatrix;

/// CᵀKC over the free dofs of `dofs`, of a K over those of `kept`, the same without equations.
///
/// Entries between two free dofs stay where they are. Every other entry K_ij is the block C_iᵀ K_ij C_j, sorted
/// and added afterwards, in the order of K: there are as few as there are neighbours of dependent dofs.
pub(super) fn constrained(k: &SymmetricMatrix, kept: &DofMap, dofs: &DofMap) -> SymmetricMatrix {
    let lower = k.lower();
    let n = dofs.free_len();
    let column = |j| lower.row_idx_of_col(j).zip(lower.val_of_col(j));
    let mut added: Vec<(usize, usize, f64)> = Vec::new();
    // By free dof the column of K.
    let mut column_of = vec![None; n];
    for j in 0..k.order() {
        let full = kept.full_of_free(j);
        let free = dofs.free_of_full(full);
        if let Some(free) = free {
            column_of[free] = Some(j);
        }
        for (i, &value) in column(j) {
            let other = kept.full_of_free(i);
            if free.is_some() && dofs.free_of_full(other).is_some() {
                continue;
            }
            for (a, of_a) in dofs.row(other) {
                for (b, of_b) in dofs.row(full) {
                    let part = of_a * value * of_b;
                    match (i == j, a == b) {
                        // Both triangles of K have it: (a, b) and (b, a) of a diagonal entry …
                        (true, false) if a < b => {}
                        // … K_ij and K_ji of a diagonal entry of the product.
                        (false, true) => added.push((a, a, 2.0 * part)),
                        _ => added.push((a.min(b), a.max(b), part)),
                    }
                }
            }
        }
    }
    added.sort_by_key(|&(column, row, _)| (column, row));
    let starts: Vec<usize> = (0..=n)
        .map(|j| added.partition_point(|&(column, ..)| column < j))
        .collect();
    sum_of_columns(
        n,
        lower.compute_nnz() + added.len(),
        |free| {
            let entries = column_of[free].into_iter().flat_map(column);
            entries
                .filter_map(|(i, &value)| Some((dofs.free_of_full(kept.full_of_free(i))?, value)))
        },
        |free| {
            let entries = added[starts[free]..starts[free + 1]].iter();
            entries.map(|&(_, row, value)| (row, value))
        },
    )
}
