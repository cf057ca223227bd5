//! `tresca solve`: a case file in, result files and a verdict out.

use std::path::{Path, PathBuf};

use miette::{IntoDiagnostic, Report, miette};
use tresca::case::Case;
use tresca::{Run, output};

use crate::args::{SolveArguments, use_threads};
use crate::interrupt::Interrupt;
use crate::terminal::{monitor::Monitor, verdict};

pub fn run(arguments: &SolveArguments) -> miette::Result<u8> {
    use_threads(arguments.threads)?;
    let case = Case::load(&arguments.case)?;
    let settings = arguments.solver.over(case.settings())?;
    let directory = match &arguments.out {
        Some(directory) => directory.clone(),
        None => default_directory(&arguments.case)?,
    };
    output::check_directory(&directory)?;

    if !arguments.quiet {
        println!("tresca {} · {}", tresca::VERSION, case.model.title());
    }
    if arguments.verbose {
        print!(
            "settings:\n{}",
            toml::to_string(&settings).into_diagnostic()?
        );
    }
    let mut monitor = Monitor::new(Interrupt::listen(), arguments.quiet, arguments.verbose);
    let run = tresca::solve(&case.model, &settings, &mut monitor)
        .map_err(|error| Report::new(case.locate(&error)))?;
    monitor.finish();
    let outcome = match run {
        Run::Finished(outcome) => outcome,
        Run::Stopped(stage) => {
            eprintln!(
                "interrupted before the first iteration (at: {stage:?}); nothing was written"
            );
            return Ok(crate::INTERRUPTED);
        }
    };
    let summary = output::write(&case.model, &outcome, &directory)?;
    if !arguments.quiet {
        verdict::print(&summary, &directory);
    }
    Ok(if outcome.converged() {
        crate::SUCCESS
    } else {
        crate::NOT_CONVERGED
    })
}

/// `out/<case name>`.
fn default_directory(case: &Path) -> miette::Result<PathBuf> {
    let stem = case
        .file_stem()
        .ok_or_else(|| miette!("`{}` is not the name of a case file", case.display()))?;
    Ok(Path::new("out").join(stem))
}
