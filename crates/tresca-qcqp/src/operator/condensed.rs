//! A through the Schur complements on the contact dofs.

use super::bodies::Bodies;
use super::coupling::Coupling;
use super::dense::Dense;
use super::dual_operator::{DualOperator, Tally};
use super::local_model::{self, LocalModel};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use rayon::prelude::*;
use tresca_la::{PackedLower, Parallelism, TrailingBlock};

/// A = Σ B_i (L_cc L_ccᵀ)⁻¹ B_iᵀ: with the contact dofs ordered last, the
/// trailing block of the sparse factor is all of it that A needs. One
/// multiplication costs two dense triangular solves per body; the bodies are
/// computed side by side and summed in their order.
pub struct Condensed {
    bodies: Bodies<TrailingBlock>,
    groups: Vec<Vec<usize>>,
    tally: Tally,
}

impl Condensed {
    /// From the trailing block of every body and B_i restricted to the trailing
    /// dofs (columns in their order). `groups` partitions the unknowns for the
    /// local model: patches of neighbouring pairs are best, single pairs serve
    /// (see [`groups`](super::groups)); the components of a disc belong together.
    ///
    /// # Panics
    /// When the sizes do not fit, there is no body, or `groups` is no partition.
    pub fn new(bodies: Vec<(TrailingBlock, Coupling)>, groups: Vec<Vec<usize>>) -> Self {
        Self {
            bodies: Bodies::new(bodies.into_iter(), TrailingBlock::order, &groups),
            groups,
            tally: Tally::default(),
        }
    }

    /// Forms A as a dense matrix: about n_c³ flops per body for the inverse of
    /// S, and one product with B from either side. Pays when many
    /// multiplications follow. The local model stays the same.
    pub fn explicit(&self, parallelism: Parallelism) -> Dense {
        let rows = self.dim();
        let mut packed = PackedLower::zeros(rows);
        let inverses: Vec<Mat<f64>> = self
            .bodies
            .iter()
            .map(|body| body.solver.inverse(parallelism))
            .collect();
        // A few columns at a time, so that they need not all be held twice.
        const COLUMNS: usize = 64;
        for first in (0..rows).step_by(COLUMNS) {
            let columns: Vec<Vec<f64>> = (first..rows.min(first + COLUMNS))
                .into_par_iter()
                .map(|k| self.column_below_diagonal(k, &inverses))
                .collect();
            for (k, column) in (first..).zip(columns) {
                for (i, value) in (k..).zip(column) {
                    packed.set(i, k, value);
                }
            }
        }
        Dense::with_local_model(packed, self.local_model())
    }

    /// The entries A_kk, A_{k+1,k}, ….
    fn column_below_diagonal(&self, k: usize, inverses: &[Mat<f64>]) -> Vec<f64> {
        let mut column = vec![0.0; self.dim() - k];
        for (body, inverse) in self.bodies.iter().zip(inverses) {
            let mut displacement = vec![0.0; body.coupling.dofs()];
            for (j, b) in body.coupling.row(k) {
                for (u, s) in displacement.iter_mut().zip(inverse.col(j).iter()) {
                    *u += b * s;
                }
            }
            for (i, value) in (k..).zip(&mut column) {
                *value += body
                    .coupling
                    .row(i)
                    .map(|(j, b)| b * displacement[j])
                    .sum::<f64>();
            }
        }
        column
    }
}

impl DualOperator for Condensed {
    fn dim(&self) -> usize {
        self.bodies.rows()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.bodies.multiply(x, y, TrailingBlock::solve_in_place);
    }

    fn tally(&mut self) -> &mut Tally {
        &mut self.tally
    }

    fn local_model(&self) -> LocalModel {
        local_model::from_groups(&self.groups, &self.bodies.couplings(), |body, dofs| {
            // S_JJ = L_J: L_J:ᵀ
            let factor = self.bodies.get(body).solver.factor();
            let width = dofs.last().map_or(0, |last| last + 1);
            let rows = Mat::from_fn(dofs.len(), width, |i, l| {
                if l <= dofs[i] {
                    factor.get(dofs[i], l)
                } else {
                    0.0
                }
            });
            let mut schur = Mat::zeros(dofs.len(), dofs.len());
            matmul(
                schur.as_mut(),
                Accum::Replace,
                rows.as_ref(),
                rows.transpose(),
                1.0,
                Par::Seq,
            );
            local_model::factor(&schur)
        })
    }
}
