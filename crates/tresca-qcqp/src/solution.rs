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
    /// r(λ) = Aλ − b − Gᵀα as the method knew it (from its recurrences); Gᵀα is 0 without an
    /// equality constraint.
    pub gradient: Vec<f64>,
    /// ‖r̃(λ)‖/‖r̃(0)‖ with ρ = 1/σmax; 0 when r̃(0) = 0.
    pub relative_reduced_gradient: f64,
    /// q(λ) = ½ λᵀAλ − λᵀb.
    pub objective: f64,
    /// State of every block at λ.
    pub active_set: ActiveSet,
    /// α, the multiplier of Gλ = e: the rigid motions. Empty without an equality constraint.
    pub multiplier: Vec<f64>,
    /// ‖GᵀS(Gλ − e)‖ relative to the reference of the reduced gradient; 0 without an equality constraint.
    pub equality_residual: f64,
    /// With [`Status::NoEquilibrium`] the proof, of unit length: a motion v with eᵀv > λᵀGᵀv for all
    /// λ ∈ Λ. The load drives it, and no admissible contact force can stop it.
    pub motion: Option<Vec<f64>>,
    /// Number of problems solved with frozen bounds (Coulomb's law, fixed point), of steps with
    /// bounds that follow (in the loop), or, without Coulomb's law, with a frozen multiplier
    /// (equality constraint). 0 for a plain problem.
    pub outer_iterations: usize,
    /// Coulomb's law: the larger one of ‖g(λ) − g‖/‖g(λ)‖, g(λ) the bounds that follow from λ and
    /// g those that λ was computed under, and (fixed point) ‖λ − λ'‖/‖λ‖, λ' of the outer
    /// iteration before. 0 without Coulomb's law.
    pub outer_residual: f64,
    /// Number of iterations, of all outer iterations together (their starts not counted).
    pub iterations: usize,
    /// One record per iteration, and one for each start.
    pub records: Vec<IterationRecord>,
    /// All multiplications by A, those for σmax included.
    pub n_a: usize,
    /// The part of `n_a` that went into the estimate of σmax.
    pub n_a_setup: usize,
    /// Wall-clock seconds in these multiplications.
    pub seconds_in_products: f64,
    /// The estimate of the largest eigenvalue of A (an upper bound up to luck; 0 if it was not needed).
    pub sigma_max: f64,
}
