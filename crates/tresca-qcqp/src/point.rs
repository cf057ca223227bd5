//! A point λ with its gradient, and what is measured there.

use crate::active_set::ActiveSet;
use crate::operator::dual_operator::DualOperator;
use crate::sets::convex_set::{BlockState, ConvexSet};
use crate::sets::product::ProductSet;
use tresca_la::vector::{axpy, dot, norm};

/// A point λ and the gradient r(λ) = Aλ − b there.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    pub lambda: Vec<f64>,
    pub gradient: Vec<f64>,
}

impl Point {
    /// λ = 0, where r = −b.
    pub fn zero(rhs: &[f64]) -> Self {
        Self {
            lambda: vec![0.0; rhs.len()],
            gradient: rhs.iter().map(|b| -b).collect(),
        }
    }

    /// q(self) − q(other) = ½ (λ − λ')ᵀ(r + r'), without the cancellation of a difference of two q.
    pub fn objective_change_from(&self, other: &Point) -> f64 {
        let mut change = 0.0;
        for i in 0..self.lambda.len() {
            change += (self.lambda[i] - other.lambda[i]) * (self.gradient[i] + other.gradient[i]);
        }
        0.5 * change
    }

    /// Moves along a direction whose product with A is known.
    pub fn advance(&mut self, alpha: f64, direction: &[f64], product: &[f64]) {
        axpy(alpha, direction, &mut self.lambda);
        axpy(alpha, product, &mut self.gradient);
    }
}

/// λ and its gradient: one multiplication, none for λ = 0.
pub(crate) fn point_at(operator: &mut dyn DualOperator, rhs: &[f64], lambda: Vec<f64>) -> Point {
    let mut gradient = vec![0.0; lambda.len()];
    if lambda.iter().any(|&l| l != 0.0) {
        operator.apply(&lambda, &mut gradient);
    }
    axpy(-1.0, rhs, &mut gradient);
    Point { lambda, gradient }
}

/// λ − ρ r(λ).
pub(crate) fn gradient_step(point: &Point, rho: f64) -> Vec<f64> {
    point
        .lambda
        .iter()
        .zip(&point.gradient)
        .map(|(l, r)| l - rho * r)
        .collect()
}

/// ‖r̃_ρ(λ)‖ = ‖λ − P_Λ(y)‖/ρ and the active set, both at y = λ − ρ r. On free blocks r̃ is r
/// itself, which spares the cancellation in λ − y.
pub(crate) fn reduced_gradient(set: &ProductSet, point: &Point, rho: f64) -> (f64, ActiveSet) {
    let mut reduced = gradient_step(point, rho);
    let active = set.classify(&reduced);
    for (block, state) in set.blocks().iter().zip(active.states()) {
        let range = block.range();
        let own = &mut reduced[range.clone()];
        match state {
            BlockState::Free => own.copy_from_slice(&point.gradient[range]),
            BlockState::Bound => {
                block.set.project(own);
                for (own, lambda) in own.iter_mut().zip(&point.lambda[range]) {
                    *own = (lambda - *own) / rho;
                }
            }
        }
    }
    (norm(&reduced), active)
}

/// q(λ) = ½ λᵀ(r − b).
pub(crate) fn objective(point: &Point, rhs: &[f64]) -> f64 {
    0.5 * (dot(&point.lambda, &point.gradient) - dot(&point.lambda, rhs))
}

/// What q may be wrong by when evaluated in floating point, with products of the given accuracy.
pub(crate) fn objective_rounding(point: &Point, rhs: &[f64], accuracy: f64) -> f64 {
    let terms = point.lambda.iter().zip(point.gradient.iter().zip(rhs));
    let size: f64 = terms.map(|(l, (r, b))| l.abs() * (r.abs() + b.abs())).sum();
    16.0 * accuracy * size
}

/// A norm against the reference; with a zero reference only a zero norm is 0.
pub(crate) fn relative(norm: f64, reference: f64) -> f64 {
    if norm == 0.0 { 0.0 } else { norm / reference }
}

/// What a computed change of q from `lambda` to `trial` may be wrong by. The part
/// in |λ|ᵀ|r| is needed: a projected pair is on its circle to rounding only, which
/// moves q by more than a step does once the reduced gradient is below 1e-8.
pub(crate) fn change_rounding(lambda: &Point, trial: &Point, rhs: &[f64], accuracy: f64) -> f64 {
    let (mut moved, mut size) = (0.0, 0.0);
    for (i, l) in lambda.lambda.iter().enumerate() {
        moved += (trial.lambda[i] - l).powi(2);
        size += (l * lambda.gradient[i]).abs();
    }
    accuracy * (16.0 * moved.sqrt() * norm(rhs) + 32.0 * size)
}
