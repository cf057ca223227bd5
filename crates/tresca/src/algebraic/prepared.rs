//! An algebraic problem, checked, factored and posed; solved as often as need be.

use std::ops::ControlFlow;
use std::time::Instant;

use tresca_contact::Mobility;
use tresca_la::vector::dot;
use tresca_qcqp::{DualProblem, Settings, Start, Status};

use super::bodies::{self, Bodies, Body};
use super::parts::Stiffness;
use super::{
    AlgebraicError, Conditions, Forces, Law, Matrix, Note, Problem, Solution, check, patches, rank,
};
use crate::dual::choose_engine;
use crate::elastic::{self, ElasticBody, add_motions, displacements, load_on_motions};
use crate::layout::Layout;
use crate::measures::{ElasticSums, Interface, Pairs, certificate, largest};
use crate::progress::{Progress, Stage};
use crate::solve::Description;
use crate::{Engine, Times};

/// A problem that is checked, factored and posed in its dual form.
pub struct Prepared {
    stiffness: Stiffness,
    b: Matrix,
    tangents: usize,
    mobility: Vec<Mobility>,
    layout: Layout,
    bodies: Bodies,
    dual: DualProblem<'static>,
    description: Description,
    notes: Vec<Note>,
    times: Times,
    /// A stage at which the caller wanted to stop: then nothing is iterated.
    stopped: bool,
}

/// Checks the problem, factors K, poses the dual problem.
///
/// # Errors
/// Everything that is wrong with the input.
pub fn prepare(
    problem: &Problem,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<Prepared, AlgebraicError> {
    settings.validate()?;
    let begin = Instant::now();
    let mut stopped = progress.stage(Stage::Assembly).is_break();
    let mut notes = Vec::new();
    let stiffness = Stiffness::new(&problem.stiffness, &mut notes)?;
    let dofs = stiffness.matrix.rows();
    let m = problem.normal.rows();
    let (b, tangents) = check::contact_rows(&problem.normal, problem.tangential.as_ref(), dofs)?;
    check_conditions(&problem.conditions, dofs, m, tangents)?;
    let laws = problem.conditions.friction.laws(m)?;
    let mobility = check::mobility(&b, m, tangents, &mut notes)?;
    let layout = check::layout(&laws, &mobility, tangents)?;
    check::note_ignored_figures(&laws, tangents, &mut notes);
    if let Some(points) = &problem.points {
        check::vector(
            "the points of the pairs",
            points.as_flattened(),
            3 * m,
            "three per contact pair",
        )?;
    }
    let dependent = rank::dependent_rows(&b);
    if !dependent.is_empty() {
        let rows = dependent
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
    let assembly = begin.elapsed().as_secs_f64();

    stopped |= progress.stage(Stage::Factorization).is_break();
    let begin = Instant::now();
    let many = problem.many_solves || laws.iter().any(|law| matches!(law, Law::Coulomb { .. }));
    let engine = choose_engine(settings.engine, layout.unknowns(), many);
    let contact_last = engine.engine != Engine::Factored;
    let weights = layout.weights();
    let bodies = bodies::factor(
        &stiffness,
        &b,
        weights,
        &problem.kernel,
        contact_last,
        &mut notes,
    )?;
    let slidings: Vec<_> = laws.iter().map(Law::sliding).collect();
    let groups = patches::patches(
        &stiffness.matrix,
        &b,
        tangents + 1,
        problem.points.as_deref(),
    );
    let dual = elastic::dual_problem(
        &bodies.elastic(),
        &bodies.factored,
        &layout,
        &slidings,
        groups,
        engine.engine,
    )?;
    let immobile = |mobility: &&Mobility| {
        !mobility.normal && mobility.tangents.iter().take(tangents).all(|&moves| !moves)
    };
    let description = Description {
        dofs,
        bodies: bodies.bodies.len(),
        pairs: m,
        held_pairs: mobility.iter().filter(immobile).count(),
        rigid_motions: bodies.bodies.iter().map(Body::motions).sum(),
        engine,
        factorization: bodies.factored.work,
    };
    progress.problem(&description);
    Ok(Prepared {
        stiffness,
        b,
        tangents,
        mobility,
        layout,
        bodies,
        dual,
        description,
        notes,
        times: Times {
            assembly,
            factorization: begin.elapsed().as_secs_f64(),
            ..Times::default()
        },
        stopped,
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

impl Bodies {
    fn elastic(&self) -> Vec<ElasticBody<'_>> {
        self.bodies.iter().map(Body::elastic).collect()
    }

    fn restrict(&self, values: &[f64]) -> Vec<Vec<f64>> {
        self.bodies
            .iter()
            .map(|body| body.restrict(values))
            .collect()
    }

    fn join(&self, parts: &[Vec<f64>], dofs: usize) -> Vec<f64> {
        let mut all = vec![0.0; dofs];
        for (body, part) in self.bodies.iter().zip(parts) {
            body.write(part, &mut all);
        }
        all
    }
}

/// μ and the multiplier α: a start in the solver's unknowns.
type Unknowns = (Vec<f64>, Vec<f64>);

/// The dual problem of a solve, and what its outcome is measured with.
struct Posed {
    gap: Vec<f64>,
    /// \[0; previous slip\].
    shift: Vec<f64>,
    slidings: Vec<tresca_contact::Sliding>,
    loads: Vec<Vec<f64>>,
    /// fᵀK⁺f.
    load_energy: f64,
}

impl Prepared {
    /// Sizes and engine.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// What the user should know about the input.
    pub fn notes(&self) -> &[Note] {
        &self.notes
    }

    /// The dual problem min ½ λᵀAλ − λᵀb as it stands, in the solver's unknowns.
    pub fn dual(&mut self) -> &mut DualProblem<'static> {
        &mut self.dual
    }

    /// Solves for these loads, gaps, bounds. What was learnt about A in earlier solves is kept.
    ///
    /// # Errors
    /// When a vector or a setting is wrong, or the laws are of another kind than those prepared for.
    pub fn solve(
        &mut self,
        conditions: &Conditions,
        settings: &Settings,
        progress: &mut dyn Progress,
    ) -> Result<Solution, AlgebraicError> {
        settings.validate()?;
        let begin = Instant::now();
        let mut times = self.times;
        let posed = self.pose(conditions)?;
        let start = self.start(conditions.start.as_ref())?;
        times.recovery += begin.elapsed().as_secs_f64();

        let mut stopped = self.stopped | progress.stage(Stage::Solve).is_break();
        let begin = Instant::now();
        let mut observer = |record: &tresca_qcqp::IterationRecord| {
            let flow = progress.iteration(record);
            if std::mem::take(&mut stopped) {
                ControlFlow::Break(())
            } else {
                flow
            }
        };
        let start = start
            .as_ref()
            .map(|(lambda, multiplier)| Start { lambda, multiplier });
        let solution = tresca_qcqp::solve(&mut self.dual, settings, start, &mut observer)?;
        times.solve = begin.elapsed().as_secs_f64();
        times.multiplications = solution.seconds_in_products;

        let _ = progress.stage(Stage::Recovery);
        let begin = Instant::now();
        let mut outcome = self.recover(settings, &posed, solution);
        times.recovery += begin.elapsed().as_secs_f64();
        outcome.times = times;
        Ok(outcome)
    }

    /// b = B K⁺f − \[d; previous slip\], e = Rᵀf and the slip bounds.
    fn pose(&mut self, conditions: &Conditions) -> Result<Posed, AlgebraicError> {
        let (m, dofs) = (self.layout.pair_count(), self.stiffness.matrix.rows());
        check_conditions(conditions, dofs, m, self.tangents)?;
        let laws = conditions.friction.laws(m)?;
        if check::layout(&laws, &self.mobility, self.tangents)? != self.layout {
            return Err(AlgebraicError::LawsChanged);
        }
        let slidings: Vec<_> = laws.iter().map(Law::sliding).collect();
        let gap = conditions.gap.clone().unwrap_or_else(|| vec![0.0; m]);
        let mut shift = vec![0.0; self.layout.unknowns()];
        if let Some(slip) = &conditions.previous_slip {
            shift[m..].copy_from_slice(slip);
        }
        let loads = self.bodies.restrict(&conditions.load);
        let bodies = self.bodies.elastic();
        let nothing = vec![0.0; self.layout.unknowns()];
        let free = displacements(&bodies, &self.bodies.factored, &loads, &nothing);
        let load_energy = loads.iter().zip(&free).map(|(f, u)| dot(f, u)).sum();
        let mut rhs: Vec<f64> = shift.iter().map(|s| -s).collect();
        self.b.add_product(&self.bodies.join(&free, dofs), &mut rhs);
        rhs.iter_mut().zip(&gap).for_each(|(b, d)| *b -= d);
        // No force acts along a row that is zero; its gap must not count as a residual.
        for (i, mobility) in self.mobility.iter().enumerate() {
            if !mobility.normal {
                rhs[i] = 0.0;
            }
            for t in (0..self.tangents).filter(|&t| !mobility.tangents[t]) {
                rhs[m + self.tangents * i + t] = 0.0;
            }
        }
        let e = load_on_motions(&bodies, &loads);
        self.dual.set_rhs(self.layout.dual(&rhs))?;
        let mut set = self.layout.set(&slidings)?;
        if let Some(start) = &conditions.start {
            // The first guess of the Coulomb bounds.
            for bound in self.layout.coulomb(&slidings) {
                let guess =
                    (bound.coefficient * start.normal[bound.normal].max(0.0)).min(bound.limit);
                set.set_bound(bound.block, guess)?;
            }
        }
        self.dual.set_set(set)?;
        self.dual.set_coulomb(self.layout.coulomb(&slidings))?;
        self.dual.set_equality_rhs(&e)?;
        Ok(Posed {
            gap,
            shift,
            slidings,
            loads,
            load_energy,
        })
    }

    /// The start in the solver's unknowns.
    fn start(&self, start: Option<&Forces>) -> Result<Option<Unknowns>, AlgebraicError> {
        let Some(start) = start else { return Ok(None) };
        let amounts = &start.kernel_amounts;
        if !amounts.is_empty() {
            let expected = self.description.rigid_motions;
            check::vector(
                "the start of the kernel amounts",
                amounts,
                expected,
                "kernel vectors",
            )?;
        }
        let forces = [&start.normal[..], &start.tangential].concat();
        Ok(Some((self.layout.unknowns_of(&forces), amounts.clone())))
    }

    fn recover(
        &self,
        settings: &Settings,
        posed: &Posed,
        solution: tresca_qcqp::Solution,
    ) -> Solution {
        let (m, dofs) = (self.layout.pair_count(), self.stiffness.matrix.rows());
        let bodies = self.bodies.elastic();
        let no_equilibrium = solution.status == Status::NoEquilibrium;
        let parts = if no_equilibrium {
            // There is no displacement.
            posed
                .loads
                .iter()
                .map(|load| vec![0.0; load.len()])
                .collect()
        } else {
            let mut parts = displacements(
                &bodies,
                &self.bodies.factored,
                &posed.loads,
                &solution.lambda,
            );
            add_motions(&bodies, &solution.multiplier, &mut parts);
            parts
        };
        let u = self.bodies.join(&parts, dofs);
        let lambda = self.layout.forces(&solution.lambda);
        let mut relative = vec![0.0; self.layout.unknowns()];
        self.b.add_product(&u, &mut relative);

        let mut elastic = ElasticSums::default();
        let minus: Vec<f64> = solution.lambda.iter().map(|x| -x).collect();
        for ((body, u), f) in bodies.iter().zip(&parts).zip(&posed.loads) {
            let mut contact = vec![0.0; u.len()];
            body.coupling.add_transposed_product(&minus, &mut contact);
            let mut internal = vec![0.0; u.len()];
            body.stiffness.mul(u, &mut internal);
            elastic.add(u, f, &contact, &internal, &body.stiffness.diagonal());
        }
        let increment: Vec<f64> = relative
            .iter()
            .zip(&posed.shift)
            .map(|(r, s)| r - s)
            .collect();
        let interface = Interface::new(&Pairs {
            layout: &self.layout,
            gaps: &posed.gap,
            slidings: &posed.slidings,
            lambda: &lambda,
            relative: &increment,
            previous: &vec![0.0; increment.len()],
        });
        let length = largest(&u).max(largest(&posed.gap));
        let dual = -solution.objective - 0.5 * posed.load_energy;
        let certificate = certificate(&elastic.total(), &interface, length, dual);

        let unresisted_motion = solution
            .motion
            .as_ref()
            .filter(|_| no_equilibrium)
            .map(|v| {
                let mut parts: Vec<_> = posed
                    .loads
                    .iter()
                    .map(|load| vec![0.0; load.len()])
                    .collect();
                add_motions(&bodies, v, &mut parts);
                let mut motion = self.bodies.join(&parts, dofs);
                let size = largest(&motion).max(f64::MIN_POSITIVE);
                motion.iter_mut().for_each(|x| *x /= size);
                motion
            });
        let states: Vec<_> = (0..m)
            .map(|i| self.layout.state(&solution.active_set, i))
            .collect();
        let bounds = posed.slidings.iter().zip(&lambda);
        Solution {
            status: solution.status,
            displacement: u,
            normal_force: lambda[..m].to_vec(),
            tangential_force: lambda[m..].to_vec(),
            closed: states.iter().map(|state| state.0).collect(),
            stick: states.iter().map(|state| state.1).collect(),
            gap: posed
                .gap
                .iter()
                .zip(&relative)
                .map(|(d, r)| d - r)
                .collect(),
            slip: relative[m..].to_vec(),
            slip_bounds: bounds.map(|(law, &normal)| law.bounds(normal)).collect(),
            certificate,
            relative_reduced_gradient: solution.relative_reduced_gradient,
            dual_objective: solution.objective,
            equality_residual: solution.equality_residual,
            outer_iterations: solution.outer_iterations,
            outer_residual: solution.outer_residual,
            iterations: solution.iterations,
            records: solution.records,
            n_a: solution.n_a,
            n_a_setup: solution.n_a_setup,
            sigma_max: solution.sigma_max,
            kernel_amounts: solution.multiplier,
            unresisted_motion,
            notes: self.notes.clone(),
            description: Some(self.description.clone()),
            settings: settings.clone(),
            times: Times::default(),
        }
    }
}
