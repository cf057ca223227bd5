//! `tresca solve`: a problem in, result files and a verdict out; the same for every door.

use std::path::PathBuf;

use miette::IntoDiagnostic;
use tresca::output::Destination;

use crate::args::{SolveArguments, run_name, use_threads};
use crate::door::Door;
use crate::interrupt::Interrupt;
use crate::terminal::{monitor::Monitor, verdict};

pub fn run(arguments: &SolveArguments) -> miette::Result<u8> {
    use_threads(arguments.threads)?;
    let interrupt = Interrupt::listen();
    let door = Door::load(arguments)?;
    let settings = arguments.solver.over(door.settings())?;
    let name = run_name(&arguments.case)?;
    let directory = match &arguments.out {
        Some(directory) => directory.clone(),
        None => PathBuf::from("out").join(&name),
    };
    let destination = Destination::new(&directory).into_diagnostic()?;

    if !arguments.quiet {
        println!("tresca {} · {}", tresca::VERSION, door.describe());
    }
    if arguments.verbose {
        print!(
            "settings:\n{}",
            toml::to_string(&settings).into_diagnostic()?
        );
    }
    let mut monitor = Monitor::new(interrupt, arguments.quiet, arguments.verbose);
    let solved = door.solve(&settings, &mut monitor);
    monitor.finish();
    let Some(solved) = solved? else {
        eprintln!("interrupted before the first iteration: nothing was written");
        return Ok(crate::INTERRUPTED);
    };
    let report = solved.write(destination, &name)?;
    if !arguments.quiet {
        verdict::print(&report, &directory);
    }
    Ok(if report.converged() {
        crate::SUCCESS
    } else {
        crate::NOT_CONVERGED
    })
}
