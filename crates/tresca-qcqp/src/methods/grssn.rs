//! GRSSN: the reduced semismooth Newton method, globalised.
//!
//! From the projected gradient point x = P_Λ(λ − ρ r(λ)) a Newton step that
//! keeps the curvature C of the slip circles, in the space Z of what may move:
//!
//! <div>
//! $$
//! (Z^T A Z + C)\, s = -Z^T r(x), \qquad \delta = Z s
//! $$
//! </div>
//!
//! The system is symmetric positive definite (see [`Tangent`]), so one preconditioned CG per step suffices, and
//! convergence is superlinear. The step counts only if it does not raise q above
//! q(x); x itself has the guarantee of GIMSSN: globally R-linear.
//!
//! Where a few soft motions (bending of plates) govern A, ρ < 2/σmax moves x next to nothing, its active
//! set says little, and the Newton point may leave Λ so far that its projection raises q. Then the blocks that
//! left are bound where they left, and the smaller system is solved: pivoting by blocks, until the projected
//! point counts. If that bound too many of them, the method walks from face to face, downhill all the way (see `faces`).

use super::faces::{downhill, pivot, walk};
use super::run::{Advance, Run};
use crate::active_set::ActiveSet;
use crate::newton::operator_memory::NewtonMemory;
use crate::newton::preconditioner::Preconditioner;
use crate::newton::system::{Move, conjugate_gradients};
use crate::newton::tangent::Tangent;
use crate::point::Point;
use crate::status::Status;

/// Part of the last reduction of the reduced gradient that the next inner system is solved to.
const FORCING_RATIO: f64 = 0.5;
/// Part of the wanted reduced gradient below which an inner residual is of no use.
const OVERSOLVING: f64 = 0.3;

pub(super) fn run(run: &mut Run, memory: &mut NewtonMemory, start: Point) -> Status {
    let NewtonMemory {
        model,
        recycled,
        workspace,
    } = memory;
    let mut previous = f64::INFINITY;
    let mut lambda = start;
    let mut step = Advance::START;
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
            let solver = run.settings.inner_solver;
            let tangent = Tangent::at_point(run.operator, solver, &run.set, active, base);
            let mut newton = base.clone();
            if tangent.step(run.operator, &mut newton) {
                inner += 1;
                return newton;
            }
            let space = tangent.space();
            let mut preconditioner = Preconditioner::new(space, model, recycled, workspace);
            let keep = |_: &Point, step: &Move| {
                recycled.offer(step.direction, step.product);
                true
            };
            let spent = conjugate_gradients(
                run.operator,
                space,
                &mut preconditioner,
                &mut newton,
                tolerance,
                run.settings.max_inner_iterations,
                keep,
            );
            inner += spent.iterations;
            newton
        };
        let newton = newton_from(run, &x, &active);
        let pivoted = pivot(run, &lambda, &x, active.clone(), &newton, &mut newton_from);
        let (next, length) = if let Some(point) = pivoted {
            (point, 1.0)
        } else if let Some((point, _, length)) = downhill(run, &x, &newton) {
            (point, length)
        } else {
            walk(run, &lambda, x, active, newton, &mut newton_from)
        };
        lambda = next;
        step = Advance {
            inner_iterations: inner,
            length,
        };
    }
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
            x.objective_change_from(lambda) > run.rounding(lambda, &x)
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
