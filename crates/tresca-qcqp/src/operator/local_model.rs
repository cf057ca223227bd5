//! A cheap model of A near the diagonal.

use super::coupling::Coupling;
use faer::linalg::matmul::matmul;
use faer::linalg::solvers::{Llt, Solve};
use faer::{Accum, Mat, Par, Side};
use rayon::prelude::*;

/// A symmetric positive semidefinite, block diagonal model D of A, right up to a
/// common factor: what a group of unknowns does to itself. It preconditions the
/// inner systems where no product with A has been seen yet.
#[derive(Clone, Debug)]
pub enum LocalModel {
    /// D is diagonal.
    Diagonal(Vec<f64>),
    /// D has dense blocks; every unknown belongs to exactly one, the components of a disc to the same.
    Blocks(Vec<LocalBlock>),
}

/// A dense block of the model.
#[derive(Clone, Debug)]
pub struct LocalBlock {
    /// Its unknowns.
    pub unknowns: Vec<usize>,
    /// Its matrix, both triangles.
    pub matrix: Mat<f64>,
}

impl LocalModel {
    /// vᵀ D v.
    pub(crate) fn quadratic(&self, v: &[f64]) -> f64 {
        match self {
            LocalModel::Diagonal(d) => v.iter().zip(d).map(|(v, d)| v * v * d).sum(),
            LocalModel::Blocks(blocks) => blocks.iter().map(|block| block.quadratic(v)).sum(),
        }
    }

    /// θ D, with every diagonal entry at least a rounding error of the largest: an unknown that
    /// moves nothing has a zero row, and any positive scale serves it.
    pub(crate) fn scaled(mut self, theta: f64) -> Self {
        let least = |largest: f64| f64::EPSILON * largest;
        match &mut self {
            LocalModel::Diagonal(d) => {
                let least = least(d.iter().copied().fold(0.0, f64::max));
                d.iter_mut().for_each(|d| *d = theta * d.max(least));
            }
            LocalModel::Blocks(blocks) => {
                let largest = blocks
                    .iter()
                    .flat_map(|block| block.diagonal())
                    .fold(0.0, f64::max);
                for block in blocks {
                    block.matrix *= faer::Scale(theta);
                    for i in 0..block.unknowns.len() {
                        block.matrix[(i, i)] += theta * least(largest);
                    }
                }
            }
        }
        self
    }
}

impl LocalBlock {
    fn diagonal(&self) -> impl Iterator<Item = f64> {
        (0..self.unknowns.len()).map(|i| self.matrix[(i, i)])
    }

    fn quadratic(&self, v: &[f64]) -> f64 {
        let entry =
            |i: usize, j: usize| v[self.unknowns[i]] * self.matrix[(i, j)] * v[self.unknowns[j]];
        let order = self.unknowns.len();
        (0..order)
            .map(|j| (0..order).map(|i| entry(i, j)).sum::<f64>())
            .sum()
    }
}

/// The model Σ over the bodies of B_G (M_JJ)⁻¹ B_Gᵀ for every group G of
/// unknowns, J the dofs it touches and M the body's stiffness or its Schur
/// complement S: the compliance of the group with all other contact dofs held,
/// so that it holds near fields only and is never above the true one.
///
/// `principal(body, J)` returns the factor of M_JJ (`None` if it is not positive definite,
/// which leaves that body out).
pub(super) fn from_groups(
    groups: &[Vec<usize>],
    couplings: &[&Coupling],
    principal: impl Fn(usize, &[usize]) -> Option<Llt<f64>> + Sync,
) -> LocalModel {
    let blocks = groups.par_iter().map(|group| {
        let mut matrix = Mat::zeros(group.len(), group.len());
        for (body, coupling) in couplings.iter().enumerate() {
            let mut dofs: Vec<usize> = group
                .iter()
                .flat_map(|&i| coupling.row(i).map(|(j, _)| j))
                .collect();
            dofs.sort_unstable();
            dofs.dedup();
            if dofs.is_empty() {
                continue;
            }
            let Some(factor) = principal(body, &dofs) else {
                continue;
            };
            let transposed = transposed_rows(coupling, group, &dofs);
            let mut solved = transposed.clone();
            factor.solve_in_place(solved.as_mut());
            matmul(
                matrix.as_mut(),
                Accum::Add,
                transposed.transpose(),
                solved.as_ref(),
                1.0,
                Par::Seq,
            );
        }
        LocalBlock {
            unknowns: group.clone(),
            matrix,
        }
    });
    LocalModel::Blocks(blocks.collect())
}

/// B_Gᵀ as a dense matrix, one row per dof of `dofs` (ascending).
fn transposed_rows(coupling: &Coupling, group: &[usize], dofs: &[usize]) -> Mat<f64> {
    let mut transposed = Mat::zeros(dofs.len(), group.len());
    for (column, &i) in group.iter().enumerate() {
        for (j, b) in coupling.row(i) {
            if let Ok(row) = dofs.binary_search(&j) {
                transposed[(row, column)] += b;
            }
        }
    }
    transposed
}

/// The Cholesky factor of a small matrix, if it has one.
pub(super) fn factor(matrix: &Mat<f64>) -> Option<Llt<f64>> {
    Llt::new(matrix.as_ref(), Side::Lower).ok()
}
