//! The solution of one inner problem: by the method of the settings, and by proximal steps where that fails.

use crate::inner_problem::{Ending, Inner};
use crate::methods::run;
use crate::point::point_at;
use crate::session::{Attempt, Session};
use crate::settings::Method;
use crate::singular::proximal;
use crate::singular::shifted::Shift;
use crate::status::Status;
use tresca_la::vector::dot;

/// Where A is singular, blocks of it are factored with this part of σmax added: of all Newton steps a short one.
const STEADY: f64 = 1e-10;

/// Steps that the method of the settings gets before proximal steps take over, however few are allowed.
const FEW: usize = 50;
/// A relative reduced gradient that is rounding: proximal steps would not get further.
const ROUNDING: f64 = 1e-12;

/// Part of the objective that rounding in it may be.
const CANCELS: f64 = 1e-9;

/// The fresh reduced gradient, relative to the tolerance, at which digits are said to be lost.
const LOST: f64 = 10.0;

/// Solves one inner problem by the method of the settings, and by proximal steps where that fails.
pub(crate) fn solve(session: &mut Session, inner: &Inner, start: Option<&[f64]>) -> Ending {
    let steady = if session.singular { STEADY } else { 0.0 };
    let helped = helped(session, inner);
    if helped && session.proximal_steps > 0 {
        return proximal::solve(session, inner, start);
    }
    let limit = session.most_steps;
    let attempt = Attempt {
        method: session.settings.method,
        shift: Shift {
            products: 0.0,
            factors: steady * session.memory.spectrum.sigma,
        },
        most_steps: if helped { first_share(session) } else { limit },
    };
    let ending = session.attempt(inner, start, attempt);
    let failed = match ending.status {
        Status::Diverged => true,
        // A tolerance below rounding is not to be had by other steps either.
        Status::Stagnated | Status::IterationLimit => ending.relative > ROUNDING,
        Status::Converged => {
            session.singular && (cancels(session, &ending) || lost(session, inner, &ending))
        }
        _ => false,
    };
    if !helped || !failed || session.journal.steps() >= limit {
        return ending;
    }
    let rescued = proximal::solve(session, inner, start);
    let better = |ending: &Ending| matches!(ending.status, Status::Converged | Status::Infeasible);
    if better(&rescued) || rescued.relative < ending.relative {
        rescued
    } else {
        ending
    }
}

/// Whether forces that cancel each other are so large that rounding in their work is seen in the objective.
fn cancels(session: &Session, ending: &Ending) -> bool {
    let forces = dot(&ending.point.lambda, &ending.point.lambda);
    let rounding = session.operator.accuracy() * session.memory.spectrum.sigma * forces;
    rounding > CANCELS * ending.objective.abs()
}

/// Whether the gradient of a method whose iterates may be far outside of Λ has lost its digits on the way: one
/// product tells.
fn lost(session: &mut Session, inner: &Inner, ending: &Ending) -> bool {
    if guaranteed(session) {
        return false;
    }
    let fresh = point_at(
        &mut *session.operator,
        inner.rhs,
        ending.point.lambda.clone(),
    );
    let fresh = run::ending_of(fresh, inner, session.memory.spectrum.sigma);
    fresh.relative > LOST * inner.tolerance
}

/// The steps after which the method of the settings makes room for proximal steps.
fn first_share(session: &Session) -> usize {
    let done = session.journal.steps();
    let left = session.most_steps.saturating_sub(done);
    if session.singular && session.settings.method != Method::Apgd {
        done + left.min(FEW)
    } else {
        done + left.min(2 * FEW).max(left / 2)
    }
}

/// Whether proximal steps follow where the method of the settings fails. Methods without a guarantee may fail
/// on any problem, and are to be seen failing; but not because A is singular. Bounds that follow λ have
/// another way out.
fn helped(session: &Session, inner: &Inner) -> bool {
    inner.law.is_none() && (guaranteed(session) || session.singular)
}

fn guaranteed(session: &Session) -> bool {
    matches!(
        session.settings.method,
        Method::Gimssn | Method::Grssn | Method::Apgd
    )
}
