//! The constraint, and the same in coordinates that compare.

use crate::error::{QcqpError, check_rows, check_vector};
use crate::point::relative;
use faer::linalg::solvers::Llt;
use faer::{Mat, Side};
use tresca_la::vector::{axpy, dot, norm};

/// An entry of G̃ beside √σmax that is rounding. It stands for 1e-24 of a compliance.
const ROUNDING: f64 = 1e-12;

/// Gλ = e, for a problem whose operator contains GᵀSG.
#[derive(Clone, Debug)]
pub struct Equality {
    /// The rows of G, each as long as λ.
    pub rows: Vec<Vec<f64>>,
    /// e, one entry per row.
    pub rhs: Vec<f64>,
    /// S, symmetric positive definite, row by row; units of α per unit of e.
    pub metric: Vec<Vec<f64>>,
}

/// The constraint in coordinates where S is the identity: S = LLᵀ, G̃ = LᵀG, ẽ = Lᵀe, α = Lβ.
/// Rotations and translations, metres and radians then compare.
pub(crate) struct Balance {
    /// G̃, row by row.
    pub rows: Vec<Vec<f64>>,
    /// ẽ.
    pub load: Vec<f64>,
    /// L.
    root: Mat<f64>,
}

impl Balance {
    /// Checks the parts for a λ of length `dim`, and changes coordinates.
    pub fn new(equality: &Equality, dim: usize) -> Result<Self, QcqpError> {
        let count = equality.rows.len();
        for row in &equality.rows {
            check_vector("a row of the equality constraint", row, dim)?;
        }
        check_rows(
            "the metric of the equality constraint",
            equality.metric.len(),
            count,
        )?;
        for row in &equality.metric {
            check_rows("a row of the metric", row.len(), count)?;
        }
        let metric = Mat::from_fn(count, count, |i, j| equality.metric[i][j]);
        let asymmetry = (&metric - metric.transpose()).norm_max();
        if asymmetry > 1e-10 * metric.norm_max() {
            return Err(QcqpError::Metric);
        }
        let factor = Llt::new(metric.as_ref(), Side::Lower).map_err(|_| QcqpError::Metric)?;
        // A NaN passes the factorisation.
        if !factor.L().norm_l2().is_finite() {
            return Err(QcqpError::Metric);
        }
        let root = factor.L().to_owned();
        let rows = (0..count).map(|j| {
            let mut row = vec![0.0; dim];
            for i in j..count {
                axpy(root[(i, j)], &equality.rows[i], &mut row);
            }
            row
        });
        let mut balance = Self {
            rows: rows.collect(),
            load: Vec::new(),
            root,
        };
        balance.set_load(&equality.rhs)?;
        Ok(balance)
    }

    /// Takes for 0 what is rounding in G̃, for an A with this σmax: since A holds G̃ᵀG̃, its entries compare
    /// with √σmax. A force without limit could otherwise balance a load by rounding alone.
    pub fn drop_rounding(&mut self, sigma_max: f64) {
        let least = ROUNDING * sigma_max.sqrt();
        let entries = self.rows.iter_mut().flatten();
        entries.filter(|g| g.abs() <= least).for_each(|g| *g = 0.0);
    }

    /// Another e.
    pub fn set_load(&mut self, load: &[f64]) -> Result<(), QcqpError> {
        let count = self.rows.len();
        check_rows("the right-hand side e", load.len(), count)?;
        check_vector("the right-hand side e", load, count)?;
        let entry = |j: usize| (j..count).map(|i| self.root[(i, j)] * load[i]).sum();
        self.load = (0..count).map(entry).collect();
        Ok(())
    }

    /// α = Lβ.
    pub fn motion(&self, beta: &[f64]) -> Vec<f64> {
        let entry = |i: usize| (0..=i).map(|j| self.root[(i, j)] * beta[j]).sum();
        (0..beta.len()).map(entry).collect()
    }

    /// β = L⁻¹α; 0 for an empty α.
    pub fn coordinates(&self, motion: &[f64]) -> Vec<f64> {
        let mut beta = vec![0.0; self.rows.len()];
        for (i, value) in motion.iter().enumerate() {
            let known: f64 = (0..i).map(|j| self.root[(i, j)] * beta[j]).sum();
            beta[i] = (value - known) / self.root[(i, i)];
        }
        beta
    }

    /// The same constraint with the diagonal of S in the place of S: every row keeps its meaning, and
    /// units still cancel.
    pub fn with_diagonal_metric(&self) -> Self {
        let count = self.rows.len();
        // G = L⁻ᵀG̃, from the last row up.
        let (mut rows, mut load) = (self.rows.clone(), self.load.clone());
        for i in (0..count).rev() {
            let (above, below) = rows.split_at_mut(i + 1);
            for (k, known) in (i + 1..count).zip(below.iter()) {
                axpy(-self.root[(k, i)], known, &mut above[i]);
                load[i] -= self.root[(k, i)] * load[k];
            }
            let pivot = self.root[(i, i)];
            above[i].iter_mut().for_each(|x| *x /= pivot);
            load[i] /= pivot;
        }
        let scale = |i: usize| {
            (0..=i)
                .map(|j| self.root[(i, j)].powi(2))
                .sum::<f64>()
                .sqrt()
        };
        let mut root = Mat::zeros(count, count);
        for (i, row) in rows.iter_mut().enumerate() {
            root[(i, i)] = scale(i);
            row.iter_mut().for_each(|x| *x *= scale(i));
            load[i] *= scale(i);
        }
        Self { rows, load, root }
    }

    /// ẽ − G̃λ.
    pub fn shortfall(&self, lambda: &[f64]) -> Vec<f64> {
        let rows = self.rows.iter().zip(&self.load);
        rows.map(|(row, e)| e - dot(row, lambda)).collect()
    }

    /// ‖ẽ − G̃λ‖ relative to the forces that it is made of, motion by motion.
    pub fn relative_shortfall(&self, shortfall: &[f64], lambda: &[f64]) -> f64 {
        let sizes = self.rows.iter().zip(&self.load).map(|(row, e)| {
            let acts: f64 = row.iter().zip(lambda).map(|(g, l)| (g * l).abs()).sum();
            e.abs().max(acts)
        });
        let size = norm(&sizes.collect::<Vec<_>>());
        relative(norm(shortfall), size)
    }

    /// out ← out + G̃ᵀβ.
    pub fn add_transposed(&self, beta: &[f64], out: &mut [f64]) {
        for (row, beta) in self.rows.iter().zip(beta) {
            axpy(*beta, row, out);
        }
    }

    /// ‖G̃ᵀw‖, a length of w that compares with gradients.
    pub fn spread(&self, w: &[f64]) -> f64 {
        let mut out = vec![0.0; self.rows.first().map_or(0, Vec::len)];
        self.add_transposed(w, &mut out);
        norm(&out)
    }
}
