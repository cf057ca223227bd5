//! The next multiplier.
//!
//! The dual function d(β) = min over Λ of q(λ) − βᵀ(G̃λ − ẽ) is concave with gradient ẽ − G̃λ(β) and
//! generalised Hessian −H, 0 ⪯ H ⪯ I, since the operator holds G̃ᵀG̃. So
//!
//! ```text
//! δβ = (H + εI)⁻¹ (ẽ − G̃λ)
//! ```
//!
//! is Newton's step for ε → 0, and for ε = 1 as careful as the method of multipliers (δβ = ẽ − G̃λ),
//! which always converges. A body that has not landed has H = 0: it then falls in strides that grow.

use crate::methods::Compliance;
use faer::linalg::solvers::{Llt, Solve};
use faer::{ColMut, Side};
use tresca_la::vector::{axpy, norm};

/// ε of the first step.
const FIRST: f64 = 1e-3;
/// ε is divided by this after a step that gained, down to [`LEAST`].
const EASING: f64 = 10.0;
const LEAST: f64 = 1e-13;
/// ε is multiplied by this when a few steps have gained nothing.
const CAUTION: f64 = 1e3;
/// Steps that may gain nothing: Newton's method comes back from the far side of a kink, where d is
/// lower than before, in a step or two.
const PATIENCE: usize = 3;
/// A residual smaller by this factor is a gain, whatever d says.
const CONTRACTION: f64 = 0.7;

/// A multiplier with what is known there.
pub(super) struct Station {
    pub beta: Vec<f64>,
    /// λ(β).
    pub lambda: Vec<f64>,
    /// ẽ − G̃λ.
    pub shortfall: Vec<f64>,
    /// d(β), as good as the inner solve; `None` where there is no such function (bounds that follow λ).
    pub value: Option<f64>,
    pub compliance: Compliance,
}

/// The ascent of d.
pub(super) struct Ascent {
    best: Option<Station>,
    epsilon: f64,
    idle: usize,
}

impl Ascent {
    pub fn new() -> Self {
        Self {
            best: None,
            epsilon: FIRST,
            idle: 0,
        }
    }

    /// The next β, and the λ to be expected there (not projected).
    pub fn next(&mut self, station: Station) -> (Vec<f64>, Vec<f64>) {
        if self.gains(&station) {
            if self.best.is_some() {
                self.epsilon = f64::max(self.epsilon / EASING, LEAST);
            }
            self.idle = 0;
            let next = step(&station, self.epsilon);
            self.best = Some(station);
            return next;
        }
        self.idle += 1;
        match &self.best {
            Some(best) if self.idle > PATIENCE => {
                self.idle = 0;
                self.epsilon = f64::min(self.epsilon * CAUTION, 1.0);
                step(best, self.epsilon)
            }
            _ => step(&station, self.epsilon),
        }
    }

    fn gains(&self, station: &Station) -> bool {
        let Some(best) = &self.best else {
            return true;
        };
        let higher = match (station.value, best.value) {
            (Some(value), Some(best)) => value > best,
            _ => false,
        };
        higher || norm(&station.shortfall) < CONTRACTION * norm(&best.shortfall)
    }
}

fn step(from: &Station, epsilon: f64) -> (Vec<f64>, Vec<f64>) {
    let mut matrix = from.compliance.matrix.clone();
    (0..matrix.nrows()).for_each(|i| matrix[(i, i)] += epsilon);
    let mut change = from.shortfall.clone();
    match Llt::new(matrix.as_ref(), Side::Lower) {
        Ok(factor) => factor.solve_in_place(ColMut::from_slice_mut(&mut change)),
        // H is positive semidefinite but for the accuracy of its columns: the multiplier step stands.
        Err(_) => {}
    }
    let (mut beta, mut lambda) = (from.beta.clone(), from.lambda.clone());
    axpy(1.0, &change, &mut beta);
    for (response, change) in from.compliance.responses.iter().zip(&change) {
        axpy(*change, response, &mut lambda);
    }
    (beta, lambda)
}
