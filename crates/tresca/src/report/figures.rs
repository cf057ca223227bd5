//! What a method did, in figures.

use serde::Serialize;
use tresca_qcqp::{Solution, StateCounts};

/// What a method did.
#[derive(Debug, Clone, Serialize)]
pub struct Figures {
    /// Iterations.
    pub iterations: usize,
    /// Multiplications by A, estimate of σmax included.
    pub n_a: usize,
    /// Multiplications that went into the estimate of σmax.
    pub n_a_setup: usize,
    /// The estimate of σmax.
    pub sigma_max: f64,
    /// ‖r̃(λ)‖ / ‖r̃(0)‖.
    pub relative_reduced_gradient: f64,
    /// Residual of the equilibrium of floating bodies, on the same scale; 0 without them.
    pub equality_residual: f64,
    /// Outer iterations: updates of Coulomb bounds.
    pub outer_iterations: usize,
    /// Relative change of the Coulomb bounds in the last of them; 0 without Coulomb's law.
    pub outer_residual: f64,
    /// q(λ).
    pub dual_objective: f64,
    /// How many blocks of unknowns are open, closed, sticking, slipping.
    pub counts: StateCounts,
}

impl From<&Solution> for Figures {
    fn from(solution: &Solution) -> Self {
        Self {
            iterations: solution.iterations,
            n_a: solution.n_a,
            n_a_setup: solution.n_a_setup,
            sigma_max: solution.sigma_max,
            relative_reduced_gradient: solution.relative_reduced_gradient,
            equality_residual: solution.equality_residual,
            outer_iterations: solution.outer_iterations,
            outer_residual: solution.outer_residual,
            dual_objective: solution.objective,
            counts: solution.active_set.counts(),
        }
    }
}
