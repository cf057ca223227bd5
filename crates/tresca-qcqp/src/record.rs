//! What is known of one iteration.

use crate::StateCounts;
use serde::{Deserialize, Serialize};

/// One line of the iteration table: the feasible iterate λ_k and the step that
/// led to it. Iteration 0 is the start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct IterationRecord {
    /// k.
    pub iteration: usize,
    /// ‖r̃(λ_k)‖/‖r̃(0)‖ with ρ = 1/σmax.
    pub relative_reduced_gradient: f64,
    /// q(λ_k).
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
