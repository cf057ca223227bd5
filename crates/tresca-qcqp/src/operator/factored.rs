//! A through the whole sparse factor of every body.

use super::local_model::{self, LocalModel};
use super::{Coupling, DualOperator, Tally};
use faer::Mat;
use rayon::prelude::*;
use std::sync::Arc;
use tresca_la::{SparseCholesky, SymmetricMatrix};

/// One body: the factor of K_i, and B_i on all its dofs.
struct Body {
    cholesky: Arc<SparseCholesky>,
    coupling: Coupling,
    displacement: Vec<f64>,
    product: Vec<f64>,
}

/// A = Σ B_i K_i⁻¹ B_iᵀ, as it is written: one multiplication sweeps twice
/// through the factor of every body. Needs no special ordering and no further
/// memory; the engine for few multiplications.
pub struct Factored {
    bodies: Vec<Body>,
    local_model: LocalModel,
    tally: Tally,
}

impl Factored {
    /// From the stiffness of every body, its factor and B_i. The stiffness is
    /// only read here; `groups` partitions the unknowns for the local model, the
    /// components of a disc together.
    ///
    /// # Panics
    /// When the sizes do not fit, there is no body, or `groups` is no partition.
    pub fn new(
        bodies: Vec<(&SymmetricMatrix, Arc<SparseCholesky>, Coupling)>,
        groups: &[Vec<usize>],
    ) -> Self {
        let rows = super::common_rows(bodies.iter().map(|(_, _, coupling)| coupling));
        super::assert_partition(groups, rows);
        let couplings: Vec<&Coupling> = bodies.iter().map(|(_, _, coupling)| coupling).collect();
        let local_model = local_model::from_groups(groups, &couplings, |body, dofs| {
            local_model::factor(&principal_block(bodies[body].0, dofs))
        });
        let body =
            |(stiffness, cholesky, coupling): (&SymmetricMatrix, Arc<SparseCholesky>, Coupling)| {
                assert_eq!(
                    stiffness.order(),
                    coupling.dofs(),
                    "B must have the body's dofs as columns"
                );
                assert_eq!(
                    cholesky.order(),
                    coupling.dofs(),
                    "the factor must be that of the stiffness"
                );
                let displacement = vec![0.0; coupling.dofs()];
                Body {
                    cholesky,
                    coupling,
                    displacement,
                    product: vec![0.0; rows],
                }
            };
        Self {
            bodies: bodies.into_iter().map(body).collect(),
            local_model,
            tally: Tally::default(),
        }
    }
}

/// K_JJ, J ascending.
fn principal_block(stiffness: &SymmetricMatrix, dofs: &[usize]) -> Mat<f64> {
    let lower = stiffness.lower();
    let mut block = Mat::zeros(dofs.len(), dofs.len());
    for (column, &j) in dofs.iter().enumerate() {
        for (i, value) in lower.row_idx_of_col(j).zip(lower.val_of_col(j)) {
            if let Ok(row) = dofs.binary_search(&i) {
                block[(row, column)] = *value;
                block[(column, row)] = *value;
            }
        }
    }
    block
}

impl DualOperator for Factored {
    fn dim(&self) -> usize {
        self.bodies[0].coupling.rows()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.bodies.par_iter_mut().for_each(|body| {
            body.coupling.transposed_mul(x, &mut body.displacement);
            body.cholesky.solve_in_place(&mut body.displacement);
            body.coupling.mul(&body.displacement, &mut body.product);
        });
        super::sum_in_order(self.bodies.iter().map(|body| &body.product[..]), y);
    }

    fn tally(&mut self) -> &mut Tally {
        &mut self.tally
    }

    fn local_model(&self) -> LocalModel {
        self.local_model.clone()
    }
}
