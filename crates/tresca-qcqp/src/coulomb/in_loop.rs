//! Bounds that follow the normal forces after every Newton step.
//!
//! The hook is in the loop of GRSSN. With an equality constraint the multiplier is updated outside.

use super::Frictional;
use crate::Status;
use crate::equality::Reach;
use crate::session::{Ending, Session};
use crate::start::Start;

/// Solves the problem from the bounds of the set when there is a start, from no friction without.
pub(super) fn solve(session: &mut Session, problem: &Frictional, start: Option<Start>) -> Ending {
    let Frictional { law, balance, .. } = *problem;
    let mut set = problem.set.clone();
    if start.is_none() {
        let nothing = vec![0.0; law.bounds_of_blocks().len()];
        law.bound(&mut set, &nothing);
    }
    let reach = balance.map(|_| Reach::cones(&set, law));
    let multiplier = balance.map_or_else(Vec::new, |b| {
        b.coordinates(start.map_or(&[], |s| s.multiplier))
    });
    let mut ending = problem.solve_with(
        session,
        &set,
        Some(law),
        reach.as_ref(),
        session.settings.tolerance,
        start.map(|s| s.lambda),
        &multiplier,
    );
    if balance.is_none() {
        ending.outer_iterations = session.journal.steps();
    }
    let unsettled = ending.outer_residual > session.settings.coulomb_tolerance;
    if ending.status == Status::Stagnated && unsettled {
        ending.status = Status::CoulombCycles;
    }
    ending
}
