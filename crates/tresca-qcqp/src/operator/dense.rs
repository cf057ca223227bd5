//! A as a dense matrix.

use super::{DualOperator, LocalModel};
use tresca_la::PackedLower;

/// An explicit symmetric matrix A; one multiplication reads its triangle once.
#[derive(Clone, Debug)]
pub struct Dense {
    matrix: PackedLower,
    count: usize,
}

impl Dense {
    /// From the lower triangle of A.
    pub fn new(matrix: PackedLower) -> Self {
        Self { matrix, count: 0 }
    }
}

impl DualOperator for Dense {
    fn dim(&self) -> usize {
        self.matrix.order()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.matrix.symmetric_mul(x, y);
    }

    fn counter(&mut self) -> &mut usize {
        &mut self.count
    }

    fn local_model(&self) -> LocalModel {
        LocalModel::Diagonal((0..self.dim()).map(|i| self.matrix.get(i, i)).collect())
    }

    fn explicit(&self) -> Option<&PackedLower> {
        Some(&self.matrix)
    }
}
