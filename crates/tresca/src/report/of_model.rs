//! The report of a model that was solved.

use super::contact::{ContactReport, largest, resultants};
use super::contradiction::ContradictionReport;
use super::motion::MotionReport;
use super::reactions::support_reactions;
use super::run::{RunReport, Source, StepReport};
use crate::outcome::{Outcome, StepOutcome};
use crate::pair_state::PairState;
use tresca_model::Model;

impl RunReport {
    /// Of a model.
    pub fn of_model(model: &Model, outcome: &Outcome) -> Self {
        let held = outcome.description.held_pairs;
        let steps = outcome.steps.iter().map(|step| of_step(model, step, held));
        Self {
            title: Some(model.title().to_owned()),
            system: Some((&outcome.description).into()),
            planned_steps: outcome.planned_steps,
            times: outcome.times.into(),
            peak_memory_bytes: outcome.peak_memory_bytes,
            ..Self::new(
                Source::Case,
                &outcome.settings,
                outcome.status(),
                steps.collect(),
            )
        }
    }
}

fn of_step(model: &Model, step: &StepOutcome, held: usize) -> StepReport {
    let solution = &step.solution;
    StepReport {
        step: step.number,
        time: step.time,
        name: step.name.clone(),
        resultants: resultants(model, &step.contacts),
        reactions: support_reactions(model, &step.reactions),
        unresisted_motion: step.unresisted.as_ref().map(MotionReport::from),
        failure: step.failure.clone(),
        contradiction: step
            .contradiction
            .as_ref()
            .map(|own| ContradictionReport::of_model(own, model, &step.contacts)),
        ..StepReport::new(
            solution.status,
            solution.figures,
            solution.active_set.counts(),
            contact(step, held),
            step.certificate.clone(),
        )
    }
}

fn contact(step: &StepOutcome, held: usize) -> ContactReport {
    let count = |test: fn(&PairState) -> bool| step.pairs().filter(|pair| test(pair)).count();
    let slips = step.pairs().flat_map(|pair| pair.local_slip);
    ContactReport {
        pairs: step.pairs().count(),
        closed: count(|pair| pair.closed),
        open: count(|pair| !pair.closed),
        open_with_friction: count(|pair| !pair.closed && pair.local_friction != [0.0; 2]),
        stick: count(|pair| pair.closed && pair.stick),
        slip: count(|pair| pair.closed && !pair.stick),
        held: Some(held),
        normal_force_sum: step.pairs().map(|pair| pair.normal_force).sum(),
        max_pressure: Some(largest(step.pairs().map(PairState::pressure))),
        max_slip_component: Some(largest(slips.map(f64::abs))),
        max_gap: Some(largest(step.pairs().map(|pair| pair.gap))),
        dissipation: Some(step.dissipation()),
    }
}
