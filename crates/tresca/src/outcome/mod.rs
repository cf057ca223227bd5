//! What a run gives back: for each load step displacements, the state of every contact pair, the
//! certificate.

pub(crate) mod reactions;
pub(crate) mod surface_fields;

use serde::Serialize;
use tresca_contact::ContactPair;
use tresca_qcqp::{Settings, Solution, Status};

use crate::assemble::Assembled;
use crate::certificate::Certificate;
use crate::floating::UnresistedMotion;
use crate::load_step::Acting;
use crate::solve::Description;
use surface_fields::SurfaceFields;

/// Wall-clock seconds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Times {
    /// Stiffness and contact data.
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

/// The state of one contact pair.
#[derive(Debug, Clone, PartialEq)]
pub struct PairState {
    /// The pair: nodes, frame, gap, area, law.
    pub pair: ContactPair,
    /// Does it carry a normal force? Tied and bilateral pairs always count as closed.
    pub closed: bool,
    /// Is the friction force below the slip bound?
    pub stick: bool,
    /// λν, positive in compression; negative only where the law never lets the pair open.
    pub normal_force: f64,
    /// λτ in global components: the force that the slave puts on the master.
    pub friction_force: [f64; 3],
    /// λτ in the pair's frame.
    pub local_friction: [f64; 2],
    /// The slip bounds (forces) along τ1, τ2 that hold in this step; `None` where nothing slides.
    pub slip_bounds: Option<[f64; 2]>,
    /// Gap left, d − N u.
    pub gap: f64,
    /// Slip T u in global components: motion of the slave relative to the master, since the start.
    pub slip: [f64; 3],
    /// The two components of the slip in the pair's frame.
    pub local_slip: [f64; 2],
    /// The same since the step before: what friction acts on.
    pub local_slip_increment: [f64; 2],
}

impl PairState {
    /// Contact pressure λν / area.
    pub fn pressure(&self) -> f64 {
        self.normal_force / self.pair.area
    }

    /// Tangential traction λτ / area.
    pub fn friction_traction(&self) -> [f64; 3] {
        self.friction_force.map(|x| x / self.pair.area)
    }

    /// Work that friction dissipates in the step, λτ·ΔTu.
    pub fn dissipation(&self) -> f64 {
        self.local_friction[0] * self.local_slip_increment[0]
            + self.local_friction[1] * self.local_slip_increment[1]
    }
}

/// The result of one load step.
#[derive(Debug, Clone)]
pub struct StepOutcome {
    /// Number of the step, from 1.
    pub number: usize,
    /// Instant in the time series.
    pub time: f64,
    /// How the case calls the step.
    pub name: Option<String>,
    /// The dual solution: status, iteration records, counts. Its `lambda` holds the solver's unknowns;
    /// the forces stand in [`StepOutcome::contacts`].
    pub solution: Solution,
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

/// The pairs of a step, contact by contact. `lambda` are the forces, `relative` and `previous` B u now
/// and in the step before.
pub(crate) fn pair_states(
    assembled: &Assembled,
    acting: &Acting,
    solution: &Solution,
    lambda: &[f64],
    relative: &[f64],
    previous: &[f64],
) -> Vec<Vec<PairState>> {
    let layout = &assembled.layout;
    let state = |i: usize, pair: &ContactPair| {
        let (closed, stick) = layout.state(&solution.active_set, i);
        let global = |[a, b]: [f64; 2]| pair.frame.to_global([0.0, a, b]);
        let local_slip = layout.tangential(relative, i);
        let before = layout.tangential(previous, i);
        let local_friction = layout.tangential(lambda, i);
        PairState {
            closed,
            stick,
            normal_force: lambda[i],
            friction_force: global(local_friction),
            local_friction,
            slip_bounds: acting.slidings[i].bounds(lambda[i]),
            gap: pair.gap - relative[i],
            slip: global(local_slip),
            local_slip,
            local_slip_increment: std::array::from_fn(|k| local_slip[k] - before[k]),
            pair: pair.clone(),
        }
    };
    let mut first = 0;
    let contact = |data: &tresca_contact::ContactData| {
        let base = first;
        first += data.pairs.len();
        let pairs = data.pairs.iter().enumerate();
        pairs
            .map(|(offset, pair)| state(base + offset, pair))
            .collect()
    };
    assembled.contacts.iter().map(contact).collect()
}
