//! One solve from the outside: checks, the estimate of σmax, the method, the outcome.

use crate::error::check_vector;
use crate::methods::{self, Run};
use crate::{DualProblem, Observer, QcqpError, Settings, Solution, spectrum};

/// Solves the problem by the method of the settings.
///
/// `start` is projected onto Λ first; without one the methods start from 0.
/// The run is deterministic: the same input gives the same iterates.
///
/// # Errors
/// Only for wrong input: settings out of range, a start of the wrong length or
/// not finite, an operator that is zero, not symmetric, not positive
/// semidefinite or not finite. How a run ended stands in
/// [`Solution::status`].
pub fn solve(
    problem: &mut DualProblem,
    settings: &Settings,
    start: Option<&[f64]>,
    observer: &mut dyn Observer,
) -> Result<Solution, QcqpError> {
    settings.validate()?;
    if let Some(start) = start {
        check_vector("the start", start, problem.dim())?;
    }
    let (operator, rhs, set) = problem.parts();
    let n_a_before = *operator.counter();

    // P(0 + ρ b) = 0 for one ρ is P(0 + ρ b) = 0 for all: 0 solves the problem, no σmax needed.
    let mut y = rhs.to_vec();
    set.project(&mut y);
    if y.iter().all(|&v| v == 0.0) {
        return Ok(methods::zero_solution(settings, rhs, set));
    }

    let spectrum = spectrum::estimate(operator)?;
    let mut run = Run::new(
        operator, rhs, set, settings, &spectrum, n_a_before, observer,
    );
    let status = methods::run(&mut run, &spectrum, start);
    Ok(run.into_solution(status))
}
