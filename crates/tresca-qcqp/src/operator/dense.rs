//! A as a dense matrix.

use super::dual_operator::{DualOperator, Tally};
use super::local_model::LocalModel;
use tresca_la::{PackedLower, SymmetricEntries};

/// An explicit symmetric matrix A; one multiplication reads its triangle once.
#[derive(Clone, Debug)]
pub struct Dense {
    matrix: PackedLower,
    local_model: LocalModel,
    tally: Tally,
}

impl Dense {
    /// From the lower triangle of A. Its diagonal is the local model.
    pub fn new(matrix: PackedLower) -> Self {
        let diagonal = (0..matrix.order()).map(|i| matrix.get(i, i)).collect();
        Self::with_local_model(matrix, LocalModel::Diagonal(diagonal))
    }

    /// From the lower triangle of A, with a better local model than its
    /// diagonal. Diagonal blocks of A itself are none: they hold the global modes
    /// already, which the methods add from the products they have seen.
    pub fn with_local_model(matrix: PackedLower, local_model: LocalModel) -> Self {
        Self {
            matrix,
            local_model,
            tally: Tally::default(),
        }
    }
}

impl DualOperator for Dense {
    fn dim(&self) -> usize {
        self.matrix.order()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.matrix.symmetric_mul(x, y);
    }

    fn tally(&mut self) -> &mut Tally {
        &mut self.tally
    }

    fn local_model(&self) -> LocalModel {
        self.local_model.clone()
    }

    fn explicit(&self) -> Option<&dyn SymmetricEntries> {
        Some(&self.matrix)
    }
}
