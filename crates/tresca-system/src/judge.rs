//! The last word: an answer is called converged when it passes its certificate, as it is handed out.
//!
//! The iteration's own residual decides when to ask. It is relative to what the loads would do without contact, and
//! where that is far more than what they do with it (a thin plate on a block would bend by kilometres), a small part
//! of it is still large. Then the same problem is solved on from where it stands, to finer and finer tolerances. What
//! fails in the end is [`Status::Inaccurate`]: rounding leaves it undetermined.

use tresca_qcqp::{Settings, Status};

use crate::certificate::Failure;
use crate::run::Unsolved;
use crate::solved::Solved;

/// The part of a tolerance that the next solve gets, and the finest one.
const FINER: f64 = 1e-2;
const FINEST: f64 = 1e-15;

/// Rows of B nearer to each other than this ask for gaps that are so much closer.
const NEAR: f64 = 1e-3;

/// Judges an answer; `distance` is that of the rows of B from each other: displacements are known to what gaps are
/// known to, divided by it. `again` solves on from one to other settings.
///
/// # Errors
/// Those of `again`.
pub(crate) fn judge(
    mut best: Solved,
    settings: &Settings,
    distance: f64,
    mut again: impl FnMut(&Settings, &Solved) -> Result<Solved, Unsolved>,
) -> Result<Solved, Unsolved> {
    let sharpness = if distance < NEAR { distance } else { 1.0 };
    let mut finer = settings.clone();
    while best.dual.status == Status::Converged {
        let Some(failure) = best.certificate.failure(settings, sharpness) else {
            return Ok(best);
        };
        finer.tolerance *= FINER;
        if finer.tolerance < FINEST || best.dual.figures.iterations >= settings.max_iterations {
            return Ok(failed(best, failure));
        }
        finer.coulomb_tolerance = finer.coulomb_tolerance.min(finer.tolerance.max(1e-10));
        let mut next = match again(&finer, &best) {
            // What there is stays.
            Err(Unsolved::Stopped(_)) => {
                best.dual.status = Status::Interrupted;
                return Ok(best);
            }
            next => next?,
        };
        next.dual.follow(&best.dual);
        match (
            next.dual.status,
            next.certificate.failure(settings, sharpness),
        ) {
            // A tolerance that rounding did not allow has nevertheless led to an answer that passes.
            (Status::Stagnated | Status::IterationLimit, None) => {
                next.dual.status = Status::Converged;
                return Ok(next);
            }
            (Status::Converged | Status::Infeasible | Status::Interrupted, _) => best = next,
            (_, Some(other)) if other.value / other.limit < failure.value / failure.limit => {
                return Ok(failed(next, other));
            }
            _ => {
                best.dual.figures = next.dual.figures;
                return Ok(failed(best, failure));
            }
        }
    }
    let unsettled = matches!(
        best.dual.status,
        Status::Stagnated | Status::IterationLimit | Status::Diverged
    );
    // Not for want of iterations.
    if sharpness < 1.0
        && unsettled
        && let Some(failure) = best.certificate.failure(settings, sharpness)
    {
        return Ok(failed(best, failure));
    }
    Ok(best)
}

fn failed(mut solved: Solved, failure: Failure) -> Solved {
    solved.dual.status = Status::Inaccurate;
    solved.failure = Some(failure);
    solved
}
