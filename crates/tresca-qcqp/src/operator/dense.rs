//! A as a dense matrix.

use super::DualOperator;
use faer::linalg::matmul::matmul;
use faer::{Accum, ColMut, ColRef, Mat, MatRef, Par};

/// A explicit symmetric matrix.
pub struct Dense {
    matrix: Mat<f64>,
    count: usize,
}

impl Dense {
    /// From the matrix, both triangles filled.
    ///
    /// # Panics
    /// When the matrix is not square.
    pub fn new(matrix: Mat<f64>) -> Self {
        assert_eq!(matrix.nrows(), matrix.ncols(), "A is square");
        Self { matrix, count: 0 }
    }
}

impl DualOperator for Dense {
    fn dim(&self) -> usize {
        self.matrix.nrows()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        matmul(
            ColMut::from_slice_mut(y),
            Accum::Replace,
            self.matrix.as_ref(),
            ColRef::from_slice(x),
            1.0,
            Par::Seq,
        );
    }

    fn counter(&mut self) -> &mut usize {
        &mut self.count
    }

    fn diagonal_estimate(&self) -> Vec<f64> {
        (0..self.dim()).map(|i| self.matrix[(i, i)]).collect()
    }

    fn explicit(&self) -> Option<MatRef<'_, f64>> {
        Some(self.matrix.as_ref())
    }
}
