//! The run: model → matrices → dual problem → λ → u → certificate, load step after load step.

use std::ops::ControlFlow;
use std::time::Instant;

use serde::Serialize;
use tresca_contact::Sliding;
use tresca_la::vector::{axpy, dot};
use tresca_qcqp::{DualProblem, Settings, Solution, Start, Status};

use crate::assemble::{Assembled, assemble};
use crate::certificate::{Candidate, certify};
use crate::dual::{
    EngineChoice, FactorWork, Factored, choose_engine, dual_problem, factor, full_displacements,
};
use crate::elastic::{add_motions, displacements, load_on_motions};
use crate::floating::unresisted;
use crate::layout::Layout;
use crate::load_step::{Acting, acting};
use crate::model::Step;
use crate::outcome::reactions::nodal_reactions;
use crate::outcome::surface_fields::SurfaceFields;
use crate::outcome::{Outcome, StepOutcome, Times, pair_states};
use crate::progress::{Progress, Stage};
use crate::{Model, SolveError, memory};

/// Sizes of a problem and how it is going to be solved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Description {
    /// n, free and held dofs of all bodies.
    pub dofs: usize,
    /// Number of bodies.
    pub bodies: usize,
    /// m, number of contact pairs.
    pub pairs: usize,
    /// Pairs left out because both nodes are held.
    pub held_pairs: usize,
    /// Rigid motions that the supports leave to the bodies, and that contact has to hold.
    pub rigid_motions: usize,
    /// The engine and why.
    pub engine: EngineChoice,
    /// What the factorisation cost.
    pub factorization: FactorWork,
}

/// A model that is assembled, factored and posed as a dual problem: ready to be solved, more
/// than once if need be.
pub struct Prepared {
    /// K, B, d and the friction data.
    pub assembled: Assembled,
    /// The factors.
    pub factored: Factored,
    /// A, b and Λ.
    pub dual: DualProblem<'static>,
    /// Sizes and engine.
    pub description: Description,
    /// Seconds spent on assembly and factorisation.
    pub times: Times,
}

/// How a run ended.
pub enum Run {
    /// To its end, or to the first step that failed. Whether it *converged*, the outcome's status says.
    Finished(Box<Outcome>),
    /// Stopped by the caller before the first iteration, at this stage: there is no result.
    Stopped(Stage),
}

/// Prepares and solves.
///
/// # Errors
/// When the model is wrong. How the solve ended is an outcome, not an error.
pub fn solve(
    model: &Model,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<Run, SolveError> {
    settings.validate()?;
    match prepare(model, settings, progress)? {
        ControlFlow::Break(stage) => Ok(Run::Stopped(stage)),
        ControlFlow::Continue(mut prepared) => prepared.solve(model, settings, progress),
    }
}

/// Assembles, factors and poses the dual problem.
///
/// # Errors
/// When the model is wrong.
pub fn prepare(
    model: &Model,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<ControlFlow<Stage, Prepared>, SolveError> {
    let begin = Instant::now();
    if progress.stage(Stage::Assembly).is_break() {
        return Ok(ControlFlow::Break(Stage::Assembly));
    }
    let assembled = assemble(model)?;
    let assembly = begin.elapsed().as_secs_f64();

    if progress.stage(Stage::Factorization).is_break() {
        return Ok(ControlFlow::Break(Stage::Factorization));
    }
    let begin = Instant::now();
    let many = model.steps().len() > 1
        || model
            .contacts()
            .iter()
            .any(|contact| contact.friction.is_coulomb());
    let engine = choose_engine(settings.engine, assembled.layout.unknowns(), many);
    let contact_last = engine.engine != tresca_qcqp::Engine::Factored;
    let factored = factor(model, &assembled, contact_last)?;
    let dual = dual_problem(model, &assembled, &factored, engine.engine)?;
    let floating = assembled
        .bodies
        .iter()
        .filter_map(|body| body.floating.as_ref());
    let description = Description {
        dofs: assembled.dof_count(),
        bodies: assembled.bodies.len(),
        pairs: assembled.pair_count(),
        held_pairs: assembled
            .contacts
            .iter()
            .map(|contact| contact.held_pairs)
            .sum(),
        rigid_motions: floating.map(|floating| floating.motions.len()).sum(),
        engine,
        factorization: factored.work,
    };
    progress.problem(&description);
    Ok(ControlFlow::Continue(Prepared {
        times: Times {
            assembly,
            contact: assembled.contact_seconds,
            factorization: begin.elapsed().as_secs_f64(),
            ..Times::default()
        },
        assembled,
        factored,
        dual,
        description,
    }))
}

/// Where the step before left the contact.
struct State {
    /// Number of the step that is made, from 1; 0 before the first.
    number: usize,
    /// B u.
    relative: Vec<f64>,
    /// The solver's unknowns μ and α with the laws they belong to; `None` before the first step.
    solved: Option<Solved>,
}

struct Solved {
    mu: Vec<f64>,
    multiplier: Vec<f64>,
    slidings: Vec<Sliding>,
}

impl Solved {
    /// μ as a start for other slip bounds: friction forces grow and shrink with their bounds, or the
    /// start would be worse than none.
    fn start(&self, layout: &Layout, slidings: &[Sliding]) -> Vec<f64> {
        let mut mu = self.mu.clone();
        let m = layout.pair_count();
        let tangents = layout.unknowns() / m - 1;
        for (i, (old, new)) in self.slidings.iter().zip(slidings).enumerate() {
            let largest = |sliding: &Sliding| match sliding {
                Sliding::Bounded([a, b]) => Some(a.max(*b)),
                Sliding::Never | Sliding::Coulomb { .. } => None,
            };
            if let (Some(old), Some(new)) = (largest(old), largest(new))
                && old > 0.0
                && old != new
            {
                let first = m + tangents * i;
                mu[first..first + tangents]
                    .iter_mut()
                    .for_each(|x| *x *= new / old);
            }
        }
        mu
    }
}

impl Prepared {
    /// Solves the load steps of the model one after another, each from the state that the one before
    /// left, and recovers displacements, contact state and certificate.
    ///
    /// # Errors
    /// When the settings are wrong, or a load is not finite.
    pub fn solve(
        &mut self,
        model: &Model,
        settings: &Settings,
        progress: &mut dyn Progress,
    ) -> Result<Run, SolveError> {
        let own;
        let steps = match model.steps() {
            [] => {
                own = [model.whole_step()];
                &own[..]
            }
            steps => steps,
        };
        // A run counts its own work, whatever was solved before.
        self.dual.forget();
        let mut state = State {
            number: 0,
            relative: vec![0.0; self.assembled.layout.unknowns()],
            solved: None,
        };
        let mut outcome = Outcome {
            description: self.description.clone(),
            settings: settings.clone(),
            steps: Vec::with_capacity(steps.len()),
            planned_steps: steps.len(),
            times: self.times,
            peak_memory_bytes: None,
        };
        for step in steps {
            state.number += 1;
            progress.step(state.number, steps.len(), step);
            if progress.stage(Stage::Solve).is_break() {
                if outcome.steps.is_empty() {
                    return Ok(Run::Stopped(Stage::Solve));
                }
                break;
            }
            let done = self.step(
                model,
                settings,
                step,
                &mut state,
                &mut outcome.times,
                progress,
            )?;
            let converged = done.converged();
            outcome.steps.push(done);
            if !converged {
                break;
            }
        }
        outcome.peak_memory_bytes = memory::peak_bytes();
        Ok(Run::Finished(Box::new(outcome)))
    }

    fn step(
        &mut self,
        model: &Model,
        settings: &Settings,
        step: &Step,
        state: &mut State,
        times: &mut Times,
        progress: &mut dyn Progress,
    ) -> Result<StepOutcome, SolveError> {
        let begin = Instant::now();
        let acting = acting(model, &self.assembled, step)?;
        let load_energy = self.pose(&acting, &state.relative)?;
        times.recovery += begin.elapsed().as_secs_f64();

        let begin = Instant::now();
        let mut observer = |record: &tresca_qcqp::IterationRecord| progress.iteration(record);
        let before = state.solved.as_ref().map(|solved| {
            let mu = solved.start(&self.assembled.layout, &acting.slidings);
            (mu, &solved.multiplier)
        });
        let start = before
            .as_ref()
            .map(|(lambda, multiplier)| Start { lambda, multiplier });
        let solution = tresca_qcqp::solve(&mut self.dual, settings, start, &mut observer)?;
        times.solve += begin.elapsed().as_secs_f64();
        times.multiplications += solution.seconds_in_products;

        // From here on the result exists; an interruption must not lose it.
        let _ = progress.stage(Stage::Recovery);
        let begin = Instant::now();
        let outcome = self.recover(model, step, &acting, solution, load_energy, state)?;
        times.recovery += begin.elapsed().as_secs_f64();
        Ok(outcome)
    }

    /// Poses the dual problem of a step: b = B u⁰ − c with u⁰ the displacement without contact (and
    /// obstacles where they are in the step), c = \[d; T u of the step before\], e = Rᵀf, and the slip bounds. Returns fᵀK⁺f.
    fn pose(&mut self, acting: &Acting, previous: &[f64]) -> Result<f64, SolveError> {
        let assembled = &self.assembled;
        let layout = &assembled.layout;
        let without = vec![0.0; layout.unknowns()];
        let bodies = assembled.elastic();
        let free = displacements(&bodies, &self.factored, &acting.free_loads, &without);
        let energy = acting
            .free_loads
            .iter()
            .zip(&free)
            .map(|(f, u)| dot(f, u))
            .sum();
        let mut b = assembled.relative(&full_displacements(assembled, &free, &acting.prescribed));
        axpy(1.0, &acting.obstacle_motion, &mut b);
        for (b, pair) in b.iter_mut().zip(assembled.pairs()) {
            *b -= pair.gap;
        }
        for i in layout.frictional(&acting.slidings) {
            b[i] -= previous[i];
        }
        self.dual.set_rhs(layout.dual(&b))?;
        self.dual.set_set(layout.set(&acting.slidings)?)?;
        if self.description.rigid_motions > 0 {
            let on_motions = load_on_motions(&bodies, &acting.free_loads);
            self.dual.set_equality_rhs(&on_motions)?;
        }
        Ok(energy)
    }

    fn recover(
        &self,
        model: &Model,
        step: &Step,
        acting: &Acting,
        solution: Solution,
        load_energy: f64,
        state: &mut State,
    ) -> Result<StepOutcome, SolveError> {
        let assembled = &self.assembled;
        let no_equilibrium = solution.status == Status::NoEquilibrium;
        let free = if no_equilibrium {
            // There is no displacement; the supports alone are where they should be.
            assembled
                .bodies
                .iter()
                .map(|body| vec![0.0; body.dofs.free_len()])
                .collect()
        } else {
            let (loads, mu) = (&acting.free_loads, &solution.lambda);
            let bodies = assembled.elastic();
            let mut free = displacements(&bodies, &self.factored, loads, mu);
            add_motions(&bodies, &solution.multiplier, &mut free);
            free
        };
        let displacements = full_displacements(assembled, &free, &acting.prescribed);
        let lambda = assembled.layout.forces(&solution.lambda);
        let relative = acting.relative(assembled, &displacements);
        let contacts = pair_states(
            assembled,
            acting,
            &solution,
            &lambda,
            &relative,
            &state.relative,
        );
        let reactions = (0..model.bodies().len())
            .map(|body| {
                nodal_reactions(model, assembled, acting, &displacements, &lambda, body).map_err(
                    |source| SolveError::Body {
                        body: model.bodies()[body].name.clone(),
                        source,
                    },
                )
            })
            .collect::<Result<Vec<_>, _>>()?;
        let surfaces = (0..model.bodies().len())
            .map(|body| {
                let forces = assembled.contact_forces(body, &lambda);
                SurfaceFields::new(model, assembled, &contacts, &forces, body)
            })
            .collect();
        let certificate = certify(
            model,
            assembled,
            &Candidate {
                lambda: &lambda,
                displacements: &displacements,
                reactions: &reactions,
                previous: &state.relative,
                acting,
                dual_objective: solution.objective,
                load_energy,
            },
        );
        let motion = solution.motion.as_deref().filter(|_| no_equilibrium);
        let unresisted = motion.map(|v| unresisted(model, assembled, v));
        state.relative = relative;
        state.solved = Some(Solved {
            mu: solution.lambda.clone(),
            multiplier: solution.multiplier.clone(),
            slidings: acting.slidings.clone(),
        });
        Ok(StepOutcome {
            number: state.number,
            time: step.time,
            name: step.name.clone(),
            solution,
            displacements,
            reactions,
            contacts,
            surfaces,
            certificate,
            unresisted,
        })
    }
}
