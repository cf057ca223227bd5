//! `tresca bench case`: what a case costs beside one linear solve of its bodies.

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

use miette::{IntoDiagnostic, Report, miette};
use tresca::case::Case;
use tresca::linear::linear_solve;
use tresca::output::Destination;
use tresca::{Prepared, Silent, Status, memory};

use super::table1::{again, print_cost};
use crate::args::{CaseArguments, run_name, use_threads};
use crate::terminal::format::{grouped, seconds};

pub fn run(arguments: &CaseArguments) -> miette::Result<u8> {
    use_threads(arguments.threads)?;
    let mut all_converged = true;
    for path in &arguments.cases {
        all_converged &= run_case(path, arguments)?;
    }
    Ok(if all_converged {
        crate::SUCCESS
    } else {
        crate::NOT_CONVERGED
    })
}

fn run_case(path: &Path, arguments: &CaseArguments) -> miette::Result<bool> {
    let name = run_name(path)?;
    memory::reset_peak();
    let begin = Instant::now();
    let case = Case::load(path)?;
    let reading = begin.elapsed().as_secs_f64();
    let settings = arguments.solver.over(case.settings().clone())?;
    let located = |error: tresca::SolveError| Report::new(tresca::case::locate(&case, &error));
    let model = &case.model;
    let ControlFlow::Continue(mut prepared) =
        tresca::prepare(model, &settings, &mut Silent).map_err(located)?
    else {
        return Err(miette!("interrupted"));
    };
    let outcome = again(&mut prepared, model, &settings)?;
    let directory = tempfile::tempdir().into_diagnostic()?;
    Destination::new(directory.path())
        .and_then(|destination| destination.write(&name, model, &outcome))
        .into_diagnostic()?;
    let whole = begin.elapsed().as_secs_f64();
    let peak = memory::peak_bytes();

    println!(
        "\n{}: {} dofs, {} pairs, engine {}",
        path.display(),
        grouped(prepared.description.dofs),
        grouped(prepared.description.pairs),
        prepared.description.engine.engine
    );
    for step in &outcome.steps {
        let solution = &step.solution;
        println!(
            "    step {}: {} {:.0e}: {} / {} [σmax: {}] iterations / n_A, {}",
            step.number,
            solution.method,
            settings.tolerance,
            solution.iterations,
            solution.n_a - solution.n_a_setup,
            solution.n_a_setup,
            solution.status
        );
    }
    let contact = outcome.times.contact;
    println!(
        "    reading {}, contact search and coupling {}: {:.1} % of the whole",
        seconds(reading),
        seconds(contact),
        100.0 * (reading + contact) / whole
    );
    let Prepared {
        assembled,
        factored,
        dual,
        ..
    } = prepared;
    // Two sets of factors at a time are none of the contact solve's memory.
    drop((factored, dual));
    let linear = linear_solve(model, &assembled).into_diagnostic()?;
    print_cost(&outcome, whole, &linear, peak);
    Ok(outcome.status() == Status::Converged)
}
