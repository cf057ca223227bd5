//! GRSSN: the reduced semismooth Newton method, globalised.
//!
//! The Newton system keeps the curvature of the slip circles and is symmetric
//! positive definite (see `reduced`), so one preconditioned CG per step
//! suffices and convergence is superlinear. A step counts only if it lowers q at
//! least as far as a projected gradient step is bound to, which makes the
//! method globally R-linear; if none does, the projected gradient step is made.
//!
//! Newton's system is set up at λ itself, not at the projected gradient point:
//! while the active set stays, r(λ) is known and a multiplication is saved.

use super::inner::{Move, conjugate_gradients, direct};
use super::recycle::{RecycledPreconditioner, RecycledProducts};
use super::run::{Step, gradient_step};
use super::{Point, Run};
use crate::reduced::ReducedSpace;
use crate::sets::{BlockSet, BlockState, ProductSet};
use crate::spectrum::Spectrum;
use crate::{ActiveSet, Status};
use tresca_la::vector::{dot, norm};

/// Halvings of the Newton step before the projected gradient step is made.
const MAX_HALVINGS: usize = 3;
/// Part of the last reduction of the reduced gradient that the next inner system is solved to.
const FORCING_RATIO: f64 = 0.5;
/// Part of the wanted reduced gradient below which an inner residual is of no use.
const OVERSOLVING: f64 = 0.3;
/// A pair this close to its circle (relative) is on it.
const ON_CIRCLE: f64 = 1e-12;

pub(super) fn run(run: &mut Run, spectrum: &Spectrum, start: Point) -> Status {
    let diagonal = calibrated_diagonal(run, spectrum);
    let mut recycled = RecycledProducts::new(run.settings.recycled_directions);
    for (v, product) in spectrum.basis.iter().zip(&spectrum.products) {
        recycled.offer(v, product);
    }
    let mut majorant = Majorant { sigma: run.sigma };
    let mut previous = f64::INFINITY;
    let mut x = start;
    let mut step = Step::START;
    loop {
        if let Some(status) = run.judge(&x, step) {
            return status;
        }
        let y = run.y(&x);
        let active = run.set.classify(&y);
        let base = base_point(run, &x, &active, &y);
        let space = tangent_space(run.set, &active, &base);
        let mut newton = base.clone();
        let inner = if direct(run, &space, &mut newton) {
            1
        } else {
            let mut preconditioner = RecycledPreconditioner::new(&space, &diagonal, &recycled);
            let tolerance = forcing(run, previous) * run.relative * run.reference;
            let keep = |_: &Point, step: &Move| {
                recycled.offer(step.direction, step.product);
                true
            };
            conjugate_gradients(run, &space, &mut preconditioner, &mut newton, tolerance, keep)
        };
        previous = run.relative;
        let (next, length) = majorant.search(run, &x, &base, &newton);
        x = next;
        step = Step { inner_iterations: inner, length };
    }
}

/// D: the operator's estimate of its diagonal, scaled to fit A on the first Lanczos vector.
fn calibrated_diagonal(run: &Run, spectrum: &Spectrum) -> Vec<f64> {
    let mut diagonal = run.operator.diagonal_estimate();
    // An unknown that moves nothing has a zero row; any positive scale serves it.
    let least = f64::EPSILON * diagonal.iter().copied().fold(0.0, f64::max);
    diagonal.iter_mut().for_each(|d| *d = d.max(least));
    let (v, product) = (&spectrum.basis[0], &spectrum.products[0]);
    let estimated: f64 = v.iter().zip(&diagonal).map(|(v, d)| v * v * d).sum();
    let scale = dot(v, product) / estimated;
    diagonal.iter_mut().for_each(|d| *d *= scale);
    diagonal
}

/// λ with the open normals at 0 and every slipping pair on its circle: where it
/// is if it is there already, else at the projection of y.
fn base_point(run: &mut Run, x: &Point, active: &ActiveSet, y: &[f64]) -> Point {
    let mut base = run.with_bound_blocks_fixed(&x.lambda, active, y);
    for (block, state) in run.set.blocks().iter().zip(active.states()) {
        let BlockSet::Disc(disc) = block.set else { continue };
        let pair = &x.lambda[block.range()];
        if *state == BlockState::Bound && pair[0].hypot(pair[1]) >= disc.bound * (1.0 - ON_CIRCLE) {
            base[block.range()].copy_from_slice(pair);
        }
    }
    run.point_unless(base, x)
}

/// Z and C at the base point: the normals are those of the pairs on their
/// circles, c̃ = max(−n̂ᵀr, 0)/g is the slip per friction force there.
fn tangent_space(set: &ProductSet, active: &ActiveSet, base: &Point) -> ReducedSpace {
    let Point { lambda, gradient } = base;
    ReducedSpace::with_tangents(set, active, lambda, |i, bound| {
        let radial = (lambda[i] * gradient[i] + lambda[i + 1] * gradient[i + 1]) / bound;
        f64::max(-radial / bound, 0.0)
    })
}

/// η: the inner residual relative to the current reduced gradient, after Eisenstat
/// and Walker; never finer than the tolerance of the run can notice.
fn forcing(run: &Run, previous: f64) -> f64 {
    let superlinear = FORCING_RATIO * run.relative / previous;
    let largest = run.settings.forcing;
    // In the first step nothing is known of the rate.
    let wanted = if previous.is_finite() { largest.min(superlinear) } else { largest };
    wanted.max(OVERSOLVING * run.settings.tolerance / run.relative)
}

/// q(λ) + rᵀδ + ½ σ‖δ‖² ≥ q(λ + δ) for σ ≥ σmax: what a projected gradient step is bound to reach.
struct Majorant {
    sigma: f64,
}

impl Majorant {
    /// The first of P_Λ(base + α(newton − base)), α = 1, ½, …, that lowers q from `x` as far as the
    /// majorant of the projected gradient step does, with its α; else that step, with α = 0.
    fn search(&mut self, run: &mut Run, x: &Point, base: &Point, newton: &Point) -> (Point, f64) {
        let (_, wanted) = self.gradient_point(run, x);
        let mut alpha = 1.0;
        for _ in 0..=MAX_HALVINGS {
            let along = blend(base, newton, alpha);
            let trial = run.projected(&along);
            if trial.objective_change_from(x) <= wanted + rounding(run, x, &trial) {
                return (trial, alpha);
            }
            alpha *= 0.5;
        }
        (self.gradient_descent(run, x), 0.0)
    }

    /// P_Λ(λ − r/σ), and the change of the majorant from λ to there (≤ 0).
    fn gradient_point(&self, run: &Run, x: &Point) -> (Vec<f64>, f64) {
        let mut lambda = gradient_step(x, 1.0 / self.sigma);
        run.set.project(&mut lambda);
        let mut change = 0.0;
        for (i, l) in lambda.iter().enumerate() {
            let delta = l - x.lambda[i];
            change += (x.gradient[i] + 0.5 * self.sigma * delta) * delta;
        }
        (lambda, change)
    }

    /// The projected gradient step. Should q fall less than the majorant says, σ is no upper
    /// bound after all (Lanczos steps may miss the top of the spectrum): it is raised.
    fn gradient_descent(&mut self, run: &mut Run, x: &Point) -> Point {
        loop {
            let (lambda, wanted) = self.gradient_point(run, x);
            let next = run.point(lambda);
            let change = next.objective_change_from(x);
            // Negated so that a NaN ends the loop.
            if !(change > wanted + rounding(run, x, &next)) {
                return next;
            }
            self.sigma *= 2.0;
        }
    }
}

/// base + α (newton − base), gradient included.
fn blend(base: &Point, newton: &Point, alpha: f64) -> Point {
    if alpha == 1.0 {
        return newton.clone();
    }
    let mix = |base: &[f64], newton: &[f64]| {
        base.iter().zip(newton).map(|(b, n)| b + alpha * (n - b)).collect::<Vec<_>>()
    };
    Point {
        lambda: mix(&base.lambda, &newton.lambda),
        gradient: mix(&base.gradient, &newton.gradient),
    }
}

/// What a computed change of q from `x` to `trial` may be wrong by.
fn rounding(run: &Run, x: &Point, trial: &Point) -> f64 {
    let mut moved = 0.0;
    let mut size = 0.0;
    for (i, l) in x.lambda.iter().enumerate() {
        moved += (trial.lambda[i] - l).powi(2);
        size += (l * x.gradient[i]).abs();
    }
    f64::EPSILON * (16.0 * moved.sqrt() * norm(run.rhs) + 32.0 * size)
}
