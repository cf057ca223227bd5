//! The simple preconditioners.

use crate::operator::LinearOperator;

/// No preconditioning: z = r.
#[derive(Clone, Copy, Debug)]
pub struct Identity(pub usize);

impl LinearOperator for Identity {
    fn dim(&self) -> usize {
        self.0
    }

    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        y.copy_from_slice(x);
    }
}

/// Jacobi's preconditioner: z_i = r_i / d_i.
#[derive(Clone, Debug)]
pub struct InverseDiagonal {
    inverse: Vec<f64>,
}

impl InverseDiagonal {
    /// From the diagonal d of the matrix (not its inverse).
    ///
    /// # Panics
    /// When an entry is not positive: such a matrix is not positive definite.
    pub fn new(diagonal: &[f64]) -> Self {
        assert!(
            diagonal.iter().all(|&d| d > 0.0),
            "a positive definite matrix has a positive diagonal"
        );
        Self {
            inverse: diagonal.iter().map(|d| d.recip()).collect(),
        }
    }
}

impl LinearOperator for InverseDiagonal {
    fn dim(&self) -> usize {
        self.inverse.len()
    }

    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        for ((y, x), d) in y.iter_mut().zip(x).zip(&self.inverse) {
            *y = x * d;
        }
    }
}
