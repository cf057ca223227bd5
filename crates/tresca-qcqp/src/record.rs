//! What is known of one iteration.

use crate::StateCounts;
use serde::{Deserialize, Serialize};

/// One line of the iteration table: the feasible iterate λ_k and the step that
/// led to it. Iteration 0 is the start. Outer iterations (Coulomb's bounds, the multiplier of an
/// equality constraint) begin with a record of their own for their start: there `decrease`,
/// `set_changes`, `inner_iterations` and `step_length` are 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct IterationRecord {
    /// k, which runs on over outer iterations.
    pub iteration: usize,
    /// Number of the outer iteration, from 0: of the problem with bounds and multiplier held fixed.
    pub outer: usize,
    /// ‖r̃(λ_k)‖/‖r̃(0)‖ with ρ = 1/σmax, for the bounds and the multiplier of this outer iteration.
    pub relative_reduced_gradient: f64,
    /// q(λ_k), less αᵀGλ_k under an equality constraint.
    pub objective: f64,
    /// q(λ_{k−1}) − q(λ_k), computed without cancellation; 0 for k = 0.
    pub decrease: f64,
    /// How many blocks are open, closed, sticking, slipping at λ_k.
    pub counts: StateCounts,
    /// Blocks whose state differs from that at λ_{k−1}; 0 for k = 0.
    pub set_changes: usize,
    /// Iterations of the inner solver in this step (1 for a direct solve).
    pub inner_iterations: usize,
    /// Multiplications by A so far, those for σmax included.
    pub n_a: usize,
    /// Length α of the Newton step that was accepted; 0 when the method fell
    /// back to the projected gradient step, 1 for methods without a search.
    pub step_length: f64,
}
