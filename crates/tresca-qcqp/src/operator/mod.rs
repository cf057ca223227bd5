//! The dual operator A = B K⁻¹ Bᵀ and its engines.
//!
//! | engine | one multiplication | set-up |
//! |---|---|---|
//! | [`Factored`] | two sweeps of the whole factor of K | none beyond the factor |
//! | [`Condensed`] | two triangular solves with the trailing block | contact dofs ordered last |
//! | [`Dense`] | one symmetric matrix–vector product | the matrix, formed once |

mod dense;

pub use dense::Dense;

use faer::MatRef;
use tresca_la::LinearOperator;

/// A symmetric positive semidefinite operator that counts its own multiplications.
///
/// n_A, the number of multiplications by A, is the cost measure of the field.
/// An implementation provides [`multiply`](DualOperator::multiply) and a
/// counter; everyone calls [`apply`](DualOperator::apply), which does both.
/// Products must be deterministic: the same x gives the same y, bit for bit,
/// whatever the number of threads decides about who computes what.
pub trait DualOperator: Send {
    /// Order of A.
    fn dim(&self) -> usize;

    /// y ← A x without counting. Overwrites y and does not read it.
    /// For implementations; everyone else wants [`apply`](DualOperator::apply).
    fn multiply(&mut self, x: &[f64], y: &mut [f64]);

    /// The counter.
    fn counter(&mut self) -> &mut usize;

    /// A cheap estimate of the diagonal of A, positive, right up to a common factor
    /// and a few units either way: it scales the unknowns of the inner systems.
    fn diagonal_estimate(&self) -> Vec<f64>;

    /// A itself, both triangles, if the engine holds it. Newton systems are then solved directly.
    fn explicit(&self) -> Option<MatRef<'_, f64>> {
        None
    }

    /// y ← A x, counted.
    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        *self.counter() += 1;
        self.multiply(x, y);
    }
}

impl LinearOperator for dyn DualOperator + '_ {
    fn dim(&self) -> usize {
        DualOperator::dim(self)
    }

    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        DualOperator::apply(self, x, y);
    }
}
