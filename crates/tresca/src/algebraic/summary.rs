//! `summary.json` of a problem that came as matrices.

use serde::Serialize;
use tresca_qcqp::{Figures, Settings, Status};

use super::{Note, Solution};
use crate::certificate::Certificate;
use tresca_system::engine::EngineChoice;
use tresca_system::factors::FactorWork;

/// The outcome in figures, in the caller's units.
#[derive(Debug, Clone, Serialize)]
pub struct Summary {
    /// What the problem is called.
    pub title: String,
    /// Version of tresca.
    pub version: &'static str,
    /// How the run ended.
    pub status: Status,
    /// The method.
    pub method: &'static str,
    /// Iterations, multiplications by A, residuals, objective.
    #[serde(flatten)]
    pub figures: Figures,
    /// n; left out, as what follows from K, for a pure dual problem.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dofs: Option<usize>,
    /// Bodies that were factored.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bodies: Option<usize>,
    /// Kernel vectors of K, which contact has to hold.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kernel_vectors: Option<usize>,
    /// Engine and why.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub engine: Option<EngineChoice>,
    /// What the factorisation cost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub factorization: Option<FactorWork>,
    /// The contact in figures.
    pub contact: ContactFigures,
    /// Independent check of the result.
    pub certificate: Certificate,
    /// What the user should know about the input.
    pub notes: Vec<String>,
    /// Wall-clock seconds: check, factorisation, solve, recovery.
    pub times: TimeFigures,
    /// Threads.
    pub threads: usize,
    /// All settings, resolved.
    pub settings: Settings,
}

/// The contact in figures.
#[derive(Debug, Clone, Serialize)]
pub struct ContactFigures {
    /// m.
    pub pairs: usize,
    /// Pairs that carry a normal force.
    pub closed: usize,
    /// Pairs that do not.
    pub open: usize,
    /// Pairs whose friction force is below the bound.
    pub stick: usize,
    /// The others.
    pub slip: usize,
    /// Σ λν.
    pub normal_force_sum: f64,
    /// Largest absolute entry of T u.
    pub max_slip_component: f64,
    /// Largest gap left.
    pub max_gap: f64,
}

/// Wall-clock seconds.
#[derive(Debug, Clone, Serialize)]
pub struct TimeFigures {
    /// Checks of the input.
    pub check: f64,
    /// Kernels, ordering, factorisation, set-up of the dual operator.
    pub factorization: f64,
    /// The dual problem.
    pub solve: f64,
    /// Multiplications by A, a part of the solve.
    pub multiplications: f64,
    /// Displacements and certificate.
    pub recovery: f64,
    /// All of it.
    pub total: f64,
}

impl Summary {
    /// Summarises a solution of a problem with this title.
    pub fn new(title: &str, solution: &Solution) -> Self {
        let description = solution.description.as_ref();
        let count = |flags: &[bool]| flags.iter().filter(|flag| **flag).count();
        let pairs = solution.normal_force.len();
        let (closed, stick) = (count(&solution.closed), count(&solution.stick));
        let times = solution.times;
        Self {
            title: title.to_owned(),
            version: crate::VERSION,
            status: solution.status,
            method: solution.settings.method.name(),
            figures: solution.figures,
            dofs: description.map(|description| description.dofs),
            bodies: description.map(|description| description.bodies),
            kernel_vectors: description.map(|description| description.rigid_motions),
            engine: description.map(|description| description.engine.clone()),
            factorization: description.map(|description| description.factorization),
            contact: ContactFigures {
                pairs,
                closed,
                open: pairs - closed,
                stick,
                slip: pairs - stick,
                normal_force_sum: solution.normal_force.iter().sum(),
                max_slip_component: solution.slip.iter().fold(0.0, |a: f64, x| a.max(x.abs())),
                max_gap: solution.gap.iter().copied().fold(0.0, f64::max),
            },
            certificate: solution.certificate.clone(),
            notes: solution.notes.iter().map(Note::to_string).collect(),
            times: TimeFigures {
                check: times.assembly,
                factorization: times.factorization,
                solve: times.solve,
                multiplications: times.multiplications,
                recovery: times.recovery,
                total: times.total(),
            },
            threads: rayon::current_num_threads(),
            settings: solution.settings.clone(),
        }
    }
}
