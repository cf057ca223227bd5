//! `tresca bench case`: what a case costs beside one linear solve of its bodies.

use std::path::Path;

use miette::{IntoDiagnostic, Report};
use tresca::Status;
use tresca::case::Case;
use tresca_bench::BenchError;
use tresca_bench::trial::{Trial, Watch};

use super::print_cost;
use crate::args::{CaseArguments, run_name, use_threads};
use crate::terminal::format::{grouped, seconds};

pub fn run(arguments: &CaseArguments) -> miette::Result<bool> {
    use_threads(arguments.threads)?;
    let mut all_converged = true;
    for path in &arguments.cases {
        all_converged &= run_case(path, arguments)?;
    }
    Ok(all_converged)
}

fn run_case(path: &Path, arguments: &CaseArguments) -> miette::Result<bool> {
    let name = run_name(path)?;
    let watch = Watch::start();
    let case = Case::load(path)?;
    let reading = watch.seconds();
    let settings = arguments.solver.over(case.settings().clone())?;
    let trial = Trial::run(watch, &name, &case.model, &settings).or_else(|error| match error {
        BenchError::Model(error) => Err(Report::new(tresca::case::locate(&case, &error))),
        other => Err(other).into_diagnostic(),
    })?;
    let description = trial.description();
    println!(
        "\n{}: {} dofs, {} pairs, engine {}",
        path.display(),
        grouped(description.dofs),
        grouped(description.pairs),
        description.engine.engine
    );
    let outcome = trial.first();
    for step in &outcome.steps {
        let solution = &step.solution;
        println!(
            "    step {}: {} {:.0e}: {} / {} [σmax: {}] iterations / n_A, {}",
            step.number,
            solution.method,
            settings.tolerance,
            solution.figures.iterations,
            solution.figures.n_a - solution.figures.n_a_setup,
            solution.figures.n_a_setup,
            solution.status
        );
    }
    let contact = outcome.times.contact;
    println!(
        "    reading {}, contact search and coupling {}: {:.1} % of the whole",
        seconds(reading),
        seconds(contact),
        100.0 * (reading + contact) / trial.seconds()
    );
    let converged = outcome.status() == Status::Converged;
    print_cost(&trial.cost().into_diagnostic()?);
    Ok(converged)
}
