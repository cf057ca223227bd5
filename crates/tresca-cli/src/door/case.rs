//! Case files.

use std::path::Path;

use miette::{IntoDiagnostic, Report};
use tresca::{Settings, SolveError};

use super::finished::Finished;
use crate::terminal::monitor::Monitor;

/// A case file, read and checked.
pub struct Case(tresca::case::Case);

impl Case {
    pub fn load(path: &Path) -> miette::Result<Self> {
        Ok(Self(tresca::case::Case::load(path)?))
    }

    pub fn settings(&self) -> &Settings {
        self.0.settings()
    }

    pub fn describe(&self) -> String {
        self.0.model.title().to_owned()
    }

    pub fn solve(
        &self,
        settings: &Settings,
        monitor: &mut Monitor,
    ) -> miette::Result<Option<Finished<'_>>> {
        let model = &self.0.model;
        let outcome = match tresca::solve_with(model, settings, monitor) {
            Err(SolveError::Stopped(_)) => return Ok(None),
            outcome => {
                outcome.map_err(|error| Report::new(tresca::case::locate(&self.0, &error)))?
            }
        };
        let steps = outcome.steps.iter();
        let iterations = steps.map(|step| step.solution.figures.iterations);
        Ok(Some(Finished {
            status: outcome.status(),
            iterations: iterations.sum(),
            write: Box::new(move |destination, name| {
                destination.write(name, model, &outcome).into_diagnostic()
            }),
        }))
    }
}
