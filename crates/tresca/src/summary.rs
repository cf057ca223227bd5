//! The summary of a run, as it is written to `summary.json`.

use serde::Serialize;
use tresca_qcqp::{Figures, Settings, Status};

use crate::certificate::Certificate;
use crate::floating::UnresistedMotion;
use crate::model::Model;
use crate::outcome::{Outcome, StepOutcome};
use crate::pair_state::PairState;
use crate::reactions::{SupportReaction, support_reactions};
use tresca_system::engine::EngineChoice;
use tresca_system::factors::FactorWork;

/// `summary.json`. Forces, lengths and stresses in the user's units.
#[derive(Debug, Clone, Serialize)]
pub struct Summary {
    /// Title of the case.
    pub title: String,
    /// Version of tresca.
    pub version: &'static str,
    /// How the run ended: as its last step, `interrupted` when steps are missing.
    pub status: Status,
    /// The method.
    pub method: &'static str,
    /// Iterations of all steps.
    pub iterations: usize,
    /// Multiplications by A in all steps, estimate of σmax included.
    pub n_a: usize,
    /// Multiplications that went into the estimate of σmax.
    pub n_a_setup: usize,
    /// Free and held dofs of all bodies.
    pub dofs: usize,
    /// Bodies.
    pub bodies: usize,
    /// Rigid motions that supports leave and contact has to hold.
    pub rigid_motions: usize,
    /// Steps that the case has.
    pub planned_steps: usize,
    /// The steps that were made.
    pub steps: Vec<StepSummary>,
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

/// A load step.
#[derive(Debug, Clone, Serialize)]
pub struct StepSummary {
    /// Its number, from 1.
    pub step: usize,
    /// Instant in the time series.
    pub time: f64,
    /// Its name in the case.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// How the method ended.
    pub status: Status,
    /// Iterations, multiplications by A, residuals, objective.
    #[serde(flatten)]
    pub figures: Figures,
    /// The contact in figures.
    pub contact: ContactSummary,
    /// The force that each contact hands from the slave to the master.
    pub resultants: Vec<ContactResultant>,
    /// What each support carries.
    pub reactions: Vec<SupportReaction>,
    /// Independent check of the result.
    pub certificate: Certificate,
    /// With `no_equilibrium`: what moves without resistance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unresisted_motion: Option<MotionSummary>,
}

/// Resultant of one contact.
#[derive(Debug, Clone, Serialize)]
pub struct ContactResultant {
    /// The slave surface, as `body.faces`.
    pub slave: String,
    /// The master surface.
    pub master: String,
    /// Σ λν.
    pub normal_force_sum: f64,
    /// Σ (λν ν + λτ) in global components: the force on the master; the slave feels the opposite. In an
    /// axisymmetric model the radial parts of a ring cancel: the first entry is their sum nevertheless.
    pub force: [f64; 3],
    /// Moment of that force about the origin of the coordinates, the slave points being its points of
    /// attack.
    pub moment: [f64; 3],
}

/// A motion that nothing resists.
#[derive(Debug, Clone, Serialize)]
pub struct MotionSummary {
    /// What moves, and how.
    pub bodies: Vec<BodyMotion>,
    /// Contacts that open or slide in it.
    pub contacts: Vec<ContactMotion>,
}

/// A body in such a motion.
#[derive(Debug, Clone, Serialize)]
pub struct BodyMotion {
    /// The body.
    pub body: String,
    /// Translation or rotation, in words.
    pub motion: String,
}

/// A contact in such a motion.
#[derive(Debug, Clone, Serialize)]
pub struct ContactMotion {
    /// Slave and master surface.
    pub contact: String,
    /// `opens` or `slides`.
    pub does: &'static str,
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
    /// Work that friction dissipates in the step.
    pub dissipation: f64,
}

/// Wall-clock seconds.
#[derive(Debug, Clone, Serialize)]
pub struct TimesSummary {
    /// Stiffness, loads, contact data.
    pub assembly: f64,
    /// Contact search and coupling, a part of the assembly.
    pub contact: f64,
    /// Ordering, analysis, factorisation, set-up of the dual operator.
    pub factorization: f64,
    /// The dual problem.
    pub solve: f64,
    /// Multiplications by A, a part of the solve.
    pub multiplications: f64,
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
    pub fn new(model: &Model, outcome: &Outcome, output: f64) -> Self {
        let times = outcome.times;
        let solutions = || outcome.steps.iter().map(|step| &step.solution);
        Self {
            title: model.title().to_owned(),
            version: crate::VERSION,
            status: outcome.status(),
            method: outcome.settings.method.name(),
            iterations: solutions()
                .map(|solution| solution.figures.iterations)
                .sum(),
            n_a: solutions().map(|solution| solution.figures.n_a).sum(),
            n_a_setup: solutions().map(|solution| solution.figures.n_a_setup).sum(),
            dofs: outcome.description.dofs,
            bodies: outcome.description.bodies,
            rigid_motions: outcome.description.rigid_motions,
            planned_steps: outcome.planned_steps,
            steps: outcome
                .steps
                .iter()
                .map(|step| StepSummary::new(model, step, outcome.description.held_pairs))
                .collect(),
            times: TimesSummary {
                assembly: times.assembly,
                contact: times.contact,
                factorization: times.factorization,
                solve: times.solve,
                multiplications: times.multiplications,
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

    /// The step made last.
    ///
    /// # Panics
    /// Never: a run without a step has no summary.
    pub fn last(&self) -> &StepSummary {
        self.steps.last().expect("a run has at least one step")
    }
}

impl StepSummary {
    fn new(model: &Model, step: &StepOutcome, held: usize) -> Self {
        let solution = &step.solution;
        let count = |test: fn(&PairState) -> bool| step.pairs().filter(|pair| test(pair)).count();
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        Self {
            step: step.number,
            time: step.time,
            name: step.name.clone(),
            status: solution.status,
            figures: solution.figures,
            contact: ContactSummary {
                pairs: step.pairs().count(),
                closed: count(|pair| pair.closed),
                open: count(|pair| !pair.closed),
                stick: count(|pair| pair.stick),
                slip: count(|pair| !pair.stick),
                held,
                normal_force_sum: step.pairs().map(|pair| pair.normal_force).sum(),
                max_pressure: largest(&mut step.pairs().map(PairState::pressure)),
                max_slip_component: largest(
                    &mut step.pairs().flat_map(|pair| pair.local_slip).map(f64::abs),
                ),
                max_gap: largest(&mut step.pairs().map(|pair| pair.gap)),
                dissipation: step.dissipation(),
            },
            resultants: resultants(model, step),
            reactions: support_reactions(model, &step.reactions),
            certificate: step.certificate.clone(),
            unresisted_motion: step.unresisted.as_ref().map(motion),
        }
    }
}

fn resultants(model: &Model, step: &StepOutcome) -> Vec<ContactResultant> {
    let contacts = model.contacts().iter().zip(&step.contacts);
    contacts
        .map(|(contact, pairs)| {
            let force = |pair: &PairState| -> [f64; 3] {
                let normal = pair.pair.frame.normal;
                std::array::from_fn(|k| pair.normal_force * normal[k] + pair.friction_force[k])
            };
            ContactResultant {
                slave: model.surface_name(&contact.slave),
                master: model.partner_name(&contact.master),
                normal_force_sum: pairs.iter().map(|pair| pair.normal_force).sum(),
                force: std::array::from_fn(|k| pairs.iter().map(|pair| force(pair)[k]).sum()),
                moment: std::array::from_fn(|k| {
                    let arms = pairs
                        .iter()
                        .map(|pair| cross(pair.pair.point, force(pair))[k]);
                    arms.sum()
                }),
            }
        })
        .collect()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

fn motion(motion: &UnresistedMotion) -> MotionSummary {
    let bodies = motion.bodies.iter().cloned();
    let contacts = motion.contacts.iter().cloned();
    MotionSummary {
        bodies: bodies
            .map(|(body, motion)| BodyMotion { body, motion })
            .collect(),
        contacts: contacts
            .map(|(contact, does)| ContactMotion { contact, does })
            .collect(),
    }
}
