//! A through the whole stiffness of every body.

use super::bodies::Bodies;
use super::coupling::Coupling;
use super::dual_operator::{DualOperator, Tally};
use super::local_model::{self, LocalModel};
use faer::Mat;
use std::sync::Arc;
use tresca_la::{BodySolver, SymmetricMatrix};

/// A = Σ B_i K_i⁻¹ B_iᵀ, as it is written: one multiplication solves once with the
/// stiffness of every body. Needs no special ordering and no further
/// memory; the engine for few multiplications.
pub struct Factored {
    bodies: Bodies<Arc<dyn BodySolver>>,
    local_model: LocalModel,
    tally: Tally,
}

impl Factored {
    /// From the stiffness of every body, its solver and B_i. The stiffness is
    /// only read here; `groups` partitions the unknowns for the local model, the
    /// components of a disc together.
    ///
    /// # Panics
    /// When the sizes do not fit, there is no body, or `groups` is no partition.
    pub fn new(
        bodies: Vec<(&SymmetricMatrix, Arc<dyn BodySolver>, Coupling)>,
        groups: &[Vec<usize>],
    ) -> Self {
        let (stiffness, parts): (Vec<_>, Vec<_>) = bodies
            .into_iter()
            .map(|(stiffness, solver, coupling)| (stiffness, (solver, coupling)))
            .unzip();
        let bodies = Bodies::new(parts.into_iter(), |solver| solver.order(), groups);
        for (stiffness, body) in stiffness.iter().zip(bodies.iter()) {
            assert_eq!(
                stiffness.order(),
                body.solver.order(),
                "the solver must be that of the stiffness"
            );
        }
        let local_model = local_model::from_groups(groups, &bodies.couplings(), |body, dofs| {
            local_model::factor(&principal_block(stiffness[body], dofs))
        });
        Self {
            bodies,
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
        self.bodies.rows()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.bodies
            .multiply(x, y, |solver, x| solver.solve_in_place(x));
    }

    fn accuracy(&self) -> f64 {
        let stated = self.bodies.iter().map(|body| body.solver.accuracy());
        stated.fold(f64::EPSILON, f64::max)
    }

    fn tally(&mut self) -> &mut Tally {
        &mut self.tally
    }

    fn local_model(&self) -> LocalModel {
        self.local_model.clone()
    }
}
