//! The run: model → matrices → dual problem → λ → u → certificate.

use std::ops::ControlFlow;
use std::time::Instant;

use serde::Serialize;
use tresca_la::vector::dot;
use tresca_qcqp::{DualProblem, Settings};

use crate::assemble::{Assembled, assemble};
use crate::certificate::{Candidate, certify};
use crate::dual::{
    EngineChoice, FactorWork, Factored, choose_engine, displacements, dual_problem, factor,
};
use crate::outcome::{Outcome, Times};
use crate::progress::{Progress, Stage};
use crate::{Model, ModelError, memory};

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
    /// The engine and why.
    pub engine: EngineChoice,
    /// What the factorisation cost.
    pub factorization: FactorWork,
}

/// A model that is assembled, factored and posed as a dual problem: ready to be solved, more
/// than once if need be.
pub struct Prepared {
    /// K, f, B, d, g.
    pub assembled: Assembled,
    /// The factors.
    pub factored: Factored,
    /// A, b and Λ.
    pub dual: DualProblem,
    /// Sizes and engine.
    pub description: Description,
    /// Seconds spent on assembly and factorisation.
    pub times: Times,
}

/// How a run ended.
pub enum Run {
    /// To its end. Whether it *converged*, the outcome's status says.
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
) -> Result<Run, ModelError> {
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
) -> Result<ControlFlow<Stage, Prepared>, ModelError> {
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
    let pairs = assembled.pair_count();
    let engine = choose_engine(settings.engine, 3 * pairs);
    let contact_last = engine.engine != tresca_qcqp::Engine::Factored;
    let factored = factor(model, &assembled, contact_last)?;
    let dual = dual_problem(&assembled, &factored, engine.engine)?;
    let description = Description {
        dofs: assembled.dof_count(),
        bodies: assembled.bodies.len(),
        pairs,
        held_pairs: assembled
            .contacts
            .iter()
            .map(|contact| contact.held_pairs)
            .sum(),
        engine,
        factorization: factored.work,
    };
    progress.problem(&description);
    Ok(ControlFlow::Continue(Prepared {
        assembled,
        factored,
        dual,
        description,
        times: Times {
            assembly,
            factorization: begin.elapsed().as_secs_f64(),
            ..Times::default()
        },
    }))
}

impl Prepared {
    /// Solves the dual problem and recovers displacements, contact state and certificate.
    ///
    /// # Errors
    /// When the settings are wrong.
    pub fn solve(
        &mut self,
        model: &Model,
        settings: &Settings,
        progress: &mut dyn Progress,
    ) -> Result<Run, ModelError> {
        if progress.stage(Stage::Solve).is_break() {
            return Ok(Run::Stopped(Stage::Solve));
        }
        let begin = Instant::now();
        let mut observer = |record: &tresca_qcqp::IterationRecord| progress.iteration(record);
        let solution = tresca_qcqp::solve(&mut self.dual, settings, None, &mut observer)?;
        let solve = begin.elapsed().as_secs_f64();

        // From here on the result exists; an interruption must not lose it.
        let _ = progress.stage(Stage::Recovery);
        let begin = Instant::now();
        let displacements = displacements(&self.assembled, &self.factored, &solution.lambda);
        let load_energy = self
            .assembled
            .bodies
            .iter()
            .zip(&self.factored.unconstrained)
            .map(|(system, u)| dot(&system.free_load(), u))
            .sum();
        let certificate = certify(
            model,
            &self.assembled,
            &Candidate {
                lambda: &solution.lambda,
                displacements: &displacements,
                dual_objective: solution.objective,
                load_energy,
            },
        )?;
        let times = Times {
            solve,
            recovery: begin.elapsed().as_secs_f64(),
            ..self.times
        };
        Ok(Run::Finished(Box::new(Outcome::new(
            &self.assembled,
            self.description.clone(),
            settings.clone(),
            solution,
            displacements,
            certificate,
            times,
            memory::peak_bytes(),
        ))))
    }
}
