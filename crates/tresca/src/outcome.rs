//! What a run gives back: displacements, the state of every contact pair, the certificate.

use serde::Serialize;
use tresca_contact::ContactPair;
use tresca_qcqp::sets::BlockState;
use tresca_qcqp::{Settings, Solution, Status};

use crate::assemble::Assembled;
use crate::certificate::Certificate;
use crate::solve::Description;

/// Wall-clock seconds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Times {
    /// Stiffness, loads and contact data.
    pub assembly: f64,
    /// Ordering, analysis and factorisation of all bodies, and the set-up of the dual operator.
    pub factorization: f64,
    /// The dual problem, estimate of σmax included.
    pub solve: f64,
    /// Displacements and certificate.
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
    /// The pair: nodes, frame, gap, area, slip bound.
    pub pair: ContactPair,
    /// Does it carry a normal force?
    pub closed: bool,
    /// Is the friction force below the slip bound?
    pub stick: bool,
    /// λν ≥ 0.
    pub normal_force: f64,
    /// λτ in global components: the force that the slave puts on the master.
    pub friction_force: [f64; 3],
    /// Gap left, d − N u.
    pub gap: f64,
    /// Slip T u in global components: motion of the slave relative to the master.
    pub slip: [f64; 3],
    /// The two components of the slip in the pair's frame.
    pub local_slip: [f64; 2],
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
}

/// The result of a run.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Sizes, engine, factorisation.
    pub description: Description,
    /// The settings that were in force.
    pub settings: Settings,
    /// The dual solution: status, λ, iteration records, counts.
    pub solution: Solution,
    /// Displacement of each body over its full dofs (x, y, z node by node).
    pub displacements: Vec<Vec<f64>>,
    /// State of the pairs, one list per contact of the model.
    pub contacts: Vec<Vec<PairState>>,
    /// Independent check of the result.
    pub certificate: Certificate,
    /// Wall-clock times.
    pub times: Times,
    /// Peak memory of the process so far, where the system tells.
    pub peak_memory_bytes: Option<u64>,
}

impl Outcome {
    #[expect(
        clippy::too_many_arguments,
        reason = "one place that gathers the parts of a result"
    )]
    pub(crate) fn new(
        assembled: &Assembled,
        description: Description,
        settings: Settings,
        solution: Solution,
        displacements: Vec<Vec<f64>>,
        certificate: Certificate,
        times: Times,
        peak_memory_bytes: Option<u64>,
    ) -> Self {
        let contacts = pair_states(assembled, &solution, &displacements);
        Self {
            description,
            settings,
            solution,
            displacements,
            contacts,
            certificate,
            times,
            peak_memory_bytes,
        }
    }

    /// Did the method reach its tolerance?
    pub fn converged(&self) -> bool {
        self.solution.status == Status::Converged
    }

    /// All pairs.
    pub fn pairs(&self) -> impl Iterator<Item = &PairState> {
        self.contacts.iter().flatten()
    }
}

fn pair_states(
    assembled: &Assembled,
    solution: &Solution,
    displacements: &[Vec<f64>],
) -> Vec<Vec<PairState>> {
    let m = assembled.pair_count();
    let mut relative = vec![0.0; 3 * m];
    for (system, u) in assembled.bodies.iter().zip(displacements) {
        let free = system.dofs.restrict(u);
        system.coupling.add_product(&free, &mut relative);
    }
    let states = solution.active_set.states();
    let lambda = &solution.lambda;
    let mut first = 0;
    assembled
        .contacts
        .iter()
        .map(|contact| {
            let base = first;
            first += contact.pairs.len();
            contact
                .pairs
                .iter()
                .enumerate()
                .map(|(offset, pair)| {
                    let i = base + offset;
                    let tangential = |values: &[f64]| [values[m + 2 * i], values[m + 2 * i + 1]];
                    let global = |[a, b]: [f64; 2]| pair.frame.to_global([0.0, a, b]);
                    let local_slip = tangential(&relative);
                    PairState {
                        closed: states[i] == BlockState::Free,
                        stick: states[m + i] == BlockState::Free,
                        normal_force: lambda[i],
                        friction_force: global(tangential(lambda)),
                        gap: pair.gap - relative[i],
                        slip: global(local_slip),
                        local_slip,
                        pair: pair.clone(),
                    }
                })
                .collect()
        })
        .collect()
}
