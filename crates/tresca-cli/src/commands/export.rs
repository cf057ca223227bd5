//! `tresca export`: the matrices of a case.

use miette::{Report, miette};
use tresca::algebraic::{Assembly, ExportError};
use tresca::case::Case;

use super::fclib;
use crate::args::ExportArguments;

pub fn run(arguments: &ExportArguments) -> miette::Result<u8> {
    if fclib::is_problem(&arguments.to) {
        return fclib::export(arguments);
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
