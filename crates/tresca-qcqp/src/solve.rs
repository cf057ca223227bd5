//! One solve from the outside: checks, what is to be known of A, the way to the solution, the outcome.

use crate::coulomb;
use crate::coulomb::frictional::Frictional;
use crate::equality::multiplier::{self, Balanced};
use crate::error::{QcqpError, check_rows, check_vector};
use crate::inner_problem::{Ending, Inner, Journal};
use crate::inner_solve;
use crate::methods::run::zero_ending;
use crate::newton::operator_memory::OperatorMemory;
use crate::observe::Observer;
use crate::problem::DualProblem;
use crate::session::Session;
use crate::sets::product::ProductSet;
use crate::settings::Settings;
use crate::solution::DualSolution;
use crate::start::Start;
use tresca_la::vector::norm;

/// Solves the problem by the method of the settings.
///
/// The λ of `start` is projected onto Λ first; without one the methods start from 0. With a start
/// the bounds that Λ has count as first guess of those of Coulomb's law.
/// The run is deterministic: the same input, on a problem with the same past, gives the same iterates.
///
/// # Errors
/// Only for wrong input: settings out of range, a start of the wrong length or
/// not finite, an operator that is zero, not symmetric, not positive
/// semidefinite or not finite. How a run ended stands in
/// [`DualSolution::status`].
pub fn solve(
    problem: &mut DualProblem,
    settings: &Settings,
    start: Option<Start>,
    observer: &mut dyn Observer,
) -> Result<DualSolution, QcqpError> {
    settings.validate()?;
    if let Some(start) = start {
        check_vector("the start", start.lambda, problem.dim())?;
        if !start.multiplier.is_empty() {
            check_rows("the start", start.multiplier.len(), problem.equality_rows())?;
            check_vector("the start", start.multiplier, problem.equality_rows())?;
        }
    }
    let before = *problem.operator.tally();
    let mut journal = Journal {
        records: Vec::new(),
        problems: 0,
        before,
        n_a_setup: 0,
        stop: false,
    };
    if let Some(ending) = at_rest(problem) {
        problem.set = ending.set.clone();
        return Ok(ending.into_solution(settings, journal, before, 0.0));
    }
    let DualProblem {
        operator,
        rhs,
        set,
        law,
        balance,
        memory,
        singular,
    } = problem;
    let memory = OperatorMemory::of(memory, &mut **operator)?;
    let singular = *singular || memory.singular;
    journal.n_a_setup = operator.tally().count - before.count;
    if let Some(balance) = balance {
        balance.drop_rounding(memory.spectrum.sigma);
    }
    let mut session = Session {
        operator: &mut **operator,
        memory,
        settings,
        observer,
        journal,
        singular,
        most_steps: settings.max_iterations,
        proximal_steps: 0,
        sweeps: 0,
    };
    let frictional = Frictional {
        rhs,
        set,
        law,
        balance: balance.as_ref(),
    };
    let mut ending = solve_by_kind(&mut session, &frictional, start);
    if let Some(balance) = balance {
        ending.multiplier = balance.motion(&ending.multiplier);
        ending.motion = ending.motion.map(|motion| unit(balance.motion(&motion)));
    }
    *set = ending.set.clone();
    Ok(session.into_solution(ending))
}

/// The way to the solution that the parts of the problem ask for.
fn solve_by_kind(session: &mut Session, problem: &Frictional, start: Option<Start>) -> Ending {
    let Frictional {
        rhs,
        set,
        law,
        balance,
    } = *problem;
    if !law.is_empty() {
        return coulomb::solve::solve(session, problem, start);
    }
    let tolerance = session.settings.tolerance;
    let lambda = start.map(|start| start.lambda);
    let Some(balance) = balance else {
        return inner_solve::solve(session, &Inner::plain(rhs, set, tolerance), lambda);
    };
    let balanced = Balanced {
        rhs,
        set,
        law: None,
        balance,
        tolerance,
    };
    let alpha = start.map_or(&[][..], |start| start.multiplier);
    multiplier::solve(session, &balanced, lambda, &balance.coordinates(alpha))
}

/// λ = 0 when it solves the problem: P(ρ b) = 0 for one ρ is P(ρ b) = 0 for all, so no σmax is
/// needed to see it.
fn at_rest(problem: &DualProblem) -> Option<Ending> {
    let mut set: ProductSet = problem.set.clone();
    let nothing = vec![0.0; problem.coulomb().len()];
    problem.law.bound(&mut set, &nothing);
    let balanced = problem
        .balance
        .as_ref()
        .is_none_or(|b| b.load.iter().all(|&e| e == 0.0));
    let mut y = problem.rhs.clone();
    set.project(&mut y);
    if !balanced || y.iter().any(|&v| v != 0.0) {
        return None;
    }
    let mut ending = zero_ending(&problem.rhs, set);
    ending.multiplier = vec![0.0; problem.equality_rows()];
    Some(ending)
}

fn unit(mut motion: Vec<f64>) -> Vec<f64> {
    let length = norm(&motion);
    motion.iter_mut().for_each(|v| *v /= length);
    motion
}
