//! Matrices of one's own: a mass between springs above a rough wall, pushed and then dragged.
//!
//! `cargo run --release -p tresca --example matrices`
#![allow(clippy::print_stdout, reason = "an example shows what it finds")]

use tresca::algebraic::{Matrix, MatrixProblem, PairLaw, prepare};
use tresca::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Springs of 1 N/m along the normal and 2 N/m along the tangent; the wall is 0.5 m away, friction 0.2.
    let k = Matrix::from_dense((2, 2), &[1.0, 0.0, 0.0, 2.0])?;
    let n = Matrix::from_dense((1, 2), &[1.0, 0.0])?;
    let t = Matrix::from_dense((1, 2), &[0.0, 1.0])?;
    let problem = MatrixProblem::new(k, n, vec![2.0, 0.0])
        .with_tangential(t)
        .with_gap(vec![0.5])
        .with_friction(PairLaw::coulomb(0.2));

    // Checked and factored once; loads, gaps and bounds may change from solve to solve.
    let settings = Settings::default();
    let mut prepared = prepare(&problem, &settings, &mut Silent)?;
    let mut conditions = problem.conditions.clone();
    let mut slips = Vec::new();
    for drag in [0.0, 0.2, 0.6, 1.0] {
        conditions.load = vec![2.0, drag];
        let solution = prepared.solve(&conditions, &settings, &mut Silent)?;
        assert!(solution.converged());
        println!(
            "drag {drag:.1} N: wall {:.2} N, friction {:.2} N, slip {:.3} m, {}",
            solution.normal_force[0],
            solution.tangential_force[0],
            solution.slip[0],
            if solution.stick[0] { "sticks" } else { "slips" }
        );
        slips.push(solution.slip[0]);
        // Friction counts slip from the step before.
        conditions.previous_slip = Some(solution.slip.clone());
        conditions.start = Some(solution.forces());
    }
    // The wall takes 2 − 0.5 N, friction a fifth of it; the rest stretches the spring.
    assert!((slips[3] - (1.0 - 0.3) / 2.0).abs() < 1e-6);
    Ok(())
}
