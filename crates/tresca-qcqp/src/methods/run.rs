//! What every method needs: the problem, the one measure, the records, the verdict.

use crate::active_set::ActiveSet;
use crate::inner_problem::{Ending, Inner, Journal};
use crate::observe::Observer;
use crate::operator::dual_operator::DualOperator;
use crate::point::{
    Point, change_rounding, gradient_step, objective, objective_rounding, point_at,
    reduced_gradient, relative,
};
use crate::record::IterationRecord;
use crate::sets::convex_set::{BlockState, ConvexSet};
use crate::sets::product::ProductSet;
use crate::settings::{CoulombMethod, Method, Settings};
use crate::status::Status;
use tresca_la::vector::norm;

/// Iterations without progress after which bounds that follow every Newton step are given up for the fixed
/// point. Where the loop does well it needs about this many in all.
const PATIENCE_IN_LOOP: usize = 6;
/// Part of the reference that rounding in a product may be.
const DROWNED: f64 = 1e-6;

/// How an iterate was reached.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Advance {
    pub inner_iterations: usize,
    pub length: f64,
}

impl Advance {
    /// The step that leads to the start: none.
    pub const START: Advance = Advance {
        inner_iterations: 0,
        length: 0.0,
    };

    /// A full step after so many inner iterations.
    pub fn full(inner_iterations: usize) -> Self {
        Self {
            inner_iterations,
            length: 1.0,
        }
    }
}

/// A feasible point with all that is recorded about it.
#[derive(Clone, Debug)]
struct Judged {
    point: Point,
    active: ActiveSet,
    relative: f64,
    objective: f64,
    bounds_change: f64,
    /// The bounds of Coulomb's law under which λ was computed; none where they are frozen.
    bounds: Vec<f64>,
    /// What the run makes small: of several points the one with the smallest figure is the best.
    figure: f64,
}

/// One run of one method on one inner problem.
pub(crate) struct Run<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub rhs: &'a [f64],
    pub set: ProductSet,
    pub settings: &'a Settings,
    /// Steps of all inner problems together after which this run ends.
    pub most_steps: usize,
    /// On the relative reduced gradient of this inner problem.
    pub tolerance: f64,
    /// Upper estimate of σmax.
    pub sigma: f64,
    /// The method's own ρ.
    pub rho: f64,
    /// ‖r̃(0)‖, the scale of every residual.
    pub reference: f64,
    /// ‖r̃(λ)‖/‖r̃(0)‖ of the point judged last.
    pub relative: f64,
    inner: Inner<'a>,
    observer: &'a mut dyn Observer,
    journal: &'a mut Journal,
    /// Iterations of this run, its start included.
    iterations: usize,
    last: Option<Judged>,
    best: Option<Judged>,
    lowest_objective: f64,
    last_progress: usize,
}

impl<'a> Run<'a> {
    pub fn new(
        operator: &'a mut dyn DualOperator,
        inner: &Inner<'a>,
        settings: &'a Settings,
        sigma: f64,
        journal: &'a mut Journal,
        observer: &'a mut dyn Observer,
    ) -> Self {
        journal.problems += 1;
        let mut run = Self {
            operator,
            rhs: inner.rhs,
            set: inner.set.clone(),
            settings,
            most_steps: settings.max_iterations,
            tolerance: inner.tolerance,
            sigma,
            rho: settings.rho / sigma,
            reference: 0.0,
            relative: f64::INFINITY,
            inner: *inner,
            observer,
            journal,
            iterations: 0,
            last: None,
            best: None,
            lowest_objective: f64::INFINITY,
            last_progress: 0,
        };
        run.reference = run.reference_of_set();
        run
    }

    /// ‖r̃(0)‖ for the present Λ, without the multiplier's share of b.
    fn reference_of_set(&self) -> f64 {
        reference(&self.inner, &self.set, self.sigma)
    }

    /// The start, projected; 0 if none is given, which costs no multiplication.
    pub fn start(&mut self, start: Option<&[f64]>) -> Point {
        let mut lambda = start.map_or_else(|| vec![0.0; self.rhs.len()], <[f64]>::to_vec);
        self.set.project(&mut lambda);
        self.point(lambda)
    }

    /// The point at λ: one multiplication, none for λ = 0.
    pub fn point(&mut self, lambda: Vec<f64>) -> Point {
        point_at(self.operator, self.rhs, lambda)
    }

    /// The point at λ, where `known` may be that very point.
    pub fn point_unless(&mut self, lambda: Vec<f64>, known: &Point) -> Point {
        if lambda == known.lambda {
            known.clone()
        } else {
            self.point(lambda)
        }
    }

    /// P_Λ of the point; the point itself, for no multiplication, when it is feasible up to rounding.
    pub fn projected(&mut self, point: &Point) -> Point {
        if self.set.contains(&point.lambda) {
            return point.clone();
        }
        let mut lambda = point.lambda.clone();
        self.set.project(&mut lambda);
        self.point(lambda)
    }

    /// y = λ − ρ r(λ) with the method's ρ.
    pub fn y(&self, point: &Point) -> Vec<f64> {
        gradient_step(point, self.rho)
    }

    /// ‖r̃_ρ(λ)‖ with the method's own ρ, at a λ that need not be feasible.
    pub fn reduced_gradient_norm(&self, point: &Point) -> f64 {
        reduced_gradient(&self.set, point, self.rho).0
    }

    /// λ with the bound blocks replaced by their projection: 0 where open, the bound where slipping.
    pub fn with_bound_blocks_fixed(
        &self,
        lambda: &[f64],
        active: &ActiveSet,
        y: &[f64],
    ) -> Vec<f64> {
        let mut x = lambda.to_vec();
        for (block, state) in self.set.blocks().iter().zip(active.states()) {
            if *state == BlockState::Bound {
                let range = block.range();
                x[range.clone()].copy_from_slice(&y[range.clone()]);
                block.set.project(&mut x[range]);
            }
        }
        x
    }

    /// Whether the bounds follow the normal forces inside of this run.
    pub fn follows_coulomb(&self) -> bool {
        self.inner.law.is_some()
    }

    /// Coulomb's law in the loop: Λ gets the bounds that belong to the normal forces of λ, and the
    /// reduced gradient is measured anew. Nothing happens in a run with frozen bounds.
    pub fn follow_coulomb(&mut self, lambda: &Point) {
        let Some(law) = self.inner.law else {
            return;
        };
        law.bound(&mut self.set, &law.bounds(&lambda.lambda));
        let reference = self.reference_of_set();
        if reference > 0.0 {
            self.reference = reference;
        }
        let (norm, _) = reduced_gradient(&self.set, lambda, 1.0 / self.sigma);
        self.relative = relative(norm, self.reference);
    }

    /// The residual (absolute) that "solved to full accuracy" means.
    pub fn full_accuracy(&self) -> f64 {
        let relative = self.settings.inner_tolerance * self.tolerance;
        // Below this the product with A is not to be trusted.
        let floor = 4.0 * self.operator.accuracy() * norm(self.rhs);
        (relative * self.reference).max(floor)
    }

    /// What a computed change of q from `lambda` to `trial` may be wrong by.
    pub fn rounding(&self, lambda: &Point, trial: &Point) -> f64 {
        change_rounding(lambda, trial, self.rhs, self.operator.accuracy())
    }

    /// Records the feasible `point`, tells the observer, and says whether the run is over.
    pub fn judge(&mut self, point: &Point, step: Advance) -> Option<Status> {
        let (norm, active) = reduced_gradient(&self.set, point, 1.0 / self.sigma);
        let relative = relative(norm, self.reference);
        let objective = objective(point, self.rhs);
        if !relative.is_finite() || !objective.is_finite() {
            return Some(Status::Diverged);
        }
        self.relative = relative;
        let bounds_change = self
            .inner
            .law
            .map_or(0.0, |law| law.change(&self.set, &point.lambda));
        // Both in units of what is asked for, so that one figure tells which point is the better one.
        let figure = match self.inner.law {
            None => relative,
            Some(_) => f64::max(relative / self.tolerance, bounds_change / self.settled()),
        };
        let judged = Judged {
            point: point.clone(),
            active,
            relative,
            objective,
            bounds_change,
            bounds: self
                .inner
                .law
                .map_or_else(Vec::new, |law| law.present(&self.set)),
            figure,
        };
        let record = self.record(&judged, step);
        self.note_progress(&judged, self.iterations);
        let stop = self.observer.iteration(&record).is_break();
        self.journal.stop |= stop;
        self.journal.records.push(record);
        self.last = Some(judged);
        let iteration = self.iterations;
        self.iterations += 1;

        if relative <= self.tolerance && bounds_change <= self.settled() {
            // A λ so long that its product is rounding solves nothing.
            if drowned(&*self.operator, self.sigma, point, self.reference) {
                Some(Status::Diverged)
            } else {
                Some(Status::Converged)
            }
        } else if stop {
            Some(Status::Interrupted)
        } else if iteration - self.last_progress >= self.patience() {
            Some(Status::Stagnated)
        } else if self.journal.steps() >= self.most_steps {
            Some(Status::IterationLimit)
        } else {
            None
        }
    }

    /// The change of bounds in the loop that counts as none. In a problem that is not yet solved to
    /// the end, because its multiplier is not known, the bounds need no more than the rest.
    fn settled(&self) -> f64 {
        let asked = self.settings.coulomb_tolerance;
        if self.tolerance > self.settings.tolerance {
            asked.max(self.tolerance)
        } else {
            asked
        }
    }

    fn record(&mut self, judged: &Judged, step: Advance) -> IterationRecord {
        let last = self.last.as_ref();
        IterationRecord {
            iteration: self.journal.records.len(),
            outer: self.journal.problems - 1,
            relative_reduced_gradient: judged.relative,
            objective: judged.objective,
            decrease: last.map_or(0.0, |last| -judged.point.objective_change_from(&last.point)),
            counts: judged.active.counts(),
            set_changes: last.map_or(0, |last| judged.active.changes(&last.active)),
            inner_iterations: step.inner_iterations,
            n_a: self.operator.tally().count - self.journal.before.count,
            step_length: step.length,
        }
    }

    /// Progress is a smaller figure, or a lower objective beyond rounding, than ever before. Under
    /// bounds that change the objective says nothing.
    fn note_progress(&mut self, judged: &Judged, iteration: usize) {
        let rounding = objective_rounding(&judged.point, self.rhs, self.operator.accuracy());
        if !self.follows_coulomb() && judged.objective < self.lowest_objective - rounding {
            self.lowest_objective = judged.objective;
            self.last_progress = iteration;
        }
        if self
            .best
            .as_ref()
            .is_none_or(|best| judged.figure < best.figure)
        {
            self.best = Some(judged.clone());
            self.last_progress = iteration;
        }
    }

    /// Iterations without progress after which a method is said to stagnate. The
    /// Newton methods gain at every step or cycle; gradient methods may rest for a while.
    fn patience(&self) -> usize {
        // Another way waits, which takes its time but gets there.
        if self.follows_coulomb() && self.settings.coulomb == CoulombMethod::Auto {
            return PATIENCE_IN_LOOP;
        }
        match self.settings.method {
            Method::Apgd => 300,
            Method::Gimssn => 60,
            Method::Ssn | Method::Mssn | Method::Imssn | Method::Grssn => 25,
        }
    }

    /// The outcome; the best point unless the last one has converged.
    pub fn end(self, status: Status) -> Ending {
        let chosen = if status.is_converged() {
            self.last
        } else {
            self.best
        };
        // A start that is not finite was refused, so there is none only if the first product overflowed.
        let chosen = chosen.unwrap_or_else(|| zero_point(self.rhs, &self.set, 1.0));
        let mut set = self.set;
        if let Some(law) = self.inner.law.filter(|_| !chosen.bounds.is_empty()) {
            law.bound(&mut set, &chosen.bounds);
        }
        ending(status, chosen, set, self.reference)
    }
}

/// ‖r̃(0)‖ for a Λ, without the multiplier's share of b.
fn reference(inner: &Inner, set: &ProductSet, sigma: f64) -> f64 {
    let zero = Point::zero(inner.own_rhs);
    let (norm, _) = reduced_gradient(set, &zero, 1.0 / sigma);
    norm.max(inner.least_reference)
}

/// Whether rounding in Aλ alone may be more than [`DROWNED`] of the reference: no residual means anything then.
pub(crate) fn drowned(
    operator: &dyn DualOperator,
    sigma: f64,
    point: &Point,
    reference: f64,
) -> bool {
    let rounding = operator.accuracy() * sigma * norm(&point.lambda);
    reference > 0.0 && rounding > DROWNED * reference
}

/// A point as the end of an inner problem, with the status left to the caller.
pub(crate) fn ending_of(point: Point, inner: &Inner, sigma: f64) -> Ending {
    let reference = reference(inner, inner.set, sigma);
    let (norm, active) = reduced_gradient(inner.set, &point, 1.0 / sigma);
    let relative = relative(norm, reference);
    let judged = Judged {
        active,
        relative,
        objective: objective(&point, inner.rhs),
        point,
        bounds_change: 0.0,
        bounds: Vec::new(),
        figure: relative,
    };
    ending(Status::Stagnated, judged, inner.set.clone(), reference)
}

/// The end at λ = 0 of a problem whose reduced gradient vanishes there. Costs no multiplication.
pub(crate) fn zero_ending(rhs: &[f64], set: ProductSet) -> Ending {
    let zero = zero_point(rhs, &set, 0.0);
    ending(Status::Converged, zero, set, 0.0)
}

/// P_Λ(λ) as an end, with the status left to the caller.
pub(crate) fn ending_at(
    operator: &mut dyn DualOperator,
    sigma: f64,
    rhs: &[f64],
    set: ProductSet,
    mut lambda: Vec<f64>,
) -> Ending {
    set.project(&mut lambda);
    let point = point_at(operator, rhs, lambda);
    let (reference, _) = reduced_gradient(&set, &Point::zero(rhs), 1.0 / sigma);
    let (norm, active) = reduced_gradient(&set, &point, 1.0 / sigma);
    let relative = relative(norm, reference);
    let judged = Judged {
        active,
        relative,
        objective: objective(&point, rhs),
        point,
        bounds_change: 0.0,
        bounds: Vec::new(),
        figure: relative,
    };
    ending(Status::Stagnated, judged, set, reference)
}

fn ending(status: Status, chosen: Judged, set: ProductSet, reference: f64) -> Ending {
    Ending {
        status,
        point: chosen.point,
        set,
        active: chosen.active,
        relative: chosen.relative,
        reference,
        objective: chosen.objective,
        multiplier: Vec::new(),
        equality_residual: 0.0,
        motion: None,
        statics: None,
        contradiction: None,
        outer_iterations: 0,
        outer_residual: chosen.bounds_change,
    }
}

fn zero_point(rhs: &[f64], set: &ProductSet, relative: f64) -> Judged {
    // y = ρ b: every ρ > 0 gives the same states.
    Judged {
        active: set.classify(rhs),
        point: Point::zero(rhs),
        relative,
        objective: 0.0,
        bounds_change: 0.0,
        bounds: Vec::new(),
        figure: relative,
    }
}
