//! GRSSN: the reduced semismooth Newton method, globalised.
//!
//! From the projected gradient point x = P_Λ(λ − ρ r(λ)) a Newton step that
//! keeps the curvature of the slip circles; its system is symmetric positive
//! definite (see `reduced`), so one preconditioned CG per step suffices, and
//! convergence is superlinear. The step counts only if it does not raise q above
//! q(x); x itself has the guarantee of GIMSSN: globally R-linear.
//!
//! Where a few soft motions (bending of plates) govern A, ρ < 2/σmax moves x next to nothing, its active
//! set says little, and the Newton point may leave Λ so far that its projection raises q. Then the blocks that
//! left are bound where they left, and the smaller system is solved: pivoting by blocks, until the projected
//! point counts.

use super::inner::{Move, conjugate_gradients, direct};
use super::memory::NewtonMemory;
use super::preconditioner::Preconditioner;
use super::run::Step;
use super::{Point, Run};
use crate::reduced::ReducedSpace;
use crate::sets::{BlockState, ProductSet};
use crate::{ActiveSet, Status};
use tresca_la::vector::norm;

/// Times that blocks which left Λ are bound and the system is solved again, in one step.
const MAX_PIVOTS: usize = 30;
/// Halvings of the Newton step before the projected gradient step is made.
const MAX_HALVINGS: usize = 3;
/// Part of the last reduction of the reduced gradient that the next inner system is solved to.
const FORCING_RATIO: f64 = 0.5;
/// Part of the wanted reduced gradient below which an inner residual is of no use.
const OVERSOLVING: f64 = 0.3;

pub(super) fn run(run: &mut Run, memory: &mut NewtonMemory, start: Point) -> Status {
    let NewtonMemory { model, recycled } = memory;
    let mut previous = f64::INFINITY;
    let mut lambda = start;
    let mut step = Step::START;
    loop {
        if let Some(status) = run.judge(&lambda, step) {
            return status;
        }
        run.follow_coulomb(&lambda);
        let (x, active) = projected_gradient_point(run, &lambda);
        let tolerance = forcing(run, previous) * run.relative * run.reference;
        previous = run.relative;
        let mut inner = 0;
        let mut newton_from = |run: &mut Run, base: &Point, active: &ActiveSet| {
            let space = tangent_space(&run.set, active, base);
            let mut newton = base.clone();
            if direct(run, &space, &mut newton) {
                inner += 1;
                return newton;
            }
            let mut preconditioner = Preconditioner::new(&space, model, recycled);
            let keep = |_: &Point, step: &Move| {
                recycled.offer(step.direction, step.product);
                true
            };
            inner += conjugate_gradients(
                run,
                &space,
                &mut preconditioner,
                &mut newton,
                tolerance,
                keep,
            );
            newton
        };
        let newton = newton_from(run, &x, &active);
        let (next, length) = match pivot(run, &lambda, &x, active, &newton, &mut newton_from) {
            Some(point) => (point, 1.0),
            None => search(run, &lambda, x, &newton),
        };
        lambda = next;
        step = Step {
            inner_iterations: inner,
            length,
        };
    }
}

/// The projection of the Newton point, if it does not raise q above q(x); else that of the Newton point of a
/// smaller space, which takes the blocks that left Λ as bound where they left. `None` when none of them will do.
fn pivot(
    run: &mut Run,
    lambda: &Point,
    x: &Point,
    mut active: ActiveSet,
    newton: &Point,
    newton_from: &mut impl FnMut(&mut Run, &Point, &ActiveSet) -> Point,
) -> Option<Point> {
    let mut newton = newton.clone();
    let mut base = x.clone();
    for _ in 0..=MAX_PIVOTS {
        let trial = run.projected(&newton);
        if trial.objective_change_from(x) <= rounding(run, lambda, &trial) {
            return Some(trial);
        }
        let (smaller, bound) = without_those_that_left(&run.set, &active, &base, &newton, &trial)?;
        active = smaller;
        base = run.point_unless(bound, &base);
        newton = newton_from(run, &base, &active);
    }
    None
}

/// The active set without the free blocks that are outside of their sets at the Newton point, and the base point
/// with these blocks where the projection puts them. `None` when there is no such block.
fn without_those_that_left(
    set: &ProductSet,
    active: &ActiveSet,
    base: &Point,
    newton: &Point,
    projected: &Point,
) -> Option<(ActiveSet, Vec<f64>)> {
    let mut states = active.states().to_vec();
    let mut bound = base.lambda.clone();
    let mut left = false;
    for (block, state) in set.blocks().iter().zip(&mut states) {
        let range = block.range();
        if *state == BlockState::Free
            && newton.lambda[range.clone()] != projected.lambda[range.clone()]
        {
            *state = BlockState::Bound;
            bound[range.clone()].copy_from_slice(&projected.lambda[range]);
            left = true;
        }
    }
    left.then(|| (ActiveSet::new(set.blocks(), states), bound))
}

/// x = P_Λ(y) and the active set at y = λ − ρ r(λ).
///
/// q(x) ≤ q(λ) as long as ρ ≤ 2/σmax. The estimate of σmax is an upper bound
/// but for bad luck; when q rises, luck was bad, and ρ is halved for good.
fn projected_gradient_point(run: &mut Run, lambda: &Point) -> (Point, ActiveSet) {
    loop {
        let mut y = run.y(lambda);
        let active = run.set.classify(&y);
        run.set.project(&mut y);
        let x = run.point_unless(y, lambda);
        let fails = if run.follows_coulomb() {
            curves_too_much(lambda, &x, run.rho)
        } else {
            x.objective_change_from(lambda) > rounding(run, lambda, &x)
        };
        if !fails {
            return (x, active);
        }
        run.rho *= 0.5;
    }
}

/// dᵀAd > (2/ρ) ‖d‖² on the step d = x − λ: ρ is above 2/σmax. For bounds that have just
/// changed this replaces the descent of q, which a λ outside of the new Λ cannot promise.
fn curves_too_much(lambda: &Point, x: &Point, rho: f64) -> bool {
    let (mut square, mut curvature) = (0.0, 0.0);
    for i in 0..lambda.lambda.len() {
        let step = x.lambda[i] - lambda.lambda[i];
        square += step * step;
        curvature += step * (x.gradient[i] - lambda.gradient[i]);
    }
    curvature > 2.0 * (1.0 + 1e-8) / rho * square
}

/// Z and C at x, where slipping pairs are on their circles: c̃ = max(−n̂ᵀr, 0)/g
/// with the normal n̂ = x/g, the slip per friction force there.
pub(super) fn tangent_space(set: &ProductSet, active: &ActiveSet, x: &Point) -> ReducedSpace {
    let Point { lambda, gradient } = x;
    ReducedSpace::with_tangents(set, active, lambda, |i, bound| {
        let radial = (lambda[i] * gradient[i] + lambda[i + 1] * gradient[i + 1]) / bound;
        f64::max(-radial / bound, 0.0)
    })
}

/// η: the inner residual relative to the current reduced gradient, after Eisenstat
/// and Walker; never finer than the tolerance of the run can notice. Bounds that follow λ notice more.
fn forcing(run: &Run, previous: f64) -> f64 {
    // In the first step nothing is known of the rate.
    let rate = if previous.is_finite() {
        run.relative / previous
    } else {
        f64::INFINITY
    };
    let wanted = f64::min(run.settings.forcing, FORCING_RATIO * rate);
    if run.follows_coulomb() {
        return wanted;
    }
    wanted.max(OVERSOLVING * run.tolerance / run.relative)
}

/// The first of P_Λ(x + α(newton − x)), α = ½, ¼, …, that does not raise q above
/// q(x), with its α; else x, with α = 0.
fn search(run: &mut Run, lambda: &Point, x: Point, newton: &Point) -> (Point, f64) {
    let mut alpha = 0.5;
    for _ in 0..MAX_HALVINGS {
        let trial = run.projected(&blend(&x, newton, alpha));
        if trial.objective_change_from(&x) <= rounding(run, lambda, &trial) {
            return (trial, alpha);
        }
        alpha *= 0.5;
    }
    (x, 0.0)
}

/// x + α (newton − x), gradient included.
fn blend(x: &Point, newton: &Point, alpha: f64) -> Point {
    let mix = |x: &[f64], newton: &[f64]| {
        x.iter()
            .zip(newton)
            .map(|(x, n)| x + alpha * (n - x))
            .collect::<Vec<_>>()
    };
    Point {
        lambda: mix(&x.lambda, &newton.lambda),
        gradient: mix(&x.gradient, &newton.gradient),
    }
}

/// What a computed change of q from `lambda` to `trial` may be wrong by. The part
/// in |λ|ᵀ|r| is needed: a projected pair is on its circle to rounding only, which
/// moves q by more than a step does once the reduced gradient is below 1e-8.
fn rounding(run: &Run, lambda: &Point, trial: &Point) -> f64 {
    let (mut moved, mut size) = (0.0, 0.0);
    for (i, l) in lambda.lambda.iter().enumerate() {
        moved += (trial.lambda[i] - l).powi(2);
        size += (l * lambda.gradient[i]).abs();
    }
    f64::EPSILON * (16.0 * moved.sqrt() * norm(run.rhs) + 32.0 * size)
}
