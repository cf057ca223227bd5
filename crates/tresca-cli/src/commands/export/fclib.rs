//! `tresca export --to problem.hdf5` or `.dat`: the contacts of a case, for the programs of the Siconos group.

use std::ops::ControlFlow;
use std::path::Path;

use miette::{IntoDiagnostic, Report, miette};
use tresca::case::Case;
use tresca::fclib::{self, Document};
use tresca::output::write_file;
use tresca::{Run, Silent};

use crate::args::ExportArguments;
use crate::commands::fclib::{is_hdf5, is_text};

pub fn run(arguments: &ExportArguments) -> miette::Result<u8> {
    let case = Case::load(&arguments.case)?;
    let settings = arguments.solver.over(case.settings())?;
    let located = |error| Report::new(case.locate(&error));
    let model = &case.model;
    let ControlFlow::Continue(mut prepared) =
        tresca::prepare(model, &settings, &mut Silent).map_err(located)?
    else {
        return Ok(crate::INTERRUPTED);
    };
    let Run::Finished(outcome) = prepared
        .solve(model, &settings, &mut Silent)
        .map_err(located)?
    else {
        return Ok(crate::INTERRUPTED);
    };
    let document = fclib::document(model, &mut prepared, &outcome).into_diagnostic()?;
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
