//! `tresca solve`: a case file (or matrices: see `matrices` and `fclib`) in, result files and a verdict out.

use std::path::Path;

use miette::{IntoDiagnostic, Report, miette};
use tresca::SolveError;
use tresca::case::Case;
use tresca::output::Destination;

use super::{fclib, matrices};
use crate::args::{SolveArguments, use_threads};
use crate::interrupt::Interrupt;
use crate::terminal::{monitor::Monitor, verdict};

pub fn run(arguments: &SolveArguments) -> miette::Result<u8> {
    use_threads(arguments.threads)?;
    if fclib::is_problem(&arguments.case) {
        return fclib::run(arguments);
    }
    if arguments.law.is_some() || arguments.bound.is_some() {
        return Err(miette!(
            "--law and --bound are for problems of FCLIB and Siconos; others have their own laws"
        ));
    }
    if matrices::is_problem(&arguments.case) {
        return matrices::run(arguments);
    }
    let case = Case::load(&arguments.case)?;
    let settings = arguments.solver.over(case.settings())?;
    let name = case_name(&arguments.case)?;
    let directory = match &arguments.out {
        Some(directory) => directory.clone(),
        None => Path::new("out").join(name),
    };
    let destination = Destination::new(&directory).into_diagnostic()?;

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
    let outcome = tresca::solve_with(&case.model, &settings, &mut monitor);
    monitor.finish();
    let outcome = match outcome {
        Err(SolveError::Stopped(stopped)) => return Ok(crate::interrupt::stopped(stopped)),
        outcome => outcome.map_err(|error| Report::new(tresca::case::locate(&case, &error)))?,
    };
    let summary = destination
        .write(name, &case.model, &outcome)
        .into_diagnostic()?;
    if !arguments.quiet {
        verdict::print(&summary, &directory);
    }
    Ok(if outcome.converged() {
        crate::SUCCESS
    } else {
        crate::NOT_CONVERGED
    })
}

/// The case file's name without its extension: results are called after it.
pub fn case_name(case: &Path) -> miette::Result<&str> {
    case.file_stem()
        .and_then(|stem| stem.to_str())
        .ok_or_else(|| miette!("`{}` is not the name of a case file", case.display()))
}
