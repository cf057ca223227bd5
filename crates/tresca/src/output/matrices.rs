//! The result files of a problem that came as matrices.

use std::io::Write;
use std::time::Instant;

use tresca_io::atomic::OutputSet;
use tresca_io::problem::Archive;
use tresca_io::{WriteError, summary};

use super::{Destination, SUMMARY, history};
use crate::algebraic::Solution;
use crate::report::run::RunReport;

impl Destination {
    /// Writes `solution.npz`, `history.csv` and `summary.json`: all of them, or none. `name` is what the run is
    /// called.
    ///
    /// # Errors
    /// When a file cannot be written, or a result is not a finite number.
    pub fn write_matrices(self, name: &str, solution: &Solution) -> Result<RunReport, WriteError> {
        let begin = Instant::now();
        let mut files = OutputSet::new(self.directory)?;
        files.stage("solution.npz", |out| archive(solution, out))?;
        files.stage("history.csv", |out| {
            history::write([(1, &solution.records[..])], out)
        })?;
        let report = RunReport::of_matrices(solution)
            .named(name)
            .with_output(begin.elapsed().as_secs_f64());
        files.stage(SUMMARY, |out| summary::write(out, &report))?;
        files.commit()?;
        Ok(report)
    }
}

fn archive(solution: &Solution, out: &mut dyn Write) -> Result<(), WriteError> {
    let mut archive = Archive::in_memory();
    let mut vector = |name: &str, values: &[f64]| archive.numbers(name, &[values.len()], values);
    if !solution.displacement.is_empty() {
        vector("u", &solution.displacement)?;
    }
    vector("normal_force", &solution.normal_force)?;
    vector("tangential_force", &solution.tangential_force)?;
    vector("gap", &solution.gap)?;
    vector("slip", &solution.slip)?;
    if let Some(motion) = &solution.unresisted_motion {
        vector("unresisted_motion", motion)?;
    }
    archive.flags("closed", &solution.closed)?;
    archive.flags("stick", &solution.stick)?;
    archive.finish_to(out)
}
