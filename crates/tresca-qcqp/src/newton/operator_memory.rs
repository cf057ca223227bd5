//! What is known of A. It outlives a solve: another right-hand side, other
//! bounds or another multiplier change nothing about A.

use super::recycled_products::RecycledProducts;
use crate::error::QcqpError;
use crate::operator::dual_operator::DualOperator;
use crate::operator::local_model::LocalModel;
use crate::singular::rank::is_singular;
use crate::spectrum::{self, Spectrum};
use tresca_la::vector::dot;

/// The estimate of σmax, and what preconditions Newton systems.
pub(crate) struct OperatorMemory {
    pub spectrum: Spectrum,
    /// A is small, explicit and singular.
    pub singular: bool,
    newton: Option<NewtonMemory>,
}

/// The two parts of the preconditioner: D and the recycled products.
pub(crate) struct NewtonMemory {
    pub model: LocalModel,
    pub recycled: RecycledProducts,
    /// Memory of one preconditioner after another.
    pub workspace: Vec<f64>,
}

impl OperatorMemory {
    fn new(spectrum: Spectrum, singular: bool) -> Self {
        Self {
            spectrum,
            singular,
            newton: None,
        }
    }

    /// What is kept already, or learnt now by a few products.
    ///
    /// # Errors
    /// When A is zero, not symmetric, not positive semidefinite or not finite.
    pub fn of<'m>(
        kept: &'m mut Option<Self>,
        operator: &mut dyn DualOperator,
    ) -> Result<&'m mut Self, QcqpError> {
        match kept {
            Some(memory) => Ok(memory),
            none => {
                let spectrum = spectrum::estimate(operator)?;
                Ok(none.insert(Self::new(spectrum, is_singular(operator))))
            }
        }
    }

    /// What preconditions Newton systems; the local model is computed when first asked for, since
    /// not every method wants it. Costs no product: the Lanczos vectors are the first ones kept.
    /// When the store is full, what is there stays: the early directions are the smooth modes that
    /// every active set shares.
    pub fn newton(&mut self, operator: &dyn DualOperator, capacity: usize) -> &mut NewtonMemory {
        let spectrum = &self.spectrum;
        let newton = self.newton.get_or_insert_with(|| {
            let mut recycled = RecycledProducts::new(capacity);
            for (v, product) in spectrum.basis.iter().zip(&spectrum.products) {
                recycled.offer(v, product);
            }
            NewtonMemory {
                model: calibrated_model(operator, spectrum),
                recycled,
                workspace: Vec::new(),
            }
        });
        newton.recycled.set_capacity(capacity);
        newton
    }
}

/// The operator's model of itself, scaled to fit A on the first Lanczos vector.
fn calibrated_model(operator: &dyn DualOperator, spectrum: &Spectrum) -> LocalModel {
    let model = operator.local_model();
    let (v, product) = (&spectrum.basis[0], &spectrum.products[0]);
    let theta = dot(v, product) / model.quadratic(v);
    model.scaled(theta)
}
