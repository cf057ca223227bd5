//! The dual operator A = B K⁻¹ Bᵀ and its engines.
//!
//! | engine | one multiplication | set-up |
//! |---|---|---|
//! | [`Factored`] | two sweeps of the whole factor of K | none beyond the factor |
//! | [`Condensed`] | two triangular solves with the trailing block | contact dofs ordered last |
//! | [`Dense`] | one symmetric matrix–vector product | the matrix, formed once |

mod condensed;
mod coupling;
mod dense;
mod factored;
pub mod groups;
mod local_model;

pub use condensed::Condensed;
pub use coupling::Coupling;
pub use dense::Dense;
pub use factored::Factored;
pub use local_model::{LocalBlock, LocalModel};

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

/// The number of rows that all B_i share.
fn common_rows<'a>(couplings: impl Iterator<Item = &'a Coupling>) -> usize {
    let mut rows: Vec<usize> = couplings.map(Coupling::rows).collect();
    rows.dedup();
    assert_eq!(
        rows.len(),
        1,
        "bodies, at least one, must have the same unknowns as rows of B"
    );
    rows[0]
}

/// Panics unless every one of `unknowns` unknowns is in exactly one group.
fn assert_partition(groups: &[Vec<usize>], unknowns: usize) {
    let mut seen = vec![false; unknowns];
    for &i in groups.iter().flatten() {
        assert!(
            !std::mem::replace(&mut seen[i], true),
            "unknown {i} is in two groups"
        );
    }
    assert!(seen.iter().all(|&s| s), "an unknown is in no group");
}

/// y ← the sum of the products, in their order.
fn sum_in_order<'a>(products: impl Iterator<Item = &'a [f64]>, y: &mut [f64]) {
    y.fill(0.0);
    for product in products {
        for (y, p) in y.iter_mut().zip(product) {
            *y += p;
        }
    }
}
