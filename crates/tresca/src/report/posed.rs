//! What a problem of FCLIB or Siconos poses.

use serde::Serialize;

/// What was posed.
#[derive(Clone, Debug, Serialize)]
#[non_exhaustive]
pub struct FclibReport {
    /// `local` or `global`.
    pub problem: &'static str,
    /// 2 or 3.
    pub dimension: usize,
    /// Number of contacts.
    pub contacts: usize,
    /// Number of velocities v of a global problem.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocities: Option<usize>,
    /// The law of friction.
    pub law: LawReport,
}

/// A law and its parameter.
#[derive(Clone, Copy, Debug, Serialize)]
#[non_exhaustive]
pub struct LawReport {
    /// `coulomb` or `tresca`.
    pub name: &'static str,
    /// The slip bound of Tresca's law, a force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<f64>,
}

/// ‖ours − theirs‖/‖theirs‖.
#[derive(Clone, Copy, Debug, Serialize)]
#[non_exhaustive]
pub struct Reference {
    /// Of r.
    pub forces: f64,
    /// Of u.
    pub velocities: f64,
}
