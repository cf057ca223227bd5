//! Symmetric sparse matrices, stored as their lower triangle.

use faer::sparse::{SparseColMat, SparseColMatRef};

/// A symmetric sparse matrix of which only the lower triangle (diagonal
/// included) is stored, by columns, rows ascending within a column.
#[derive(Clone, Debug)]
pub struct SymmetricMatrix {
    lower: SparseColMat<usize, f64>,
}

impl SymmetricMatrix {
    /// Wraps a lower triangle.
    ///
    /// # Panics
    /// When `lower` is not square, or an entry lies above the diagonal.
    pub fn from_lower(lower: SparseColMat<usize, f64>) -> Self {
        assert_eq!(lower.nrows(), lower.ncols(), "a symmetric matrix is square");
        for j in 0..lower.ncols() {
            assert!(
                lower.as_ref().row_idx_of_col(j).all(|i| i >= j),
                "column {j} has an entry above the diagonal"
            );
        }
        Self { lower }
    }

    /// Order n.
    pub fn order(&self) -> usize {
        self.lower.ncols()
    }

    /// The stored lower triangle.
    pub fn lower(&self) -> SparseColMatRef<'_, usize, f64> {
        self.lower.as_ref()
    }

    /// y ← K x.
    pub fn mul(&self, x: &[f64], y: &mut [f64]) {
        assert_eq!(x.len(), self.order());
        assert_eq!(y.len(), self.order());
        y.fill(0.0);
        let lower = self.lower.as_ref();
        for j in 0..self.order() {
            let mut own = 0.0;
            for (i, &a) in lower.row_idx_of_col(j).zip(lower.val_of_col(j)) {
                y[i] += a * x[j];
                if i > j {
                    own += a * x[i];
                }
            }
            y[j] += own;
        }
    }

    /// Multiplies all entries by a factor.
    pub fn scale(&mut self, factor: f64) {
        self.lower.val_mut().iter_mut().for_each(|a| *a *= factor);
    }

    /// The diagonal, length n.
    pub fn diagonal(&self) -> Vec<f64> {
        let lower = self.lower.as_ref();
        (0..self.order())
            .map(|j| {
                lower
                    .row_idx_of_col(j)
                    .zip(lower.val_of_col(j))
                    .find_map(|(i, &a)| (i == j).then_some(a))
                    .unwrap_or(0.0)
            })
            .collect()
    }
}
