//! Bodies that are factored and posed as a dual problem, solved as often as need be.

use std::time::Instant;

use rayon::prelude::*;
use tresca_contact::Sliding;
use tresca_la::vector::{axpy, dot, norm};
use tresca_qcqp::{DualProblem, DualSolution, QcqpError, Settings, Status};

use crate::body::{SystemBody, add_motions, at_rest, load_on_motions};
use crate::contradiction::Contradiction;
use crate::description::{Description, EngineChoice, Times};
use crate::engine::dual_problem;
use crate::factors::Factors;
use crate::judge;
use crate::layout::Layout;
use crate::load_case::{self, LoadCase, WarmStart};
use crate::measures::{BodyState, ElasticSums, largest};
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
    /// As in [`Parts`].
    distance_of_rows: f64,
}

/// What the loads would do without contact: u⁰ = K⁺f.
#[derive(Clone, Copy)]
struct Free {
    /// fᵀK⁺f.
    energy: f64,
    /// The largest component of u⁰.
    length: f64,
}

/// The part of the forces that may be missing from equilibrium before a displacement is refined.
const LOST: f64 = 1e-12;

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
    /// The smallest distance of a row of B, at length 1, from the span of the others: rounding aside, rows that
    /// depend on each other do not count.
    pub distance_of_rows: f64,
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
            distance_of_rows: parts.distance_of_rows,
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
        let free = self.pose(case, guess)?;
        times.recovery += begin.elapsed().as_secs_f64();
        let start = mu.as_deref().zip(start);
        let start = start.map(|(lambda, start)| tresca_qcqp::Start {
            lambda,
            multiplier: &start.multiplier,
        });
        let solution = run::solve(&mut self.dual, start, settings, times, progress)?;
        let solved = self.timed_recovery(case, solution, free, times);
        judge::judge(solved, settings, self.distance_of_rows, |finer, last| {
            let from = last.start();
            let start = tresca_qcqp::Start {
                lambda: &from.mu,
                multiplier: &from.multiplier,
            };
            let solution = run::solve(&mut self.dual, Some(start), finer, times, progress)?;
            Ok(self.timed_recovery(case, solution, free, times))
        })
    }

    fn timed_recovery(
        &self,
        case: &LoadCase,
        solution: DualSolution,
        free: Free,
        times: &mut Times,
    ) -> Solved {
        let begin = Instant::now();
        let solved = self.recover(case, solution, free);
        times.recovery += begin.elapsed().as_secs_f64();
        solved
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
    /// the forces `guess`. Returns what the loads would do without contact.
    fn pose(&mut self, case: &LoadCase, guess: Option<&[f64]>) -> Result<Free, QcqpError> {
        let layout = &self.layout;
        let nothing = vec![0.0; layout.unknowns()];
        let loads = &case.loads;
        let free = self.factors.displacements(&self.bodies, loads, &nothing);
        let without_contact = Free {
            energy: loads.iter().zip(&free).map(|(f, u)| dot(f, u)).sum(),
            length: free.iter().map(|u| largest(u)).fold(0.0, f64::max),
        };
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
        Ok(without_contact)
    }

    /// −Bᵀλ of each body.
    fn contact_forces(&self, mu: &[f64]) -> Vec<Vec<f64>> {
        let minus: Vec<f64> = mu.iter().map(|x| -x).collect();
        let of_body = |body: &SystemBody| {
            let mut contact = vec![0.0; body.dofs()];
            body.coupling.add_transposed_product(&minus, &mut contact);
            contact
        };
        self.bodies.par_iter().map(of_body).collect()
    }

    /// v = K⁺(f − Bᵀλ), with one step of iterative refinement where the factor has lost digits, and −Bᵀλ.
    fn strained(&self, loads: &[Vec<f64>], mu: &[f64]) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let contact = self.contact_forces(mu);
        let bodies = self.bodies.par_iter().zip(&self.factors.bodies);
        let solved = bodies.zip(loads).zip(&contact);
        let v = solved.map(|(((body, factor), load), contact)| {
            let forces: Vec<f64> = load.iter().zip(contact).map(|(f, c)| f + c).collect();
            let mut v = forces.clone();
            factor.solve_in_place(&mut v);
            let mut missing = vec![0.0; v.len()];
            body.stiffness.mul(&v, &mut missing);
            if let Some(grounding) = &body.grounding {
                grounding.add_product(&v, &mut missing);
            }
            let terms = missing.iter_mut().zip(&forces);
            terms.for_each(|(x, f)| *x = f - *x);
            if norm(&missing) > LOST * norm(load).max(norm(contact)) {
                factor.solve_in_place(&mut missing);
                axpy(1.0, &missing, &mut v);
            }
            v
        });
        (v.collect(), contact)
    }

    fn recover(&self, case: &LoadCase, mut solution: DualSolution, free: Free) -> Solved {
        let proof = solution.contradiction.as_deref();
        let contradiction =
            proof.and_then(|mu| Contradiction::confirmed(&self.layout, &self.bodies, case, mu));
        if solution.status == Status::Infeasible && contradiction.is_none() {
            // The rows only nearly depend on each other.
            solution.status = Status::Inaccurate;
            solution.contradiction = None;
        }
        let nowhere = matches!(solution.status, Status::NoEquilibrium | Status::Infeasible);
        let (mut displacements, contact) = if nowhere {
            // There is no displacement; the supports alone are where they should be.
            (at_rest(&self.bodies), self.contact_forces(&solution.lambda))
        } else {
            self.strained(&case.loads, &solution.lambda)
        };
        let strained = displacements.clone();
        if !nowhere {
            add_motions(&self.bodies, &solution.multiplier, &mut displacements);
        }
        let relative = self.relative(&displacements, &case.base);
        let sums = self.bodies.par_iter().enumerate().map(|(k, body)| {
            let mut internal = vec![0.0; body.dofs()];
            body.stiffness.mul(&strained[k], &mut internal);
            ElasticSums::new(&BodyState {
                displacement: &displacements[k],
                strained: &strained[k],
                load: &case.loads[k],
                contact: &contact[k],
                internal: &internal,
            })
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
            moved: sizes.fold(case.held, f64::max),
            free: free.length.max(self.layout.largest_gap(&case.gaps)),
            dual_energy: Some(-solution.figures.objective - 0.5 * free.energy),
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
