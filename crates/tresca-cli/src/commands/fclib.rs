//! `tresca solve` of a problem of FCLIB or Siconos, and `tresca export` to one.

use std::path::{Path, PathBuf};

use miette::{IntoDiagnostic, Report, miette};
use tresca::case::Case;
use tresca::fclib::{self, Document, Law, ProblemError, Summary};
use tresca::output::{Destination, write_file};
use tresca::{Settings, Silent, Status};

use super::solve::case_name;
use crate::args::{self, ExportArguments, SolveArguments};
use crate::interrupt::Interrupt;
use crate::terminal::format::seconds;
use crate::terminal::monitor::Monitor;

/// Whether a file is such a problem, by its extension.
pub fn is_problem(path: &Path) -> bool {
    is_hdf5(path) || is_text(path)
}

/// FCLIB.
fn is_hdf5(path: &Path) -> bool {
    ["hdf5", "h5"]
        .iter()
        .any(|known| has_extension(path, known))
}

/// The text of Siconos.
fn is_text(path: &Path) -> bool {
    has_extension(path, "dat")
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension()
        .is_some_and(|own| own.eq_ignore_ascii_case(extension))
}

pub fn run(arguments: &SolveArguments) -> miette::Result<u8> {
    let law = law(arguments)?;
    let document = fclib::read(&arguments.case)?;
    let settings = arguments.solver.over(&Settings::default())?;
    let name = case_name(&arguments.case)?;
    let directory = arguments
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from("out").join(name));
    // Found out now rather than after the solve.
    Destination::new(&directory).into_diagnostic()?;

    let problem = &document.problem;
    if !arguments.quiet {
        let title = document.info.title.as_deref().unwrap_or(name);
        println!("tresca {} · {title}", tresca::VERSION);
        println!(
            "{} contacts in {} dimensions",
            problem.contacts(),
            problem.dimension()
        );
    }
    if arguments.verbose {
        print!(
            "settings:\n{}",
            toml::to_string(&settings).into_diagnostic()?
        );
    }
    let mut monitor = Monitor::new(Interrupt::listen(), arguments.quiet, arguments.verbose);
    let outcome = fclib::solve(problem, law, &settings, &mut monitor);
    monitor.finish();
    let outcome = match outcome {
        Err(ProblemError::Stopped(stopped)) => return Ok(crate::interrupt::stopped(stopped)),
        outcome => outcome.into_diagnostic()?,
    };
    let summary =
        fclib::write(&directory, name, &document, &outcome, &settings).into_diagnostic()?;
    if !arguments.quiet {
        print(&summary, &directory);
    }
    Ok(match summary.status {
        Status::Converged => crate::SUCCESS,
        _ => crate::NOT_CONVERGED,
    })
}

fn law(arguments: &SolveArguments) -> miette::Result<Law> {
    match (arguments.law, arguments.bound) {
        (Some(args::Law::Tresca), Some(bound)) => Ok(Law::Tresca { bound }),
        (Some(args::Law::Tresca), None) => {
            Err(miette!("--law tresca needs the slip bound: --bound FORCE"))
        }
        (_, Some(_)) => Err(miette!("--bound is for --law tresca")),
        (_, None) => Ok(Law::Coulomb),
    }
}

fn print(summary: &Summary, directory: &Path) {
    println!();
    let (how, times) = (&summary.status, &summary.times);
    match how {
        Status::Converged => print!("converged: "),
        _ => print!("NOT CONVERGED ({how}): "),
    }
    println!(
        "{} in {} iterations, {} multiplications by W ({} of them for σmax)",
        summary.method, summary.figures.iterations, summary.figures.n_a, summary.figures.n_a_setup
    );
    if summary.figures.outer_iterations > 0 {
        println!(
            "Coulomb friction: {} updates of the slip bounds, the last changed them by {:.1e} \
             (tolerance {:.0e})",
            summary.figures.outer_iterations,
            summary.figures.outer_residual,
            summary.settings.coulomb_tolerance
        );
    }
    let states = &summary.states;
    println!(
        "contact: {} closed, {} open, {} stick, {} slip; objective {:.9e}",
        states.closed, states.open, states.stick, states.slip, summary.figures.objective
    );
    let residuals = &summary.residuals;
    println!("residual of the natural map, from r and u alone:");
    for (name, value) in [
        ("scaled", residuals.scaled),
        ("with symmetric W", residuals.symmetrised),
        ("as Siconos measures", residuals.siconos),
    ] {
        println!("    {name:<20} {value:>10.2e}");
    }
    if let Some(reference) = summary.reference {
        println!(
            "difference to the file's own solution: forces {:.1e}, velocities {:.1e}",
            reference.forces, reference.velocities
        );
    }
    for remark in &summary.remarks {
        println!("note: {remark}");
    }
    println!(
        "times: preparation {}, solve {}",
        seconds(times.preparation),
        seconds(times.solve)
    );
    println!("results in {}", directory.display());
}

/// Solves the case and writes the problem of its last load step, with the solution where the format has
/// a place for it.
pub fn export(arguments: &ExportArguments) -> miette::Result<u8> {
    if arguments.step.is_some() {
        return Err(miette!(
            "--step is not for FCLIB and Siconos: all steps are solved, and the last one is exported"
        ));
    }
    let case = Case::load(&arguments.case)?;
    let settings = case.settings();
    let located = |error| Report::new(tresca::case::locate(&case, &error));
    let mut prepared = tresca::prepare(&case.model, settings, &mut Silent).map_err(located)?;
    let outcome = prepared.solve(settings, &mut Silent).map_err(located)?;
    let document = fclib::document(&mut prepared, &outcome).into_diagnostic()?;
    write(&document, &arguments.to)?;
    println!(
        "{}: {} contacts in {} dimensions{}",
        arguments.to.display(),
        document.problem.contacts(),
        document.problem.dimension(),
        match (&document.solution, is_hdf5(&arguments.to)) {
            (Some(_), true) => ", with the solution",
            _ => "",
        }
    );
    Ok(crate::SUCCESS)
}

fn write(document: &Document, path: &Path) -> miette::Result<()> {
    if is_text(path) {
        return write_file(path, |out| document.write_dat(out)).into_diagnostic();
    }
    #[cfg(feature = "fclib")]
    return write_file(path, |out| document.write_hdf5(out)).into_diagnostic();
    #[cfg(not(feature = "fclib"))]
    Err(miette!(
        "this program was built without HDF5: build with `--features fclib`"
    ))
}
