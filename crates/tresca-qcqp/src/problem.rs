//! The dual problem.

use crate::error::check_vector;
use crate::{DualOperator, ProductSet, QcqpError};

/// min ½ λᵀAλ − λᵀb over λ ∈ Λ.
///
/// In contact terms λ are the contact forces, A maps them to relative
/// displacements, b is the relative displacement (minus the gap) without them,
/// and r(λ) = Aλ − b is the open gap and the negative slip.
pub struct DualProblem {
    operator: Box<dyn DualOperator>,
    rhs: Vec<f64>,
    set: ProductSet,
}

impl DualProblem {
    /// Puts the parts together: `operator` A, `rhs` b, `set` Λ.
    ///
    /// # Errors
    /// When the sizes differ or b is not finite.
    pub fn new(
        operator: impl DualOperator + 'static,
        rhs: Vec<f64>,
        set: ProductSet,
    ) -> Result<Self, QcqpError> {
        let dim = operator.dim();
        check_vector("the right-hand side b", &rhs, dim)?;
        if set.dimension() != dim {
            let (expected, found) = (dim, set.dimension());
            return Err(QcqpError::Dimension {
                what: "the feasible set",
                expected,
                found,
            });
        }
        Ok(Self {
            operator: Box::new(operator),
            rhs,
            set,
        })
    }

    /// Number of unknowns.
    pub fn dim(&self) -> usize {
        self.rhs.len()
    }

    /// A.
    pub fn operator(&self) -> &dyn DualOperator {
        &*self.operator
    }

    /// A, to multiply with.
    pub fn operator_mut(&mut self) -> &mut dyn DualOperator {
        &mut *self.operator
    }

    /// b.
    pub fn rhs(&self) -> &[f64] {
        &self.rhs
    }

    /// Λ.
    pub fn set(&self) -> &ProductSet {
        &self.set
    }

    /// The three parts at once, for the methods.
    pub(crate) fn parts(&mut self) -> (&mut dyn DualOperator, &[f64], &ProductSet) {
        (&mut *self.operator, &self.rhs, &self.set)
    }
}
