//! Sizes of a system, and what its factorisation cost.

use serde::Serialize;

use tresca_system::description::{Description, EngineChoice};
use tresca_system::factors::FactorWork;

/// Bodies and how A is applied.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct SystemReport {
    /// Free and held dofs of all bodies; n of matrices.
    pub dofs: usize,
    /// Bodies; of matrices, those that were factored.
    pub bodies: usize,
    /// Rigid motions that supports leave, kernel vectors of K: contact has to hold them.
    pub rigid_motions: usize,
    /// Engine and why.
    pub engine: EngineChoice,
    /// Nonzeros, flops and time of the factorisation.
    pub factorization: FactorReport,
}

/// What the factorisation cost.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct FactorReport {
    /// Nonzeros, flops, seconds.
    #[serde(flatten)]
    pub work: FactorWork,
    /// Speed reached.
    pub gigaflops_per_second: f64,
}

impl From<&Description> for SystemReport {
    fn from(description: &Description) -> Self {
        let work = description.factorization;
        Self {
            dofs: description.dofs,
            bodies: description.bodies,
            rigid_motions: description.rigid_motions,
            engine: description.engine.clone(),
            factorization: FactorReport {
                work,
                gigaflops_per_second: work.gigaflops_per_second(),
            },
        }
    }
}
