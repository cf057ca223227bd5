//! The choice between the two ways to the bounds.

use super::frictional::Frictional;
use super::{fixed_point, in_loop, sweeps};
use crate::inner_problem::Ending;
use crate::session::Session;
use crate::settings::{CoulombMethod, Method};
use crate::start::Start;
use crate::status::Status;

/// Steps that the loop gets before the fixed point, however few are allowed.
const FEW: usize = 100;

/// Solves it by the way that the settings name, and contact by contact where that gives up.
pub(crate) fn solve(session: &mut Session, problem: &Frictional, start: Option<Start>) -> Ending {
    let ending = by_newton(session, problem, start);
    let steps_left = session.journal.steps() < session.settings.max_iterations;
    if !(gave_up(ending.status) && steps_left) || session.journal.stop {
        return ending;
    }
    sweeps::solve(session, problem, start).unwrap_or(ending)
}

fn by_newton(session: &mut Session, problem: &Frictional, start: Option<Start>) -> Ending {
    match session.settings.coulomb {
        CoulombMethod::FixedPoint => fixed_point::solve(session, problem, start),
        CoulombMethod::InLoop => in_loop::solve(session, problem, start),
        CoulombMethod::Auto if session.settings.method != Method::Grssn => {
            fixed_point::solve(session, problem, start)
        }
        // Where both are possible the loop takes fewer products: by a quarter on clamped bodies, by
        // half on floating ones with iterative inner solves. But close to the load that friction can
        // just carry, bounds and rigid motions drive each other on, and the fixed point gets there.
        CoulombMethod::Auto => {
            // The fixed point must have its share.
            let all = session.most_steps;
            session.most_steps = all.min(FEW).max(all / 2);
            let ending = in_loop::solve(session, problem, start);
            session.most_steps = all;
            let steps_left = session.journal.steps() < session.settings.max_iterations;
            if gave_up(ending.status) && steps_left && !session.journal.stop {
                fixed_point::solve(session, problem, start)
            } else {
                ending
            }
        }
    }
}

/// Whether another way may get further.
fn gave_up(status: Status) -> bool {
    matches!(
        status,
        Status::IterationLimit
            | Status::Stagnated
            | Status::Diverged
            | Status::CoulombCycles
            | Status::CoulombDiverges
    )
}
