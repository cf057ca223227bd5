//! `tresca bench coulomb`: what Coulomb's law costs beside Tresca's on the two bricks.

use miette::IntoDiagnostic;
use tresca_bench::coulomb::Comparison;
use tresca_bench::table1::Counts;

use crate::args::{CoulombArguments, use_threads};

pub fn run(arguments: &CoulombArguments) -> miette::Result<bool> {
    use_threads(arguments.threads)?;
    println!(
        "Two bricks, Coulomb friction, condensed engine, GRSSN from a zero start, tolerance {:.0e}.",
        arguments.tolerance
    );
    println!(
        "n_A counts all multiplications by A but those for the estimate of σmax. Tresca: the same"
    );
    println!("problem with the final bounds frozen. difference: ‖λ − λ'‖/‖λ‖ of the two variants.");
    let mut all_converged = true;
    for &s in &arguments.sizes {
        println!(
            "\ns = {s}\n{:>6} {:>10} {:>24} {:>26} {:>12}",
            "F", "Tresca", "fixed point", "in loop", "difference"
        );
        println!(
            "{:>6} {:>10} {:>24} {:>26}",
            "", "n_A", "updates / steps / n_A", "steps / n_A (ratio)"
        );
        for &coefficient in &arguments.coefficients {
            let comparison =
                Comparison::run(s, coefficient, arguments.tolerance).into_diagnostic()?;
            all_converged &= print_row(coefficient, &comparison);
        }
    }
    Ok(all_converged)
}

fn print_row(coefficient: f64, comparison: &Comparison) -> bool {
    let [frozen, fixed_point, in_loop] = comparison.outcomes().map(Counts::of);
    let remark: Vec<String> = comparison
        .outcomes()
        .iter()
        .filter(|outcome| !outcome.converged())
        .map(|outcome| outcome.status().to_string())
        .collect();
    println!(
        "{coefficient:>6} {:>10} {:>24} {:>26} {:>12.1e}  {}",
        frozen.multiplications,
        format!(
            "{} / {} / {}",
            comparison.updates(),
            fixed_point.iterations,
            fixed_point.multiplications
        ),
        format!(
            "{} / {} ({:.2})",
            in_loop.iterations,
            in_loop.multiplications,
            comparison.ratio()
        ),
        comparison.difference(),
        remark.join(", ")
    );
    remark.is_empty()
}
