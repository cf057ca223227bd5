//! Problems of Siconos, which no one here posed, solved and measured as Siconos measures.

use std::path::PathBuf;

use tresca::fclib::{
    self, Document, Law, LocalProblem, Matrix, Outcome, Problem, ProblemError, Silent,
};
use tresca::{Settings, Status};

const FILES: [&str; 6] = [
    "FC2D_SliderCrankLagrangian00000.dat",
    "GFC3D_Example00.dat",
    "GFC3D_Example00_badly_scaled.dat",
    "Rover1039.dat",
    "Rover4516.dat",
    "problem-check2.dat",
];

fn document(name: &str) -> Document {
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tresca-io/tests/data/fclib");
    fclib::read(&data.join(name)).unwrap()
}

fn tight() -> Settings {
    Settings {
        tolerance: 1e-10,
        coulomb_tolerance: 1e-9,
        ..Settings::default()
    }
}

fn solve(problem: &Problem, law: Law) -> Outcome {
    fclib::solve(problem, law, &tight(), &mut Silent).unwrap()
}

#[test]
fn explore() {
    for name in FILES {
        for law in [Law::Coulomb, Law::Tresca { bound: 0.05 }] {
            let outcome = solve(&document(name).problem, law);
            println!(
                "{name} {law:?} {} it {} outer {} {:?} {:?}\n r {:?}\n u {:?}",
                outcome.solution.status, outcome.solution.iterations, outcome.solution.outer_iterations,
                outcome.residuals, outcome.matrix, outcome.forces, outcome.velocities
            );
        }
    }
}
