//! What the methods know of A.

use super::local_model::LocalModel;
use std::time::{Duration, Instant};
use tresca_la::{LinearOperator, SymmetricEntries};

/// Multiplications: how many, and how long they took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// n_A.
    pub count: usize,
    /// Wall-clock time in them.
    pub time: Duration,
}

impl std::ops::Sub for Tally {
    type Output = Tally;

    fn sub(self, earlier: Tally) -> Tally {
        Tally {
            count: self.count - earlier.count,
            time: self.time - earlier.time,
        }
    }
}

/// A symmetric positive semidefinite operator that counts its own multiplications.
///
/// n_A, the number of multiplications by A, is the cost measure of the field.
/// An implementation provides [`multiply`](DualOperator::multiply) and a
/// tally; everyone calls [`apply`](DualOperator::apply), which does both.
/// Products must be deterministic: the same x gives the same y, bit for bit,
/// whoever of the threads computes what.
pub trait DualOperator: Send {
    /// Order of A.
    fn dim(&self) -> usize;

    /// y ← A x without counting. Overwrites y and does not read it.
    /// For implementations; everyone else wants [`apply`](DualOperator::apply).
    fn multiply(&mut self, x: &[f64], y: &mut [f64]);

    /// The multiplications since the operator was made.
    fn tally(&mut self) -> &mut Tally;

    /// A cheap block diagonal model of A, right up to a common factor.
    fn local_model(&self) -> LocalModel;

    /// A itself, if the engine holds it. Newton systems are then solved directly.
    fn explicit(&self) -> Option<&dyn SymmetricEntries> {
        None
    }

    /// What is added to the diagonal of a block of A before it is factored: more than 0 where A is singular.
    fn shift_of_factors(&self) -> f64 {
        0.0
    }

    /// What a product may be wrong by, relative to σmax ‖x‖ and as its solvers state it. The default says: as
    /// exact as rounding allows.
    fn accuracy(&self) -> f64 {
        f64::EPSILON
    }

    /// y ← A x, counted.
    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        let begin = Instant::now();
        self.multiply(x, y);
        let tally = self.tally();
        tally.count += 1;
        tally.time += begin.elapsed();
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
