//! A rigid body on a Winkler foundation.
//!
//! Every contact force answers for itself: λ(β) = P_Λ(λ₀ + G̃ᵀβ/δ) with one compliance δ. What is left
//! is an equation for the motion β alone, as many unknowns as there are rigid motions,
//!
//! ```text
//! η (β − β₀) + G̃ P_Λ(λ₀ + G̃ᵀβ/δ) = ẽ,
//! ```
//!
//! the stationarity of a convex function, solved by a semismooth Newton method with line search
//! (X. Zhao, D. Sun, K.-C. Toh, *A Newton–CG augmented Lagrangian method*, SIAM J. Optim. 20 (2010)).
//! It costs no multiplication by A.

use super::attainable::AttainableForces;
use super::balance::Balance;
use faer::linalg::solvers::{Llt, Solve};
use faer::{ColMut, Mat, Side};
use tresca_la::vector::{axpy, dot, norm};

const MAX_NEWTON_STEPS: usize = 60;
/// Part of the slope that the line search wants (Armijo), and the shortest step it tries.
const SUFFICIENT: f64 = 1e-4;
const SHORTEST: f64 = 1e-10;
/// The residual that counts as solved, relative to the motion's own term, and to the load.
const SOLVED: f64 = 1e-9;
const ROUNDING: f64 = 1e-15;

/// The foundation.
pub(super) struct Foundation<'a> {
    pub balance: &'a Balance,
    pub reach: &'a AttainableForces,
    /// λ₀.
    pub centre: &'a [f64],
    /// δ.
    pub compliance: f64,
}

/// A motion with all that is computed there.
struct Trial {
    beta: Vec<f64>,
    /// λ₀ + G̃ᵀβ/δ.
    y: Vec<f64>,
    /// ẽ − G̃P(y) − η(β − β₀).
    residual: Vec<f64>,
    /// The convex function.
    value: f64,
}

impl Foundation<'_> {
    /// y = λ₀ + G̃ᵀβ/δ and the forces P(y).
    pub fn forces(&self, beta: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut y = vec![0.0; self.centre.len()];
        self.balance.add_transposed(beta, &mut y);
        for (y, centre) in y.iter_mut().zip(self.centre) {
            *y = centre + *y / self.compliance;
        }
        let mut near = y.clone();
        self.reach.project(&mut near);
        (y, near)
    }

    /// Moves `beta` to the solution for β₀ = `anchor` and η = `spring`.
    pub fn settle(&self, anchor: &[f64], spring: f64, beta: &mut Vec<f64>) {
        let load = norm(&self.balance.load);
        let mut at = self.trial(anchor, spring, beta.clone());
        for _ in 0..MAX_NEWTON_STEPS {
            let own = spring * norm(&difference(&at.beta, anchor));
            if norm(&at.residual) <= f64::max(SOLVED * own, ROUNDING * load) {
                break;
            }
            let Some(next) = self.newton_step(anchor, spring, &at) else {
                break;
            };
            at = next;
        }
        *beta = at.beta;
    }

    fn trial(&self, anchor: &[f64], spring: f64, beta: Vec<f64>) -> Trial {
        let (y, near) = self.forces(&beta);
        let moved = difference(&beta, anchor);
        let mut residual = self.balance.shortfall(&near);
        axpy(-spring, &moved, &mut residual);
        // ½‖y‖² − ½‖y − P(y)‖² has the gradient P(y).
        let envelope = self.compliance * (dot(&y, &near) - 0.5 * dot(&near, &near));
        let value = 0.5 * spring * dot(&moved, &moved) - dot(&self.balance.load, &beta) + envelope;
        Trial {
            beta,
            y,
            residual,
            value,
        }
    }

    /// A Newton step, shortened until the function falls; `None` when nothing is left to gain.
    fn newton_step(&self, anchor: &[f64], spring: f64, at: &Trial) -> Option<Trial> {
        let slanted: Vec<Vec<f64>> = self
            .balance
            .rows
            .iter()
            .map(|row| {
                let mut row = row.clone();
                self.reach.slant(&at.y, &mut row);
                row
            })
            .collect();
        let order = slanted.len();
        let matrix = Mat::from_fn(order, order, |i, j| {
            let own = if i == j { spring } else { 0.0 };
            own + dot(&self.balance.rows[i], &slanted[j]) / self.compliance
        });
        let factor = Llt::new(matrix.as_ref(), Side::Lower).ok()?;
        let mut step = at.residual.clone();
        factor.solve_in_place(ColMut::from_slice_mut(&mut step));
        let slope = dot(&at.residual, &step);
        let mut alpha = 1.0;
        while alpha >= SHORTEST {
            let mut beta = at.beta.clone();
            axpy(alpha, &step, &mut beta);
            let next = self.trial(anchor, spring, beta);
            let falls = next.value <= at.value - SUFFICIENT * alpha * slope;
            // Near the end the value is rounding; the residual is not.
            if falls || norm(&next.residual) <= 0.5 * norm(&at.residual) {
                return Some(next);
            }
            alpha *= 0.5;
        }
        None
    }
}

fn difference(x: &[f64], y: &[f64]) -> Vec<f64> {
    x.iter().zip(y).map(|(x, y)| x - y).collect()
}
