//! How K⁻¹ is applied, whatever it is made of.

pub mod cholesky;
mod trailing;

pub use trailing::TrailingBlock;

use faer::MatMut;

/// K⁻¹ of one body: K symmetric positive definite, made once, applied often.
///
/// Solves must be deterministic: the same right-hand side gives the same solution, bit for bit, whoever of the
/// threads computes what.
pub trait BodySolver: Send + Sync {
    /// Order n of K.
    fn order(&self) -> usize;

    /// Every column ← K⁻¹ column, in the numbering of K.
    ///
    /// # Panics
    /// When the columns have not the length n.
    fn solve_many(&self, columns: MatMut<'_, f64>);

    /// x ← K⁻¹ x.
    ///
    /// # Panics
    /// When x has not the length n.
    fn solve_in_place(&self, x: &mut [f64]) {
        let order = x.len();
        self.solve_many(MatMut::from_column_major_slice_mut(x, order, 1));
    }

    /// The factor L_cc of the Schur complement on the trailing dofs, copied out (8 bytes per entry of the
    /// triangle); of order 0 when the solver was made without trailing dofs. `None` when there is no factor to take
    /// it from.
    fn trailing(&self) -> Option<TrailingBlock> {
        None
    }

    /// What it took to make.
    fn work(&self) -> SolverWork;

    /// The backward error of a solve, ‖K x − f‖/(‖K‖ ‖x‖), up to a factor of the size of rounding errors in n
    /// terms. The default says: as exact as rounding allows.
    fn accuracy(&self) -> f64 {
        f64::EPSILON
    }
}

/// What a solver took to make.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolverWork {
    /// Numbers that a solve reads: of a factor L its nonzeros, diagonal included.
    pub nonzeros: u64,
    /// Floating-point operations; a multiplication and an addition count as two.
    pub flops: f64,
}
