//! The run of a model: model → matrices → dual problem → forces → displacements, load step after load step.

use std::time::Instant;

use tresca_qcqp::{Engine, Settings};
use tresca_system::body::{FactorFailure, SystemBody};
use tresca_system::description::{Description, Times};
use tresca_system::engine::choose_engine;
use tresca_system::factors::Factors;
use tresca_system::load_case::WarmStart;
use tresca_system::prepared::{Parts, Prepared};
use tresca_system::progress::{Progress, Silent, Stage, StepInfo, begin};
use tresca_system::solved::Solved;

use crate::assemble::{Assembled, assemble};
use crate::balance::{balance, magnitude};
use crate::error::SolveError;
use crate::load_step::{Acting, acting};
use crate::memory;
use crate::outcome::reactions::nodal_reactions;
use crate::outcome::surface_fields::SurfaceFields;
use crate::outcome::{Outcome, StepOutcome};
use crate::pair_state::pair_states;
use crate::unresisted::unresisted;
use tresca_model::{Model, Step};

/// Solves a model with the default settings.
///
/// # Errors
/// When the model is wrong. How the solve ended is an outcome, not an error.
pub fn solve(model: &Model) -> Result<Outcome, SolveError> {
    solve_with(model, &Settings::default(), &mut Silent)
}

/// Solves a model; `progress` hears of it and may stop it.
///
/// # Errors
/// When the model or a setting is wrong, and [`SolveError::Stopped`] when `progress` stops the run before its
/// first iteration: there is no outcome then. Later it is an outcome.
pub fn solve_with(
    model: &Model,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<Outcome, SolveError> {
    settings.validate()?;
    prepare(model, settings, progress)?.solve(settings, progress)
}

/// A model that is assembled, factored and posed as a dual problem: ready to be solved, more than once if need
/// be.
pub struct PreparedModel<'m> {
    model: &'m Model,
    assembled: Assembled,
    system: Prepared,
}

/// Assembles, factors and poses the dual problem.
///
/// # Errors
/// When the model is wrong, or `progress` stops the run.
pub fn prepare<'m>(
    model: &'m Model,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<PreparedModel<'m>, SolveError> {
    begin(progress, Stage::Assembly)?;
    let clock = Instant::now();
    let (assembled, mut bodies) = assemble(model)?;
    let stiffness_unit = SystemBody::tame(&mut bodies);
    let assembly = clock.elapsed().as_secs_f64();

    begin(progress, Stage::Factorization)?;
    let clock = Instant::now();
    let coulomb = |contact: &tresca_model::Contact| contact.friction.is_coulomb();
    let many = model.steps().len() > 1 || model.contacts().iter().any(coulomb);
    let engine = choose_engine(settings.engine, assembled.layout.unknowns(), many);
    let factors = Factors::new(&bodies, engine.engine != Engine::Factored);
    let factors = factors.map_err(|(body, failure)| factor_error(model, body, failure))?;
    let slidings: Vec<_> = assembled.pairs().map(|pair| pair.sliding).collect();
    let parts = Parts {
        bodies,
        factors,
        layout: assembled.layout.clone(),
        slidings: &slidings,
        patches: assembled.patches(),
        engine,
        stiffness_unit,
        // Rows of a model stand on nodes of their own, or repeat exactly.
        distance_of_rows: 1.0,
        dofs: assembled.dof_count(),
        held_pairs: assembled.contacts.iter().map(|data| data.held_pairs).sum(),
    };
    let mut times = Times::default();
    times.assembly = assembly;
    times.contact = assembled.contact_seconds;
    times.factorization = clock.elapsed().as_secs_f64();
    let system = Prepared::new(parts, times)?;
    progress.problem(system.description());
    Ok(PreparedModel {
        model,
        assembled,
        system,
    })
}

/// The error of a body that has no factor.
pub fn factor_error(model: &Model, body: usize, failure: FactorFailure) -> SolveError {
    let body = model.bodies()[body].name.clone();
    match failure {
        FactorFailure::Ordering(source) => SolveError::Ordering { body, source },
        FactorFailure::Factor(source) => SolveError::Factorization { body, source },
    }
}

/// Where the step before left the contact.
struct State {
    /// B u.
    relative: Vec<f64>,
    /// What the solver may start from; `None` before the first step.
    start: Option<WarmStart>,
}

impl PreparedModel<'_> {
    /// The model.
    pub fn model(&self) -> &Model {
        self.model
    }

    /// The dofs, and the pairs with their frames, gaps and areas.
    pub fn assembled(&self) -> &Assembled {
        &self.assembled
    }

    /// Sizes and engine.
    pub fn description(&self) -> &Description {
        self.system.description()
    }

    /// The bodies as linear algebra; their factors go.
    pub fn into_bodies(self) -> Vec<SystemBody> {
        self.system.into_bodies()
    }

    /// The factored bodies and their dual problem.
    pub fn system(&mut self) -> &mut Prepared {
        &mut self.system
    }

    /// Solves the load steps of the model one after another, each from the state that the one before
    /// left, and recovers displacements, contact state and certificate.
    ///
    /// # Errors
    /// When the settings are wrong, a load is not finite, or `progress` stops the run before the first
    /// iteration.
    pub fn solve(
        &mut self,
        settings: &Settings,
        progress: &mut dyn Progress,
    ) -> Result<Outcome, SolveError> {
        let own;
        let steps = match self.model.steps() {
            [] => {
                own = [self.model.whole_step()];
                &own[..]
            }
            steps => steps,
        };
        // A run counts its own work, whatever was solved before.
        self.system.dual().forget();
        let mut state = State {
            relative: vec![0.0; self.assembled.layout.unknowns()],
            start: None,
        };
        let mut outcome = Outcome {
            description: self.system.description().clone(),
            settings: settings.clone(),
            steps: Vec::with_capacity(steps.len()),
            planned_steps: steps.len(),
            times: self.system.times(),
            peak_memory_bytes: None,
        };
        for (index, step) in steps.iter().enumerate() {
            let info = StepInfo::new(index + 1, steps.len(), step.time, step.name.as_deref());
            progress.step(&info);
            let done = self.step(
                &info,
                step,
                &mut state,
                settings,
                &mut outcome.times,
                progress,
            );
            let done = match done {
                // What was solved so far is a result.
                Err(SolveError::Stopped(_)) if index > 0 => break,
                done => done?,
            };
            let converged = done.converged();
            outcome.steps.push(done);
            if !converged {
                break;
            }
        }
        outcome.peak_memory_bytes = memory::peak_bytes();
        Ok(outcome)
    }

    fn step(
        &mut self,
        info: &StepInfo<'_>,
        step: &Step,
        state: &mut State,
        settings: &Settings,
        times: &mut Times,
        progress: &mut dyn Progress,
    ) -> Result<StepOutcome, SolveError> {
        let clock = Instant::now();
        let acting = acting(self.model, &self.assembled, step, &state.relative)?;
        times.recovery += clock.elapsed().as_secs_f64();
        let start = state.start.as_ref();
        let solved = self
            .system
            .solve(&acting.case, start, settings, times, progress)?;
        let clock = Instant::now();
        state.start = Some(solved.start());
        let outcome = self.recover(info, &acting, solved, settings, &mut state.relative)?;
        times.recovery += clock.elapsed().as_secs_f64();
        Ok(outcome)
    }

    /// From the free dofs to the bodies: fields, reactions, balances. `relative` is B u of the step before, and
    /// becomes that of this one.
    fn recover(
        &self,
        info: &StepInfo<'_>,
        acting: &Acting,
        mut solved: Solved,
        settings: &Settings,
        relative: &mut Vec<f64>,
    ) -> Result<StepOutcome, SolveError> {
        let (model, assembled) = (self.model, &self.assembled);
        let displacements = assembled.full_displacements(&solved.displacements, &acting.prescribed);
        let contacts = pair_states(assembled, &solved, relative);
        let mut reactions = Vec::with_capacity(model.bodies().len());
        let mut surfaces = Vec::with_capacity(model.bodies().len());
        let contact = |index| assembled.contact_forces(index, &solved.forces);
        let all: Vec<Vec<f64>> = (0..model.bodies().len()).map(contact).collect();
        let acts = model.bodies().iter().zip(acting.loads.iter().zip(&all));
        let acts =
            acts.map(|(body, (load, forces))| magnitude(body, load).max(magnitude(body, forces)));
        let largest = acts.fold(0.0, f64::max);
        for ((index, body), forces) in model.bodies().iter().enumerate().zip(all) {
            let load = &acting.loads[index];
            let dofs = &assembled.bodies[index].dofs;
            let reaction = nodal_reactions(body, dofs, &displacements[index], load, &forces);
            let reaction = reaction.map_err(|source| SolveError::Body {
                body: body.name.clone(),
                source,
            })?;
            let own = balance(body, [load, &forces, &reaction], largest);
            solved.certificate.bodies.push(own);
            surfaces.push(SurfaceFields::new(
                model, assembled, &contacts, &forces, index,
            ));
            reactions.push(reaction);
        }
        solved.judge_again(settings);
        let motion = solved.dual.motion.as_ref().zip(solved.unresisted.as_ref());
        let unresisted = motion.map(|(v, free)| unresisted(model, assembled, v, free));
        *relative = solved.relative;
        Ok(StepOutcome {
            number: info.number,
            time: info.time,
            name: info.name.map(str::to_owned),
            solution: solved.dual,
            displacements,
            reactions,
            contacts,
            surfaces,
            certificate: solved.certificate,
            unresisted,
            failure: solved.failure,
            contradiction: solved.contradiction,
        })
    }
}
