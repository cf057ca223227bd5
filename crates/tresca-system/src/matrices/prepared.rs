//! An algebraic problem, checked, factored and posed; solved as often as need be.

use std::time::Instant;

use tresca_contact::Mobility;
use tresca_qcqp::{DualProblem, Engine, Settings};

use super::bodies::{self, Bodies, BodyDofs};
use super::error::AlgebraicError;
use super::friction::PairLaw;
use super::note::Note;
use super::parts::Stiffness;
use super::problem::{Conditions, MatrixProblem};
use super::solution::{Forces, Solution};
use super::{check, lengths, patches, rank};
use crate::description::{Description, Times};
use crate::engine::choose_engine;
use crate::load_case::{LoadCase, WarmStart};
use crate::prepared::{Parts, Prepared};
use crate::progress::{Progress, Stage, begin};

/// Prepares and solves.
///
/// `progress` hears the stages and every iteration; a `Break` of an iteration ends the run with
/// [`Status::Interrupted`](tresca_qcqp::Status::Interrupted) and what there is by then.
///
/// # Errors
/// When the matrices, vectors or settings are wrong, or `progress` stops the run before its first iteration.
/// How the solve ended stands in the solution.
pub fn solve(
    problem: &MatrixProblem,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<Solution, AlgebraicError> {
    settings.validate()?;
    let mut prepared = prepare(problem, settings, progress)?;
    prepared.solve(&problem.conditions, settings, progress)
}

/// A problem that is checked, factored and posed in its dual form.
pub struct PreparedProblem {
    dofs: BodyDofs,
    tangents: usize,
    mobility: Vec<Mobility>,
    system: Prepared,
    notes: Vec<Note>,
}

/// Checks the problem, factors K, poses the dual problem.
///
/// # Errors
/// Everything that is wrong with the input.
pub fn prepare(
    problem: &MatrixProblem,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<PreparedProblem, AlgebraicError> {
    settings.validate()?;
    begin(progress, Stage::Assembly)?;
    let clock = Instant::now();
    let mut notes = Vec::new();
    let stiffness = Stiffness::new(&problem.stiffness, &mut notes)?;
    let dofs = stiffness.matrix.rows();
    let m = problem.normal.rows();
    let (b, tangents) = check::contact_rows(&problem.normal, problem.tangential.as_ref(), dofs)?;
    check_conditions(&problem.conditions, dofs, m, tangents)?;
    let laws = problem.conditions.friction.laws(m)?;
    let mobility = check::mobility(&b, m, tangents, &mut notes)?;
    let mut layout = check::layout(&laws, &mobility, tangents)?;
    let scales = lengths::scales(&lengths::of_rows(&b), m, tangents);
    if let Some(scales) = scales {
        layout = layout.with_scales(scales);
    }
    check::note_ignored_figures(&laws, tangents, &mut notes);
    if let Some(points) = &problem.points {
        check::vector(
            "the points of the pairs",
            points.as_flattened(),
            3 * m,
            "three per contact pair",
        )?;
    }
    let dependent = rank::dependent_rows(&b.clone().with_rows_scaled(layout.weights()));
    let singular = !dependent.rows.is_empty();
    if singular {
        let rows = dependent
            .rows
            .into_iter()
            .map(|row| check::named(row, m))
            .collect();
        notes.push(Note::DependentRows { rows });
    }
    if stiffness.parts.len() > problem.stiffness.len() {
        notes.push(Note::Parts {
            parts: stiffness.parts.len(),
        });
    }
    let assembly = clock.elapsed().as_secs_f64();

    begin(progress, Stage::Factorization)?;
    let clock = Instant::now();
    let many = problem.many_solves
        || laws
            .iter()
            .any(|law| matches!(law, PairLaw::Coulomb { .. }));
    let engine = choose_engine(settings.engine, layout.unknowns(), many);
    let contact_last = engine.engine != Engine::Factored;
    let patches = patches::patches(
        &stiffness.matrix,
        &b,
        tangents + 1,
        problem.points.as_deref(),
    );
    let Bodies {
        dofs: body_dofs,
        bodies,
        factors,
    } = bodies::factor(
        &stiffness,
        &b,
        layout.weights(),
        &problem.kernel,
        contact_last,
        &mut notes,
    )?;
    let slidings: Vec<_> = laws.iter().map(PairLaw::sliding).collect();
    let immobile = |mobility: &&Mobility| {
        !mobility.normal && mobility.tangents.iter().take(tangents).all(|&moves| !moves)
    };
    let parts = Parts {
        bodies,
        factors,
        layout,
        slidings: &slidings,
        patches,
        engine,
        stiffness_unit: stiffness.unit,
        distance_of_rows: dependent.distance,
        dofs,
        held_pairs: mobility.iter().filter(immobile).count(),
    };
    let times = Times {
        assembly,
        factorization: clock.elapsed().as_secs_f64(),
        ..Times::default()
    };
    let mut system = Prepared::new(parts, times)?;
    system.dual().set_singular(singular);
    progress.problem(system.description());
    Ok(PreparedProblem {
        dofs: body_dofs,
        tangents,
        mobility,
        system,
        notes,
    })
}

fn check_conditions(
    conditions: &Conditions,
    dofs: usize,
    pairs: usize,
    tangents: usize,
) -> Result<(), AlgebraicError> {
    let Conditions {
        load,
        gap,
        friction: _,
        previous_slip,
        start,
    } = conditions;
    let rows = tangents * pairs;
    check::vector("the load f", load, dofs, "dofs of K")?;
    if let Some(gap) = gap {
        check::vector("the gap d", gap, pairs, "one per contact pair")?;
    }
    if let Some(slip) = previous_slip {
        check::vector("the previous slip", slip, rows, "rows of T")?;
    }
    if let Some(start) = start {
        check::vector(
            "the start of the normal forces",
            &start.normal,
            pairs,
            "one per contact pair",
        )?;
        check::vector(
            "the start of the tangential forces",
            &start.tangential,
            rows,
            "rows of T",
        )?;
    }
    Ok(())
}

impl PreparedProblem {
    /// Sizes and engine.
    pub fn description(&self) -> &Description {
        self.system.description()
    }

    /// What the user should know about the input.
    pub fn notes(&self) -> &[Note] {
        &self.notes
    }

    /// The dual problem min ½ λᵀAλ − λᵀb as it stands, in the solver's unknowns.
    pub fn dual(&mut self) -> &mut DualProblem<'static> {
        self.system.dual()
    }

    /// Solves for these loads, gaps, bounds. What was learnt about A in earlier solves is kept.
    ///
    /// # Errors
    /// When a vector or a setting is wrong, the laws are of another kind than those prepared for, or
    /// `progress` stops the run before its first iteration.
    pub fn solve(
        &mut self,
        conditions: &Conditions,
        settings: &Settings,
        progress: &mut dyn Progress,
    ) -> Result<Solution, AlgebraicError> {
        settings.validate()?;
        let case = self.load_case(conditions)?;
        let start = conditions.start.as_ref();
        let start = start.map(|start| self.start(start)).transpose()?;
        let mut times = self.system.times();
        let solved = self
            .system
            .solve(&case, start.as_ref(), settings, &mut times, progress)?;
        Ok(Solution {
            displacement: self.dofs.join(&solved.displacements),
            unresisted_motion: solved.unresisted.as_ref().map(|u| self.dofs.join(u)),
            notes: self.notes.clone(),
            description: Some(self.system.description().clone()),
            ..Solution::new(solved, settings, times)
        })
    }

    fn load_case(&self, conditions: &Conditions) -> Result<LoadCase, AlgebraicError> {
        let layout = self.system.layout();
        let m = layout.pair_count();
        check_conditions(conditions, self.dofs.count(), m, self.tangents)?;
        let laws = conditions.friction.laws(m)?;
        if !check::layout(&laws, &self.mobility, self.tangents)?.same_blocks(layout) {
            return Err(AlgebraicError::LawsChanged);
        }
        let mut origin = vec![0.0; layout.unknowns()];
        if let Some(slip) = &conditions.previous_slip {
            origin[m..].copy_from_slice(slip);
        }
        Ok(LoadCase {
            loads: self.dofs.split(&conditions.load),
            base: vec![0.0; layout.unknowns()],
            gaps: conditions.gap.clone().unwrap_or_else(|| vec![0.0; m]),
            slidings: laws.iter().map(PairLaw::sliding).collect(),
            origin,
            held: 0.0,
        })
    }

    /// The start in the solver's unknowns.
    fn start(&self, start: &Forces) -> Result<WarmStart, AlgebraicError> {
        let amounts = &start.kernel_amounts;
        if !amounts.is_empty() {
            let expected = self.system.description().rigid_motions;
            check::vector(
                "the start of the kernel amounts",
                amounts,
                expected,
                "kernel vectors",
            )?;
        }
        Ok(start.warm(self.system.layout()))
    }
}
