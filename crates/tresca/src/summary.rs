//! The summary of a run, as it is written to `summary.json`.

use serde::Serialize;
use tresca_qcqp::{Settings, StateCounts, Status};

use crate::certificate::Certificate;
use crate::dual::{EngineChoice, FactorWork};
use crate::outcome::Outcome;

/// `summary.json`. Forces, lengths and stresses in the user's units.
#[derive(Debug, Clone, Serialize)]
pub struct Summary {
    /// Title of the case.
    pub title: String,
    /// Version of tresca.
    pub version: &'static str,
    /// How the method ended.
    pub status: Status,
    /// The method.
    pub method: &'static str,
    /// Iterations.
    pub iterations: usize,
    /// Multiplications by A, estimate of σmax included.
    pub n_a: usize,
    /// Multiplications that went into the estimate of σmax.
    pub n_a_setup: usize,
    /// ‖r̃(λ)‖ / ‖r̃(0)‖.
    pub relative_reduced_gradient: f64,
    /// q(λ).
    pub dual_objective: f64,
    /// Free and held dofs of all bodies.
    pub dofs: usize,
    /// Bodies.
    pub bodies: usize,
    /// The contact in figures.
    pub contact: ContactSummary,
    /// Independent check of the result.
    pub certificate: Certificate,
    /// Seconds.
    pub times: TimesSummary,
    /// Peak memory of the process.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_memory_bytes: Option<u64>,
    /// Engine and why.
    pub engine: EngineChoice,
    /// Nonzeros, flops and time of the factorisation.
    pub factorization: FactorSummary,
    /// Threads.
    pub threads: usize,
    /// All settings, resolved.
    pub settings: Settings,
}

/// The contact in figures.
#[derive(Debug, Clone, Serialize)]
pub struct ContactSummary {
    /// Contact pairs.
    pub pairs: usize,
    /// Pairs that carry a normal force.
    pub closed: usize,
    /// Pairs that do not.
    pub open: usize,
    /// Pairs whose friction force is below the slip bound.
    pub stick: usize,
    /// Pairs at the slip bound.
    pub slip: usize,
    /// Pairs left out because both nodes are held.
    pub held: usize,
    /// Σ λν.
    pub normal_force_sum: f64,
    /// Largest contact pressure.
    pub max_pressure: f64,
    /// Largest component, in the pair's frame, of the slip.
    pub max_slip_component: f64,
    /// Largest gap left.
    pub max_gap: f64,
}

/// Wall-clock seconds.
#[derive(Debug, Clone, Serialize)]
pub struct TimesSummary {
    /// Stiffness, loads, contact data.
    pub assembly: f64,
    /// Ordering, analysis, factorisation, set-up of the dual operator.
    pub factorization: f64,
    /// The dual problem.
    pub solve: f64,
    /// Displacements and certificate.
    pub recovery: f64,
    /// Stresses and writing of the result files (the summary itself excepted).
    pub output: f64,
    /// All of it.
    pub total: f64,
}

/// What the factorisation cost.
#[derive(Debug, Clone, Serialize)]
pub struct FactorSummary {
    /// Nonzeros, flops, seconds.
    #[serde(flatten)]
    pub work: FactorWork,
    /// Speed reached.
    pub gigaflops_per_second: f64,
}

impl Summary {
    /// Summarises an outcome. `output` is the time spent on stresses and files so far.
    pub fn new(title: &str, outcome: &Outcome, output: f64) -> Self {
        let solution = &outcome.solution;
        let StateCounts {
            open,
            closed,
            stick,
            slip,
            ..
        } = solution.active_set.counts();
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let times = outcome.times;
        Self {
            title: title.to_owned(),
            version: crate::VERSION,
            status: solution.status,
            method: solution.method.name(),
            iterations: solution.iterations,
            n_a: solution.n_a,
            n_a_setup: solution.n_a_setup,
            relative_reduced_gradient: solution.relative_reduced_gradient,
            dual_objective: solution.objective,
            dofs: outcome.description.dofs,
            bodies: outcome.description.bodies,
            contact: ContactSummary {
                pairs: outcome.description.pairs,
                closed,
                open,
                stick,
                slip,
                held: outcome.description.held_pairs,
                normal_force_sum: outcome.pairs().map(|pair| pair.normal_force).sum(),
                max_pressure: largest(&mut outcome.pairs().map(|pair| pair.pressure())),
                max_slip_component: largest(
                    &mut outcome
                        .pairs()
                        .flat_map(|pair| pair.local_slip)
                        .map(f64::abs),
                ),
                max_gap: largest(&mut outcome.pairs().map(|pair| pair.gap)),
            },
            certificate: outcome.certificate.clone(),
            times: TimesSummary {
                assembly: times.assembly,
                factorization: times.factorization,
                solve: times.solve,
                recovery: times.recovery,
                output,
                total: times.total() + output,
            },
            peak_memory_bytes: outcome.peak_memory_bytes,
            engine: outcome.description.engine.clone(),
            factorization: FactorSummary {
                work: outcome.description.factorization,
                gigaflops_per_second: outcome.description.factorization.gigaflops_per_second(),
            },
            threads: rayon::current_num_threads(),
            settings: outcome.settings.clone(),
        }
    }
}
