//! `tresca solve` for a problem that comes as matrices.

use std::path::Path;

use miette::{IntoDiagnostic, Report, miette};
use tresca::Settings;
use tresca::algebraic::{self, AlgebraicError, FileError};
use tresca::output::Destination;

use crate::args::SolveArguments;
use crate::interrupt::Interrupt;
use crate::terminal::{matrices, monitor::Monitor};

/// Whether a path is that of matrices, not of a case.
pub fn is_problem(path: &Path) -> bool {
    path.is_dir() || path.extension().is_some_and(|extension| extension == "npz")
}

pub fn run(arguments: &SolveArguments) -> miette::Result<u8> {
    let path = &arguments.case;
    let settings = arguments.solver.over(&Settings::default())?;
    let name = path
        .canonicalize()
        .ok()
        .and_then(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .ok_or_else(|| miette!("cannot read `{}`", path.display()))?;
    let directory = match &arguments.out {
        Some(directory) => directory.clone(),
        None => Path::new("out").join(&name),
    };
    let destination = Destination::new(&directory).into_diagnostic()?;
    let problem = algebraic::read(path).map_err(|error| match error {
        FileError::File(error) => Report::new(error),
        error => miette!("{error}"),
    })?;

    if !arguments.quiet {
        println!("tresca {} · {}", tresca::VERSION, path.display());
    }
    if arguments.verbose {
        print!(
            "settings:\n{}",
            toml::to_string(&settings).into_diagnostic()?
        );
    }
    let mut monitor = Monitor::new(Interrupt::listen(), arguments.quiet, arguments.verbose);
    let solution = algebraic::solve(&problem, &settings, &mut monitor);
    monitor.finish();
    let solution = match solution {
        Err(AlgebraicError::Stopped(stopped)) => return Ok(crate::interrupt::stopped(stopped)),
        solution => solution.map_err(|error| miette!("`{}`: {error}", path.display()))?,
    };
    let summary = algebraic::write(&solution, &name, destination).into_diagnostic()?;
    if !arguments.quiet {
        matrices::print(&summary, &directory);
    }
    Ok(if solution.converged() {
        crate::SUCCESS
    } else {
        crate::NOT_CONVERGED
    })
}
