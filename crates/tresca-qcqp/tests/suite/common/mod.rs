//! Random problems and an independent oracle for the integration tests.

pub mod half_space;
pub mod oracle;
pub mod problems;

pub use tresca_la::vector::{dot, norm};
use tresca_qcqp::operator::Dense;
use tresca_qcqp::{DualProblem, DualSolution, Method, ProductSet, Settings, Unobserved, solve};

/// A problem as plain data: a dense matrix, row by row, b and Λ.
#[derive(Clone, Debug)]
pub struct Plain {
    pub a: Vec<Vec<f64>>,
    pub b: Vec<f64>,
    pub set: ProductSet,
}

impl Plain {
    pub fn dim(&self) -> usize {
        self.b.len()
    }

    pub fn packed(&self) -> tresca_la::PackedLower {
        let mut packed = tresca_la::PackedLower::zeros(self.dim());
        for j in 0..self.dim() {
            for i in j..self.dim() {
                packed.set(i, j, self.a[i][j]);
            }
        }
        packed
    }

    pub fn problem(&self) -> DualProblem<'static> {
        DualProblem::new(Dense::new(self.packed()), self.b.clone(), self.set.clone()).unwrap()
    }

    pub fn solve(&self, settings: &Settings, start: Option<&[f64]>) -> DualSolution {
        solve(
            &mut self.problem(),
            settings,
            start.map(Into::into),
            &mut Unobserved,
        )
        .unwrap()
    }

    pub fn mul(&self, x: &[f64]) -> Vec<f64> {
        self.a.iter().map(|row| dot(row, x)).collect()
    }

    /// q(x).
    pub fn objective(&self, x: &[f64]) -> f64 {
        0.5 * dot(x, &self.mul(x)) - dot(x, &self.b)
    }

    /// ‖x − P(x − ρ r(x))‖/ρ relative to that at 0, without any code of the methods.
    pub fn relative_reduced_gradient(&self, x: &[f64], rho: f64) -> f64 {
        let norm = |x: &[f64]| {
            let r: Vec<f64> = self
                .mul(x)
                .iter()
                .zip(&self.b)
                .map(|(ax, b)| ax - b)
                .collect();
            let mut y: Vec<f64> = x.iter().zip(&r).map(|(x, r)| x - rho * r).collect();
            self.set.project(&mut y);
            distance(x, &y)
        };
        norm(x) / norm(&vec![0.0; x.len()])
    }
}

/// The settings of a test: this method, this tolerance, the defaults.
pub fn settings(method: Method, tolerance: f64) -> Settings {
    Settings {
        method,
        tolerance,
        max_iterations: 20_000,
        ..Settings::default()
    }
}

pub fn distance(x: &[f64], y: &[f64]) -> f64 {
    x.iter()
        .zip(y)
        .map(|(x, y)| (x - y).powi(2))
        .sum::<f64>()
        .sqrt()
}
