//! `tresca export`: the matrices of a case, or its last load step as a problem of FCLIB or Siconos.

use std::path::Path;

use miette::{IntoDiagnostic, Report, miette};
use tresca::Silent;
use tresca::algebraic::{Assembly, ExportError};
use tresca::case::Case;
use tresca::fclib::{self, Document};
use tresca::output::write_file;

use crate::args::ExportArguments;
use crate::door::fclib::{is_hdf5, is_problem, is_text};

pub fn run(arguments: &ExportArguments) -> miette::Result<u8> {
    if is_problem(&arguments.to) {
        return export_fclib(arguments);
    }
    let case = Case::load(&arguments.case)?;
    let steps = case.model.steps();
    let step = match (arguments.step, steps) {
        (None, []) => case.model.whole_step(),
        (None, [only]) => only.clone(),
        (None, steps) => {
            return Err(miette!(
                "the case has {} load steps: say which one to export, by --step 1 to --step {}",
                steps.len(),
                steps.len()
            ));
        }
        (Some(number), steps) => steps.get(number.get() - 1).cloned().ok_or_else(|| {
            miette!(
                "there is no load step {number}: the case has {}",
                steps.len()
            )
        })?,
    };
    let assembly = Assembly::new(&case.model, &step)
        .map_err(|error| Report::new(tresca::case::locate(&case, &error)))?;
    assembly.write(&arguments.to).map_err(|error| match error {
        ExportError::Model(error) => Report::new(tresca::case::locate(&case, &error)),
        error => Report::msg(error),
    })?;
    let problem = &assembly.problem;
    println!(
        "{} blocks of K, {} dofs, {} contact pairs, {} tangent(s) each, written to {}",
        problem.stiffness.len(),
        problem.dofs(),
        problem.pairs(),
        problem.tangents(),
        arguments.to.display()
    );
    Ok(crate::SUCCESS)
}

/// Solves the case and writes the problem of its last load step, with the solution where the format has
/// a place for it.
fn export_fclib(arguments: &ExportArguments) -> miette::Result<u8> {
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
