//! `tresca bench coulomb`: what Coulomb's law costs beside Tresca's on the two bricks.

use miette::{IntoDiagnostic, miette};
use tresca::two_bricks::{Units, two_bricks_with};
use tresca::{
    CoulombMethod, FrictionLaw, Model, Outcome, PairState, Run, ScalarField, Settings, Silent,
};

use crate::args::{CoulombArguments, use_threads};

pub fn run(arguments: &CoulombArguments) -> miette::Result<u8> {
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
            all_converged &= row(s, coefficient, arguments)?;
        }
    }
    Ok(if all_converged {
        crate::SUCCESS
    } else {
        crate::NOT_CONVERGED
    })
}

fn row(s: usize, coefficient: f64, arguments: &CoulombArguments) -> miette::Result<bool> {
    let bricks = |law| two_bricks_with(s, Units::METRE_MEGAPASCAL, law).into_diagnostic();
    let settings = |coulomb| Settings {
        coulomb,
        tolerance: arguments.tolerance,
        engine: tresca::Engine::Condensed,
        ..Settings::default()
    };
    let model = bricks(FrictionLaw::coulomb(coefficient))?;
    let fixed_point = solve(&model, &settings(CoulombMethod::FixedPoint))?;
    let in_loop = solve(&model, &settings(CoulombMethod::InLoop))?;
    let bound = |pair: &PairState| pair.slip_bounds.map_or(0.0, |[a, _]| a) / pair.pair.area;
    let bounds = fixed_point.last().pairs().map(bound).collect();
    let frozen = bricks(FrictionLaw::tresca(ScalarField::Values(bounds)))?;
    let tresca = solve(&frozen, &settings(CoulombMethod::FixedPoint))?;

    let work = |outcome: &Outcome| {
        let solution = &outcome.last().solution;
        (solution.iterations, solution.n_a - solution.n_a_setup)
    };
    let (_, n_tresca) = work(&tresca);
    let (steps, n_a) = work(&fixed_point);
    let updates = fixed_point.last().solution.outer_iterations;
    let (loop_steps, loop_n_a) = work(&in_loop);
    let outcomes = [&tresca, &fixed_point, &in_loop];
    let remark: Vec<String> = outcomes
        .iter()
        .filter(|outcome| !outcome.converged())
        .map(|outcome| outcome.status().to_string())
        .collect();
    println!(
        "{coefficient:>6} {n_tresca:>10} {:>24} {:>26} {:>12.1e}  {}",
        format!("{updates} / {steps} / {n_a}"),
        format!(
            "{loop_steps} / {loop_n_a} ({:.2})",
            loop_n_a as f64 / n_tresca as f64
        ),
        difference(&in_loop, &fixed_point),
        remark.join(", ")
    );
    Ok(remark.is_empty())
}

fn solve(model: &Model, settings: &Settings) -> miette::Result<Outcome> {
    match tresca::solve(model, settings, &mut Silent).into_diagnostic()? {
        Run::Finished(outcome) => Ok(*outcome),
        Run::Stopped(_) => Err(miette!("interrupted")),
    }
}

fn difference(a: &Outcome, b: &Outcome) -> f64 {
    let (a, b) = (&a.last().solution.lambda, &b.last().solution.lambda);
    let norm = |squares: &mut dyn Iterator<Item = f64>| squares.sum::<f64>().sqrt();
    norm(&mut a.iter().zip(b).map(|(a, b)| (a - b).powi(2))) / norm(&mut b.iter().map(|b| b * b))
}
