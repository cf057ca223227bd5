//! The matrix in elimination order.

use crate::ordering::Ordering;
use crate::symmetric::SymmetricMatrix;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};

/// The lower triangle of P K Pᵀ.
pub(super) fn lower(matrix: &SymmetricMatrix, ordering: &Ordering) -> SparseColMat<usize, f64> {
    let source = matrix.lower();
    let (pointers, rows, origin) = gather(matrix, ordering, |a, b| (a.max(b), a.min(b)));
    let values = origin.into_iter().map(|k| source.val()[k]).collect();
    let order = matrix.order();
    SparseColMat::new(
        SymbolicSparseColMat::new_checked(order, order, pointers, None, rows),
        values,
    )
}

/// The pattern of the upper triangle of P K Pᵀ.
pub(super) fn upper_pattern(
    matrix: &SymmetricMatrix,
    ordering: &Ordering,
) -> SymbolicSparseColMat<usize> {
    let (pointers, rows, _) = gather(matrix, ordering, |a, b| (a.min(b), a.max(b)));
    let order = matrix.order();
    SymbolicSparseColMat::new_checked(order, order, pointers, None, rows)
}

/// Column pointers, ascending row numbers, and for each entry its place in the
/// stored matrix; `orient` turns a pair of new numbers into (row, column).
fn gather(
    matrix: &SymmetricMatrix,
    ordering: &Ordering,
    orient: impl Fn(usize, usize) -> (usize, usize),
) -> (Vec<usize>, Vec<usize>, Vec<usize>) {
    let source = matrix.lower();
    let order = matrix.order();
    let position = ordering.from_original();
    let entries = |old_column: usize| {
        source
            .col_range(old_column)
            .zip(source.row_idx_of_col(old_column))
            .map(move |(k, old_row)| (k, old_row, old_column))
    };
    // Two stable counting sorts, by row and then by column, leave the rows of
    // every column ascending.
    let mut row_pointers = vec![0; order + 1];
    let mut pointers = vec![0; order + 1];
    for (_, a, b) in (0..order).flat_map(entries) {
        let (row, column) = orient(position[a], position[b]);
        row_pointers[row + 1] += 1;
        pointers[column + 1] += 1;
    }
    for i in 0..order {
        row_pointers[i + 1] += row_pointers[i];
        pointers[i + 1] += pointers[i];
    }
    let count = pointers[order];
    let mut by_row = vec![(0_usize, 0_usize); count];
    let mut next = row_pointers.clone();
    for (k, a, b) in (0..order).flat_map(entries) {
        let (row, column) = orient(position[a], position[b]);
        by_row[next[row]] = (column, k);
        next[row] += 1;
    }
    let mut next = pointers.clone();
    let (mut rows, mut origin) = (vec![0; count], vec![0; count]);
    for row in 0..order {
        for &(column, k) in &by_row[row_pointers[row]..row_pointers[row + 1]] {
            rows[next[column]] = row;
            origin[next[column]] = k;
            next[column] += 1;
        }
    }
    (pointers, rows, origin)
}
