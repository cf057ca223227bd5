//! Problems of FCLIB and Siconos.

use std::path::Path;

use miette::{IntoDiagnostic, miette};
use tresca::Settings;
use tresca::fclib::{self, Document, FclibLaw, FclibProblemError};

use super::finished::Finished;
use crate::args::{FclibLawArg, SolveArguments, run_name};
use crate::terminal::monitor::Monitor;

/// Whether a file is such a problem, by its extension.
pub fn is_problem(path: &Path) -> bool {
    is_hdf5(path) || is_text(path)
}

/// FCLIB.
pub fn is_hdf5(path: &Path) -> bool {
    ["hdf5", "h5"]
        .iter()
        .any(|known| has_extension(path, known))
}

/// The text of Siconos.
pub fn is_text(path: &Path) -> bool {
    has_extension(path, "dat")
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension()
        .is_some_and(|own| own.eq_ignore_ascii_case(extension))
}

/// A problem and the law it is solved with.
pub struct Fclib {
    document: Document,
    law: FclibLaw,
    /// Its title, or the name of its file.
    title: String,
}

impl Fclib {
    pub fn load(arguments: &SolveArguments) -> miette::Result<Self> {
        let law = law(arguments)?;
        let document = fclib::read(&arguments.case)?;
        let title = match &document.info.title {
            Some(title) => title.clone(),
            None => run_name(&arguments.case)?,
        };
        Ok(Self {
            document,
            law,
            title,
        })
    }

    pub fn describe(&self) -> String {
        let problem = &self.document.problem;
        format!(
            "{}\n{} contacts in {} dimensions",
            self.title,
            problem.contacts(),
            problem.dimension()
        )
    }

    pub fn solve(
        &self,
        settings: &Settings,
        monitor: &mut Monitor,
    ) -> miette::Result<Option<Finished<'_>>> {
        let problem = &self.document.problem;
        let outcome = match fclib::solve(problem, self.law, settings, monitor) {
            Err(FclibProblemError::Stopped(_)) => return Ok(None),
            outcome => outcome.into_diagnostic()?,
        };
        let settings = settings.clone();
        Ok(Some(Finished {
            status: outcome.solution.status,
            iterations: outcome.solution.figures.iterations,
            write: Box::new(move |destination, name| {
                let written = destination.write_fclib(name, &self.document, &outcome, &settings);
                written.into_diagnostic()
            }),
        }))
    }
}

fn law(arguments: &SolveArguments) -> miette::Result<FclibLaw> {
    match (arguments.law, arguments.bound) {
        (Some(FclibLawArg::Tresca), Some(bound)) => Ok(FclibLaw::Tresca { bound }),
        (Some(FclibLawArg::Tresca), None) => {
            Err(miette!("--law tresca needs the slip bound: --bound FORCE"))
        }
        (_, Some(_)) => Err(miette!("--bound is for --law tresca")),
        (_, None) => Ok(FclibLaw::Coulomb),
    }
}
