//! A with something added to its diagonal.

use crate::operator::dual_operator::{DualOperator, Tally};
use crate::operator::local_model::LocalModel;
use tresca_la::SymmetricEntries;

/// What is added to the diagonal of A, in the units of A.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shift {
    /// In products.
    pub products: f64,
    /// Where blocks of A are factored: with at least that of the products.
    pub factors: f64,
}

/// A + εI in products; blocks of it are factored with another ε.
pub(crate) struct Shifted<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub shift: Shift,
}

impl DualOperator for Shifted<'_> {
    fn dim(&self) -> usize {
        self.operator.dim()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.operator.multiply(x, y);
        if self.shift.products > 0.0 {
            tresca_la::vector::axpy(self.shift.products, x, y);
        }
    }

    fn tally(&mut self) -> &mut Tally {
        self.operator.tally()
    }

    fn local_model(&self) -> LocalModel {
        self.operator.local_model()
    }

    fn explicit(&self) -> Option<&dyn SymmetricEntries> {
        self.operator.explicit()
    }

    fn shift_of_factors(&self) -> f64 {
        self.shift.factors
    }

    fn accuracy(&self) -> f64 {
        self.operator.accuracy()
    }
}
