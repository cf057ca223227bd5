//! Bodies that are factored and posed as a dual problem, solved as often as need be.

use std::time::Instant;

use rayon::prelude::*;
use tresca_contact::Sliding;
use tresca_la::vector::dot;
use tresca_qcqp::{DualProblem, DualSolution, QcqpError, Settings, Status};

use crate::body::{SystemBody, add_motions, at_rest, load_on_motions};
use crate::contradiction::Contradiction;
use crate::description::{Description, EngineChoice, Times};
use crate::engine::dual_problem;
use crate::factors::Factors;
use crate::layout::Layout;
use crate::load_case::{self, LoadCase, WarmStart};
use crate::measures::{ElasticSums, largest};
use crate::progress::Progress;
use crate::run::{self, Unsolved};
use crate::solved::{Measured, Solved};
use crate::units::Units;

/// A system of bodies whose contact is posed as a dual problem.
pub struct Prepared {
    bodies: Vec<SystemBody>,
    factors: Factors,
    layout: Layout,
    dual: DualProblem<'static>,
    description: Description,
    times: Times,
    /// What K is measured in.
    stiffness_unit: f64,
}

/// What a system is prepared from.
pub struct Parts<'a> {
    /// The bodies, their coupling weighted by the layout.
    pub bodies: Vec<SystemBody>,
    /// Their factors.
    pub factors: Factors,
    /// Where the pairs stand.
    pub layout: Layout,
    /// Their laws; figures may change from solve to solve.
    pub slidings: &'a [Sliding],
    /// Unknowns of neighbouring pairs: the patches of the local model of A.
    pub patches: Vec<Vec<usize>>,
    /// The unit of the stiffness that the bodies come in, a power of two.
    pub stiffness_unit: f64,
    /// How A is applied.
    pub engine: EngineChoice,
    /// Free and held dofs.
    pub dofs: usize,
    /// Pairs that are left out or that nothing can move.
    pub held_pairs: usize,
}

impl Prepared {
    /// Poses the dual problem; `times` are those of assembly and factorisation.
    ///
    /// # Errors
    /// When the dual problem is refused.
    pub fn new(parts: Parts<'_>, times: Times) -> Result<Self, QcqpError> {
        let begin = Instant::now();
        let dual = dual_problem(
            &parts.bodies,
            &parts.factors,
            &parts.layout,
            parts.slidings,
            parts.patches,
            parts.engine.engine,
        )?;
        let description = Description {
            dofs: parts.dofs,
            bodies: parts.bodies.len(),
            pairs: parts.layout.pair_count(),
            held_pairs: parts.held_pairs,
            rigid_motions: parts.bodies.iter().map(|body| body.motions().len()).sum(),
            engine: parts.engine,
            factorization: parts.factors.work,
        };
        Ok(Self {
            bodies: parts.bodies,
            factors: parts.factors,
            layout: parts.layout,
            dual,
            description,
            stiffness_unit: parts.stiffness_unit,
            times: Times {
                factorization: times.factorization + begin.elapsed().as_secs_f64(),
                ..times
            },
        })
    }

    /// Sizes and engine.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// Seconds spent on assembly and factorisation.
    pub fn times(&self) -> Times {
        self.times
    }

    /// The bodies.
    pub fn bodies(&self) -> &[SystemBody] {
        &self.bodies
    }

    /// The bodies alone; factors and dual problem go.
    pub fn into_bodies(self) -> Vec<SystemBody> {
        self.bodies
    }

    /// Where the pairs stand.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The dual problem min ½ μᵀAμ − μᵀb as it stands.
    pub fn dual(&mut self) -> &mut DualProblem<'static> {
        &mut self.dual
    }

    /// Solves under a load case. What was learnt about A in earlier solves is kept. `times` gets what it
    /// took.
    ///
    /// # Errors
    /// When a setting or a bound is impossible, or the caller stops the run before its first iteration.
    pub fn solve(
        &mut self,
        case: &LoadCase,
        start: Option<&WarmStart>,
        settings: &Settings,
        times: &mut Times,
        progress: &mut dyn Progress,
    ) -> Result<Solved, Unsolved> {
        let units = Units::of(case, self.stiffness_unit);
        let Some(own) = units.enter(case) else {
            return self.solve_as_is(case, start, settings, times, progress);
        };
        let start = start.map(|start| units.enter_start(start));
        let mut solved = self.solve_as_is(&own, start.as_ref(), settings, times, progress)?;
        units.leave(&mut solved, &case.slidings);
        Ok(solved)
    }

    /// The same with numbers as they are.
    fn solve_as_is(
        &mut self,
        case: &LoadCase,
        start: Option<&WarmStart>,
        settings: &Settings,
        times: &mut Times,
        progress: &mut dyn Progress,
    ) -> Result<Solved, Unsolved> {
        let begin = Instant::now();
        let mu = start.map(|start| start.scaled(&self.layout, &case.slidings));
        // What the caller brings is taken at its word. Slip bounds of the load case before save a quarter of the
        // multiplications of load cycles; where bodies float, they mislead: the bolt of the gallery's lap joint takes
        // half as many again.
        let holds =
            |start: &WarmStart| start.slidings.is_none() || self.description.rigid_motions == 0;
        let guess = mu.as_deref().filter(|_| start.is_some_and(holds));
        let load_energy = self.pose(case, guess)?;
        times.recovery += begin.elapsed().as_secs_f64();
        let start = mu.as_deref().zip(start);
        let start = start.map(|(lambda, start)| tresca_qcqp::Start {
            lambda,
            multiplier: &start.multiplier,
        });
        let solution = run::solve(&mut self.dual, start, settings, times, progress)?;
        let begin = Instant::now();
        let solved = self.recover(case, solution, load_energy);
        times.recovery += begin.elapsed().as_secs_f64();
        Ok(solved)
    }

    /// B u of displacements over the free dofs, body by body, where `base` is B u without them.
    fn relative(&self, displacements: &[Vec<f64>], base: &[f64]) -> Vec<f64> {
        let mut weighted = vec![0.0; self.layout.unknowns()];
        for (body, u) in self.bodies.iter().zip(displacements) {
            body.coupling.add_product(u, &mut weighted);
        }
        let weights = self.layout.weights().iter();
        let rows = weighted.iter().zip(weights).zip(base);
        rows.map(|((x, w), base)| x / w + base).collect()
    }

    /// Poses the dual problem: b = B u⁰ − c with u⁰ the displacement without contact (and obstacles where they
    /// are in the step), c = \[d; where slip is counted from\], e = Rᵀf, and the slip bounds, which begin at those of
    /// the forces `guess`. Returns fᵀK⁺f.
    fn pose(&mut self, case: &LoadCase, guess: Option<&[f64]>) -> Result<f64, QcqpError> {
        let layout = &self.layout;
        let nothing = vec![0.0; layout.unknowns()];
        let loads = &case.loads;
        let free = self.factors.displacements(&self.bodies, loads, &nothing);
        let energy = loads.iter().zip(&free).map(|(f, u)| dot(f, u)).sum();
        let mut b = self.relative(&free, &case.base);
        b.iter_mut().zip(&case.gaps).for_each(|(b, d)| *b -= d);
        b.iter_mut()
            .zip(&case.origin)
            .for_each(|(b, origin)| *b -= origin);
        // No force acts where supports let nothing move; such a gap must not count as a residual.
        layout.immobile().for_each(|i| b[i] = 0.0);
        let coulomb = layout.coulomb(&case.slidings);
        let set = load_case::set(layout, &case.slidings, &coulomb, guess)?;
        self.dual.set_rhs(layout.dual(&b))?;
        self.dual.set_set(set)?;
        self.dual.set_coulomb(coulomb)?;
        self.dual
            .set_equality_rhs(&load_on_motions(&self.bodies, loads))?;
        Ok(energy)
    }

    fn recover(&self, case: &LoadCase, mut solution: DualSolution, load_energy: f64) -> Solved {
        let proof = solution.contradiction.as_deref();
        let contradiction =
            proof.and_then(|mu| Contradiction::confirmed(&self.layout, &self.bodies, case, mu));
        if solution.status == Status::Infeasible && contradiction.is_none() {
            // The rows only nearly depend on each other.
            solution.status = Status::Inaccurate;
            solution.contradiction = None;
        }
        let nowhere = matches!(solution.status, Status::NoEquilibrium | Status::Infeasible);
        let displacements = if nowhere {
            // There is no displacement; the supports alone are where they should be.
            at_rest(&self.bodies)
        } else {
            let (loads, mu) = (&case.loads, &solution.lambda);
            let mut free = self.factors.displacements(&self.bodies, loads, mu);
            add_motions(&self.bodies, &solution.multiplier, &mut free);
            free
        };
        let relative = self.relative(&displacements, &case.base);
        let minus: Vec<f64> = solution.lambda.iter().map(|x| -x).collect();
        let sums = self.bodies.par_iter().enumerate().map(|(k, body)| {
            let u = &displacements[k];
            let mut contact = vec![0.0; u.len()];
            body.coupling.add_transposed_product(&minus, &mut contact);
            let mut internal = vec![0.0; u.len()];
            body.stiffness.mul(u, &mut internal);
            let diagonal = body.stiffness.diagonal();
            let mut sums = ElasticSums::default();
            sums.add(u, &case.loads[k], &contact, &internal, &diagonal);
            sums
        });
        // In order: sums do not depend on the number of threads.
        let sums: Vec<ElasticSums> = sums.collect();
        let unresisted = solution.motion.as_ref().map(|v| {
            let mut motion = at_rest(&self.bodies);
            add_motions(&self.bodies, v, &mut motion);
            let size = motion.iter().map(|u| largest(u)).fold(0.0, f64::max);
            let size = size.max(f64::MIN_POSITIVE);
            motion.iter_mut().flatten().for_each(|x| *x /= size);
            motion
        });
        let sizes = displacements.iter().map(|u| largest(u));
        let measured = Measured {
            length: sizes.fold(case.held.max(self.layout.largest_gap(&case.gaps)), f64::max),
            dual_energy: Some(-solution.figures.objective - 0.5 * load_energy),
            elastic: ElasticSums::total(&sums),
            displacements,
            relative,
            unresisted,
            contradiction,
        };
        Solved::new(
            &self.layout,
            &case.gaps,
            &case.slidings,
            &case.origin,
            solution,
            measured,
        )
    }
}
