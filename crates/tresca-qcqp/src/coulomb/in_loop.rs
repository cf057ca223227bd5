//! Bounds that follow the normal forces after every Newton step.
//!
//! The hook is in the loop of GRSSN. With an equality constraint the multiplier is updated outside.

use super::frictional::{Bounded, Frictional, first_multiplier};
use super::history::{LONGEST_CYCLE, RETURNED};
use crate::inner_problem::Ending;
use crate::record::IterationRecord;
use crate::session::Session;
use crate::start::Start;
use crate::status::Status;

/// Solves the problem from the bounds of the set when there is a start, from no friction without.
pub(super) fn solve(session: &mut Session, problem: &Frictional, start: Option<Start>) -> Ending {
    let Frictional { law, balance, .. } = *problem;
    let mut set = problem.set.clone();
    if start.is_none() {
        let nothing = vec![0.0; law.bounds_of_blocks().len()];
        law.bound(&mut set, &nothing);
    }
    let bounded = Bounded {
        problem,
        set: &set,
        law: Some(law),
        tolerance: session.settings.tolerance,
    };
    let multiplier = first_multiplier(problem, start);
    let mut ending = bounded.solve(session, start.map(|s| s.lambda), &multiplier);
    if balance.is_none() {
        ending.outer_iterations = session.journal.steps();
    }
    let unsettled = ending.outer_residual > session.settings.coulomb_tolerance;
    if ending.status == Status::Stagnated && unsettled {
        ending.status = if returns(&session.journal.records) {
            Status::CoulombCycles
        } else {
            Status::CoulombDiverges
        };
    }
    ending
}

/// Whether the last iterate is one of a few iterations ago, as far as the objective tells.
fn returns(records: &[IterationRecord]) -> bool {
    let [earlier @ .., before, last] = records else {
        return false;
    };
    let distance = |record: &IterationRecord| (last.objective - record.objective).abs();
    let mut recent = earlier.iter().rev().take(LONGEST_CYCLE - 1);
    recent.any(|old| distance(old) <= RETURNED * distance(before))
}
