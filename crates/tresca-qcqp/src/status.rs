//! How a run ended.

use serde::{Deserialize, Serialize};
use std::fmt;

/// How a run ended. Only [`Status::Converged`] is a solution; with every other
/// status the returned λ is the best feasible iterate seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Status {
    /// The relative reduced gradient is at or below the tolerance, and so are the residuals of
    /// the outer iterations, if there are any.
    Converged,
    /// `max_iterations` were made.
    IterationLimit,
    /// Neither the reduced gradient nor the objective has improved for many
    /// iterations: a cycle, or the tolerance is below what rounding allows.
    Stagnated,
    /// The observer asked to stop.
    Interrupted,
    /// An iterate is no longer finite: the method diverged, or the operator
    /// returned a NaN.
    Diverged,
    /// Equality constraint: no λ ∈ Λ satisfies it. The loads on a floating body need contact forces
    /// that can only pull, or friction that is not there;
    /// [`DualSolution::motion`](crate::DualSolution::motion) is the rigid motion that nothing resists.
    NoEquilibrium,
    /// The constraints contradict each other: no displacement satisfies them all.
    /// [`DualSolution::contradiction`](crate::DualSolution::contradiction) is the proof.
    Infeasible,
    /// The method met its tolerance, but the answer, as it is handed out, fails its certificate: rounding
    /// leaves it undetermined. What the certificate says is what holds.
    Inaccurate,
    /// Coulomb's law: the bounds return to former values, over and over.
    CoulombCycles,
    /// Coulomb's law: the changes of the bounds no longer fall, though no cycle is seen.
    CoulombDiverges,
}

impl Status {
    /// Whether λ solves the problem to the tolerance.
    pub fn is_converged(self) -> bool {
        self == Status::Converged
    }

    /// The word used in files and on the terminal.
    pub fn name(self) -> &'static str {
        match self {
            Status::Converged => "converged",
            Status::IterationLimit => "iteration_limit",
            Status::Stagnated => "stagnated",
            Status::Interrupted => "interrupted",
            Status::Diverged => "diverged",
            Status::NoEquilibrium => "no_equilibrium",
            Status::Infeasible => "infeasible",
            Status::Inaccurate => "inaccurate",
            Status::CoulombCycles => "coulomb_cycles",
            Status::CoulombDiverges => "coulomb_diverges",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
