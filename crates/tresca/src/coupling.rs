//! Products with the coupling matrix B on slices.

use faer::sparse::SparseRowMatRef;

/// y ← y + B x.
pub(crate) fn add_product(b: SparseRowMatRef<'_, usize, f64>, x: &[f64], y: &mut [f64]) {
    for (row, y) in y.iter_mut().enumerate() {
        for (column, value) in b.col_idx_of_row(row).zip(b.val_of_row(row)) {
            *y += value * x[column];
        }
    }
}

/// y ← y + Bᵀ x.
pub(crate) fn add_transposed_product(b: SparseRowMatRef<'_, usize, f64>, x: &[f64], y: &mut [f64]) {
    for (row, &x) in x.iter().enumerate() {
        for (column, value) in b.col_idx_of_row(row).zip(b.val_of_row(row)) {
            y[column] += value * x;
        }
    }
}
