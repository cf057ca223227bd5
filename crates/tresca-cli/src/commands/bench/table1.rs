//! `tresca bench table1`: the published table of the two bricks beside ours.

use miette::IntoDiagnostic;
use tresca::{Method, Status};
use tresca_bench::table1::{Counts, Plan, Row};
use tresca_bench::two_bricks::{Units, two_bricks};

use super::print_cost;
use crate::args::{Table1Arguments, use_threads};
use crate::terminal::format::{grouped, seconds};

pub fn run(arguments: &Table1Arguments) -> miette::Result<bool> {
    use_threads(arguments.threads)?;
    let plan = Plan {
        tolerances: arguments.tolerance.clone(),
        paper_tolerance: arguments.paper_tolerance,
        engine: arguments.engine,
        grssn_only: arguments.grssn_only,
    };
    print_legend(&plan);
    let mut all_converged = true;
    for &s in &arguments.sizes {
        all_converged &= run_size(s, &plan)?;
    }
    Ok(all_converged)
}

fn print_legend(plan: &Plan) {
    let imssn = plan.paper_settings(Method::Imssn);
    let ssn = plan.paper_settings(Method::Ssn);
    println!("Two bricks, Tresca friction. Every figure is `iterations / n_A`; n_A counts all");
    println!(
        "multiplications by A but those for the estimate of σmax, which stand apart in brackets."
    );
    println!(
        "IMSSN: tolerance {:.0e}, ρ = {}/σmax, r_tol = {}, c_fact = {}.",
        imssn.tolerance, imssn.rho, imssn.r_tol, imssn.c_fact
    );
    println!(
        "SSN: tolerance {:.0e}, ρ = {}/σmax, BiCGSTAB to {:.0e}.",
        ssn.tolerance,
        ssn.rho,
        ssn.inner_tolerance * ssn.tolerance
    );
    println!("The paper does not state its settings; see docs/reproduction.md.");
}

fn run_size(s: usize, plan: &Plan) -> miette::Result<bool> {
    let model = two_bricks(s, Units::METRE_MEGAPASCAL).into_diagnostic()?;
    let mut trial = plan.trial(&model).into_diagnostic()?;
    let description = trial.description();
    println!(
        "\ns = {s}: {} dofs, {} pairs, engine {}",
        grouped(description.dofs),
        grouped(description.pairs),
        description.engine.engine
    );
    println!(
        "    {:<22} {:>16} {:>12} {:>10}",
        "method", "iter / n_A", "published", "time"
    );
    let mut converged = true;
    for row in plan.rows(s, &mut trial) {
        converged &= print_row(&row.into_diagnostic()?);
    }
    print_cost(&trial.cost().into_diagnostic()?);
    Ok(converged)
}

fn print_row(row: &Row) -> bool {
    let pair = |counts: Counts| format!("{} / {}", counts.iterations, counts.multiplications);
    let converged = row.status == Status::Converged;
    let remark = if converged {
        String::new()
    } else {
        format!("  {}", row.status)
    };
    println!(
        "    {:<22} {:>16} {:>12} {:>10}  [σmax: {}]{remark}",
        format!("{} {:.0e}", row.method, row.tolerance),
        pair(row.counts),
        row.published.map_or(String::new(), pair),
        seconds(row.seconds),
        row.setup
    );
    converged
}
