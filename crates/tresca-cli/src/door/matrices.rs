//! Problems that come as matrices.

use std::path::{Path, PathBuf};

use miette::{IntoDiagnostic, Report, miette};
use tresca::Settings;
use tresca::algebraic::{self, AlgebraicError, FileError, MatrixProblem};

use super::finished::Finished;
use crate::terminal::monitor::Monitor;

/// Whether a path is that of matrices, not of a case.
pub fn is_problem(path: &Path) -> bool {
    path.is_dir() || path.extension().is_some_and(|extension| extension == "npz")
}

/// A problem from an archive or a folder.
pub struct Matrices {
    path: PathBuf,
    problem: MatrixProblem,
}

impl Matrices {
    pub fn load(path: &Path) -> miette::Result<Self> {
        let problem = algebraic::read(path).map_err(|error| match error {
            FileError::File(error) => Report::new(error),
            error => miette!("{error}"),
        })?;
        Ok(Self {
            path: path.to_owned(),
            problem,
        })
    }

    pub fn describe(&self) -> String {
        self.path.display().to_string()
    }

    pub fn solve(
        &self,
        settings: &Settings,
        monitor: &mut Monitor,
    ) -> miette::Result<Option<Finished<'_>>> {
        let solution = match algebraic::solve(&self.problem, settings, monitor) {
            Err(AlgebraicError::Stopped(_)) => return Ok(None),
            solution => solution.map_err(|error| miette!("`{}`: {error}", self.path.display()))?,
        };
        Ok(Some(Finished {
            status: solution.status,
            iterations: solution.figures.iterations,
            write: Box::new(move |destination, name| {
                let written = destination.write_matrices(name, &solution);
                written.into_diagnostic()
            }),
        }))
    }
}
