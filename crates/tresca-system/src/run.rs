//! One solve of a dual problem that is posed: the same for every door.

use std::time::Instant;

use tresca_qcqp::{DualProblem, DualSolution, IterationRecord, QcqpError, Settings, Start};

use crate::description::Times;
use crate::progress::{Progress, Stage, Stopped, begin};

/// Why a problem that is posed was not solved.
#[derive(Debug, thiserror::Error)]
pub enum Unsolved {
    /// The caller stopped the run.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The settings or figures are impossible.
    #[error(transparent)]
    Refused(#[from] QcqpError),
}

/// Solves; `times` gets what it took.
pub(crate) fn solve(
    dual: &mut DualProblem<'_>,
    start: Option<Start<'_>>,
    settings: &Settings,
    times: &mut Times,
    progress: &mut dyn Progress,
) -> Result<DualSolution, Unsolved> {
    begin(progress, Stage::Solve)?;
    let clock = Instant::now();
    let mut observer = |record: &IterationRecord| progress.iteration(record);
    let solution = tresca_qcqp::solve(dual, settings, start, &mut observer)?;
    times.solve += clock.elapsed().as_secs_f64();
    times.multiplications += solution.figures.seconds_in_products;
    // From here on the result exists; an interruption must not lose it.
    let _ = progress.stage(Stage::Recovery);
    Ok(solution)
}
