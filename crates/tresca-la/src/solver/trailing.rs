//! The trailing block of a factor: the Schur complement on the last dofs.

use crate::packed::PackedLower;
use crate::parallelism::Parallelism;
use faer::Mat;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::inverse;

/// The dense factor L_cc of the Schur complement S = L_cc L_ccᵀ of K on its
/// trailing dofs c. Because they are eliminated last, (K⁻¹)_cc = S⁻¹.
///
/// Vectors are in the order in which the trailing dofs were listed.
#[derive(Clone, Debug)]
pub struct TrailingBlock {
    factor: PackedLower,
}

impl TrailingBlock {
    /// From L_cc.
    pub fn new(factor: PackedLower) -> Self {
        Self { factor }
    }

    /// Number n_c of trailing dofs.
    pub fn order(&self) -> usize {
        self.factor.order()
    }

    /// L_cc, packed.
    pub fn factor(&self) -> &PackedLower {
        &self.factor
    }

    /// x ← (L_cc L_ccᵀ)⁻¹ x = (K⁻¹)_cc x.
    ///
    /// # Panics
    /// When x has not the length n_c.
    pub fn solve_in_place(&self, x: &mut [f64]) {
        self.factor.solve_lower_in_place(x);
        self.factor.solve_upper_in_place(x);
    }

    /// The symmetric matrix (K⁻¹)_cc, both triangles filled. About n_c³ flops;
    /// works in three dense matrices of order n_c.
    pub fn inverse(&self, parallelism: Parallelism) -> Mat<f64> {
        let order = self.order();
        let par = parallelism.to_faer();
        let factor = self.factor.to_dense();
        let mut result = Mat::zeros(order, order);
        let mut memory = MemBuffer::new(inverse::inverse_scratch::<f64>(order, par));
        inverse::inverse(
            result.as_mut(),
            factor.as_ref(),
            par,
            MemStack::new(&mut memory),
        );
        for j in 0..order {
            for i in 0..j {
                result[(i, j)] = result[(j, i)];
            }
        }
        result
    }
}
