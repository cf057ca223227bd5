//! What a run gives back: for each load step displacements, the state of every contact pair, the
//! certificate.

pub(crate) mod reactions;
pub(crate) mod surface_fields;

use tresca_qcqp::{DualSolution, Settings, Status};
use tresca_system::certificate::{Certificate, Failure};
use tresca_system::contradiction::Contradiction;
use tresca_system::description::{Description, Times};

use crate::outcome::surface_fields::SurfaceFields;
use crate::pair_state::PairState;
use crate::unresisted::UnresistedMotion;

/// The result of one load step.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct StepOutcome {
    /// Number of the step, from 1.
    pub number: usize,
    /// Instant in the time series.
    pub time: f64,
    /// How the case calls the step.
    pub name: Option<String>,
    /// The dual solution: status, iteration records, counts. Its `lambda` holds the solver's unknowns;
    /// the forces stand in [`StepOutcome::contacts`].
    pub solution: DualSolution,
    /// Displacement of each body over its full dofs (x, y, z node by node).
    pub displacements: Vec<Vec<f64>>,
    /// Reactions of the supports on each body over its full dofs, zero at free ones.
    pub reactions: Vec<Vec<f64>>,
    /// Contact as fields on the nodes of each body.
    pub surfaces: Vec<SurfaceFields>,
    /// State of the pairs, one list per contact of the model.
    pub contacts: Vec<Vec<PairState>>,
    /// Independent check of the result.
    pub certificate: Certificate,
    /// With [`Status::NoEquilibrium`]: the motion that nothing resists.
    pub unresisted: Option<UnresistedMotion>,
    /// With [`Status::Inaccurate`]: what of the certificate fails.
    pub failure: Option<Failure>,
    /// With [`Status::Infeasible`]: the pairs whose constraints contradict each other.
    pub contradiction: Option<Contradiction>,
}

impl StepOutcome {
    /// Did the method reach its tolerance?
    pub fn converged(&self) -> bool {
        self.solution.status == Status::Converged
    }

    /// All pairs.
    pub fn pairs(&self) -> impl Iterator<Item = &PairState> {
        self.contacts.iter().flatten()
    }

    /// Work that friction dissipates in the step.
    pub fn dissipation(&self) -> f64 {
        self.pairs().map(PairState::dissipation).sum()
    }
}

/// The result of a run.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Outcome {
    /// Sizes, engine, factorisation.
    pub description: Description,
    /// The settings that were in force.
    pub settings: Settings,
    /// The steps that were made, at least one. A run ends with the first step that does not converge.
    pub steps: Vec<StepOutcome>,
    /// Steps that the model has.
    pub planned_steps: usize,
    /// Wall-clock times.
    pub times: Times,
    /// Peak memory of the process so far, where the system tells.
    pub peak_memory_bytes: Option<u64>,
}

impl Outcome {
    /// How the run ended: as its last step did, and `Interrupted` when steps are missing.
    pub fn status(&self) -> Status {
        match self.last().solution.status {
            Status::Converged if self.steps.len() < self.planned_steps => Status::Interrupted,
            status => status,
        }
    }

    /// Did every step reach its tolerance?
    pub fn converged(&self) -> bool {
        self.status() == Status::Converged
    }

    /// The step made last.
    ///
    /// # Panics
    /// Never: a run without a step has no outcome.
    pub fn last(&self) -> &StepOutcome {
        self.steps.last().expect("a run has at least one step")
    }
}
