//! What a finished solve says in numbers.

use serde::Serialize;

/// The figures of one solve, declared once: solutions, summaries and tables carry this struct.
///
/// Serialised (into a summary: flattened) every field has its own name, but for the objective, which is called
/// `dual_objective`, and the seconds, which stand among the times of the run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Figures {
    /// Number of iterations, of all outer iterations together (their starts not counted).
    pub iterations: usize,
    /// All multiplications by A, those for σmax included.
    pub n_a: usize,
    /// The part of `n_a` that went into the estimate of σmax.
    pub n_a_setup: usize,
    /// The estimate of the largest eigenvalue of A (an upper bound up to luck; 0 if it was not needed).
    pub sigma_max: f64,
    /// ‖r̃(λ)‖/‖r̃(0)‖ with ρ = 1/σmax, what the tolerance is on; 0 when r̃(0) = 0.
    pub relative_reduced_gradient: f64,
    /// ‖GᵀS(Gλ − e)‖ relative to the reference of the reduced gradient; 0 without an equality constraint.
    pub equality_residual: f64,
    /// Number of problems solved with frozen bounds (Coulomb's law, fixed point), of steps with
    /// bounds that follow (in the loop), or, without Coulomb's law, with a frozen multiplier
    /// (equality constraint). 0 for a plain problem.
    pub outer_iterations: usize,
    /// Coulomb's law: the larger one of ‖g(λ) − g‖/‖g(λ)‖, g(λ) the bounds that follow from λ and
    /// g those that λ was computed under, and (fixed point) ‖λ − λ'‖/‖λ‖, λ' of the outer
    /// iteration before. 0 without Coulomb's law.
    pub outer_residual: f64,
    /// Steps of the proximal point method, which takes over where A is singular and the method fails; their
    /// Newton iterations are among `iterations`. 0 otherwise.
    pub proximal_steps: usize,
    /// Coulomb's law: sweeps over the contacts, which take over where bounds do not settle. 0 otherwise.
    pub sweeps: usize,
    /// q(λ) = ½ λᵀAλ − λᵀb.
    #[serde(rename = "dual_objective")]
    pub objective: f64,
    /// Wall-clock seconds in the multiplications by A.
    #[serde(skip)]
    pub seconds_in_products: f64,
}
