//! Sizes of a problem, how it is going to be solved, and what that took.

use serde::Serialize;
use tresca_qcqp::Engine;

use crate::factors::FactorWork;

/// Sizes of a problem and how it is going to be solved.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Description {
    /// n, free and held dofs of all bodies.
    pub dofs: usize,
    /// Number of bodies.
    pub bodies: usize,
    /// m, number of contact pairs.
    pub pairs: usize,
    /// Pairs left out because both nodes are held.
    pub held_pairs: usize,
    /// Rigid motions that the supports leave to the bodies, and that contact has to hold.
    pub rigid_motions: usize,
    /// The engine and why.
    pub engine: EngineChoice,
    /// What the factorisation cost.
    pub factorization: FactorWork,
}

/// Which engine multiplies by A, and why.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EngineChoice {
    /// The engine, never [`Engine::Auto`].
    pub engine: Engine,
    /// Why this one.
    pub reason: String,
}

/// Wall-clock seconds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Times {
    /// Stiffness and contact data; of problems that come as matrices, the checks of the input.
    pub assembly: f64,
    /// Contact search and coupling, a part of the assembly.
    pub contact: f64,
    /// Ordering, analysis and factorisation of all bodies, and the set-up of the dual operator.
    pub factorization: f64,
    /// The dual problems of all steps, estimate of σmax included.
    pub solve: f64,
    /// Multiplications by A, a part of the solve.
    pub multiplications: f64,
    /// Loads, displacements and certificates.
    pub recovery: f64,
}

impl Times {
    /// The sum.
    pub fn total(&self) -> f64 {
        self.assembly + self.factorization + self.solve + self.recovery
    }
}
