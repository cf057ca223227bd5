//! What every method needs: the problem, the one measure, the records, the verdict.

use crate::sets::{BlockState, ConvexSet};
use crate::spectrum::Spectrum;
use crate::{
    ActiveSet, DualOperator, IterationRecord, Method, Observer, ProductSet, Settings, Solution,
    Status,
};
use tresca_la::vector::{axpy, dot, norm};

/// A point λ and the gradient r(λ) = Aλ − b there.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    pub lambda: Vec<f64>,
    pub gradient: Vec<f64>,
}

impl Point {
    /// q(self) − q(other) = ½ (λ − λ')ᵀ(r + r'), without the cancellation of a difference of two q.
    pub fn objective_change_from(&self, other: &Point) -> f64 {
        let mut change = 0.0;
        for i in 0..self.lambda.len() {
            change += (self.lambda[i] - other.lambda[i]) * (self.gradient[i] + other.gradient[i]);
        }
        0.5 * change
    }

    /// Moves along a direction whose product with A is known.
    pub fn advance(&mut self, alpha: f64, direction: &[f64], product: &[f64]) {
        axpy(alpha, direction, &mut self.lambda);
        axpy(alpha, product, &mut self.gradient);
    }
}

/// How an iterate was reached.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub inner_iterations: usize,
    pub length: f64,
}

impl Step {
    /// The step that leads to the start: none.
    pub const START: Step = Step {
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
}

/// One run of one method.
pub(crate) struct Run<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub rhs: &'a [f64],
    pub set: &'a ProductSet,
    pub settings: &'a Settings,
    /// Upper estimate of σmax.
    pub sigma: f64,
    /// The method's own ρ.
    pub rho: f64,
    /// ‖r̃(0)‖, the scale of every residual.
    pub reference: f64,
    /// ‖r̃(λ)‖/‖r̃(0)‖ of the point judged last.
    pub relative: f64,
    observer: &'a mut dyn Observer,
    records: Vec<IterationRecord>,
    last: Option<Judged>,
    best: Option<Judged>,
    lowest_objective: f64,
    last_progress: usize,
    n_a_before: usize,
    n_a_setup: usize,
}

impl<'a> Run<'a> {
    pub fn new(
        operator: &'a mut dyn DualOperator,
        rhs: &'a [f64],
        set: &'a ProductSet,
        settings: &'a Settings,
        spectrum: &Spectrum,
        n_a_before: usize,
        observer: &'a mut dyn Observer,
    ) -> Self {
        let n_a_setup = *operator.counter() - n_a_before;
        let zero = Point {
            lambda: vec![0.0; rhs.len()],
            gradient: rhs.iter().map(|b| -b).collect(),
        };
        let sigma = spectrum.sigma;
        Self {
            operator,
            rhs,
            set,
            settings,
            sigma,
            rho: settings.rho / sigma,
            reference: reduced_gradient(set, &zero, 1.0 / sigma).0,
            relative: f64::INFINITY,
            observer,
            records: Vec::new(),
            last: None,
            best: None,
            lowest_objective: f64::INFINITY,
            last_progress: 0,
            n_a_before,
            n_a_setup,
        }
    }

    /// The start, projected; 0 if none is given, which costs no multiplication.
    pub fn start(&mut self, start: Option<&[f64]>) -> Point {
        let mut lambda = start.map_or_else(|| vec![0.0; self.rhs.len()], <[f64]>::to_vec);
        self.set.project(&mut lambda);
        self.point(lambda)
    }

    /// The point at λ: one multiplication, none for λ = 0.
    pub fn point(&mut self, lambda: Vec<f64>) -> Point {
        let mut gradient = vec![0.0; lambda.len()];
        if lambda.iter().any(|&l| l != 0.0) {
            self.operator.apply(&lambda, &mut gradient);
        }
        axpy(-1.0, self.rhs, &mut gradient);
        Point { lambda, gradient }
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
        reduced_gradient(self.set, point, self.rho).0
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

    /// Records the feasible `point`, tells the observer, and says whether the run is over.
    pub fn judge(&mut self, point: &Point, step: Step) -> Option<Status> {
        let (norm, active) = reduced_gradient(self.set, point, 1.0 / self.sigma);
        let relative = norm / self.reference;
        let objective = objective(point, self.rhs);
        if !relative.is_finite() || !objective.is_finite() {
            return Some(Status::Diverged);
        }
        self.relative = relative;
        let judged = Judged {
            point: point.clone(),
            active,
            relative,
            objective,
        };
        let record = self.record(&judged, step);
        self.note_progress(&judged, record.iteration);
        let stop = self.observer.iteration(&record).is_break();
        let iteration = record.iteration;
        self.records.push(record);
        self.last = Some(judged);

        if relative <= self.settings.tolerance {
            Some(Status::Converged)
        } else if stop {
            Some(Status::Interrupted)
        } else if iteration - self.last_progress >= patience(self.settings.method) {
            Some(Status::Stagnated)
        } else if iteration >= self.settings.max_iterations {
            Some(Status::IterationLimit)
        } else {
            None
        }
    }

    fn record(&mut self, judged: &Judged, step: Step) -> IterationRecord {
        let last = self.last.as_ref();
        IterationRecord {
            iteration: self.records.len(),
            relative_reduced_gradient: judged.relative,
            objective: judged.objective,
            decrease: last.map_or(0.0, |last| -judged.point.objective_change_from(&last.point)),
            counts: judged.active.counts(),
            set_changes: last.map_or(0, |last| judged.active.changes(&last.active)),
            inner_iterations: step.inner_iterations,
            n_a: *self.operator.counter() - self.n_a_before,
            step_length: step.length,
        }
    }

    /// Progress is a smaller reduced gradient, or a lower objective beyond rounding, than ever before.
    fn note_progress(&mut self, judged: &Judged, iteration: usize) {
        let rounding = objective_rounding(&judged.point, self.rhs);
        if judged.objective < self.lowest_objective - rounding {
            self.lowest_objective = judged.objective;
            self.last_progress = iteration;
        }
        if self
            .best
            .as_ref()
            .is_none_or(|best| judged.relative < best.relative)
        {
            self.best = Some(judged.clone());
            self.last_progress = iteration;
        }
    }

    /// The outcome; the best point unless the last one has converged.
    pub fn into_solution(self, status: Status) -> Solution {
        let chosen = if status.is_converged() {
            self.last
        } else {
            self.best
        };
        // A start that is not finite was refused, so there is none only if the first product overflowed.
        let chosen = chosen.unwrap_or_else(|| zero_point(self.rhs, self.set, 1.0));
        Solution {
            status,
            method: self.settings.method,
            lambda: chosen.point.lambda,
            gradient: chosen.point.gradient,
            relative_reduced_gradient: chosen.relative,
            objective: chosen.objective,
            active_set: chosen.active,
            iterations: self.records.len().saturating_sub(1),
            records: self.records,
            n_a: *self.operator.counter() - self.n_a_before,
            n_a_setup: self.n_a_setup,
            sigma_max: self.sigma,
        }
    }
}

/// The solution λ = 0 of a problem whose reduced gradient vanishes at 0. Costs no multiplication.
pub(crate) fn zero_solution(settings: &Settings, rhs: &[f64], set: &ProductSet) -> Solution {
    let zero = zero_point(rhs, set, 0.0);
    Solution {
        status: Status::Converged,
        method: settings.method,
        lambda: zero.point.lambda,
        gradient: zero.point.gradient,
        relative_reduced_gradient: 0.0,
        objective: 0.0,
        active_set: zero.active,
        iterations: 0,
        records: Vec::new(),
        n_a: 0,
        n_a_setup: 0,
        sigma_max: 0.0,
    }
}

fn zero_point(rhs: &[f64], set: &ProductSet, relative: f64) -> Judged {
    let lambda = vec![0.0; rhs.len()];
    let gradient = rhs.iter().map(|b| -b).collect();
    // y = ρ b: every ρ > 0 gives the same states.
    Judged {
        active: set.classify(rhs),
        point: Point { lambda, gradient },
        relative,
        objective: 0.0,
    }
}

/// Iterations without progress after which a method is said to stagnate. The
/// Newton methods gain at every step or cycle; gradient methods may rest for a while.
fn patience(method: Method) -> usize {
    match method {
        Method::Apgd => 300,
        Method::Gimssn => 60,
        Method::Ssn | Method::Mssn | Method::Imssn | Method::Grssn => 25,
    }
}

/// λ − ρ r(λ).
pub(crate) fn gradient_step(point: &Point, rho: f64) -> Vec<f64> {
    point
        .lambda
        .iter()
        .zip(&point.gradient)
        .map(|(l, r)| l - rho * r)
        .collect()
}

/// ‖r̃_ρ(λ)‖ = ‖λ − P_Λ(y)‖/ρ and the active set, both at y = λ − ρ r. On free blocks r̃ is r
/// itself, which spares the cancellation in λ − y.
fn reduced_gradient(set: &ProductSet, point: &Point, rho: f64) -> (f64, ActiveSet) {
    let mut reduced = gradient_step(point, rho);
    let active = set.classify(&reduced);
    for (block, state) in set.blocks().iter().zip(active.states()) {
        let range = block.range();
        let own = &mut reduced[range.clone()];
        match state {
            BlockState::Free => own.copy_from_slice(&point.gradient[range]),
            BlockState::Bound => {
                block.set.project(own);
                for (own, lambda) in own.iter_mut().zip(&point.lambda[range]) {
                    *own = (lambda - *own) / rho;
                }
            }
        }
    }
    (norm(&reduced), active)
}

/// q(λ) = ½ λᵀ(r − b).
fn objective(point: &Point, rhs: &[f64]) -> f64 {
    0.5 * (dot(&point.lambda, &point.gradient) - dot(&point.lambda, rhs))
}

/// What q may be wrong by when evaluated in floating point.
fn objective_rounding(point: &Point, rhs: &[f64]) -> f64 {
    let terms = point.lambda.iter().zip(point.gradient.iter().zip(rhs));
    let size: f64 = terms.map(|(l, (r, b))| l.abs() * (r.abs() + b.abs())).sum();
    16.0 * f64::EPSILON * size
}
