//! What a run returns.

use crate::{ActiveSet, IterationRecord, Method, Status};

/// The outcome of one run.
///
/// Look at [`status`](Solution::status) first: `lambda` is always feasible, but
/// only with [`Status::Converged`] is it a solution.
#[derive(Clone, Debug)]
pub struct Solution {
    /// How the run ended.
    pub status: Status,
    /// The method that ran.
    pub method: Method,
    /// λ ∈ Λ: the last iterate if converged, else the best one seen (smallest
    /// reduced gradient).
    pub lambda: Vec<f64>,
    /// r(λ) = Aλ − b as the method knew it (from its recurrences).
    pub gradient: Vec<f64>,
    /// ‖r̃(λ)‖/‖r̃(0)‖ with ρ = 1/σmax; 0 when r̃(0) = 0.
    pub relative_reduced_gradient: f64,
    /// q(λ) = ½ λᵀAλ − λᵀb.
    pub objective: f64,
    /// State of every block at λ.
    pub active_set: ActiveSet,
    /// Number of iterations (the start not counted).
    pub iterations: usize,
    /// One record per iteration, the start included.
    pub records: Vec<IterationRecord>,
    /// All multiplications by A, those for σmax included.
    pub n_a: usize,
    /// The part of `n_a` that went into the estimate of σmax.
    pub n_a_setup: usize,
    /// The estimate of the largest eigenvalue of A (an upper bound up to luck; 0 if it was not needed).
    pub sigma_max: f64,
}
