//! A model solved as a case, and its matrices solved as matrices, must give the same.

use tresca::algebraic::{self, Assembly};
use tresca::{Engine, Model, Settings, Silent};
use tresca_bench::two_bricks::{Units, two_bricks};

use super::common::assert_close;

/// λ of the only step of a model.
fn forces(model: &Model, settings: &Settings) -> Vec<f64> {
    let outcome = tresca::solve_with(model, settings, &mut Silent).unwrap();
    assert!(outcome.converged(), "{}", outcome.status());
    let step = outcome.last();
    let tangential = step.pairs().flat_map(|pair| pair.local_friction);
    let tangential = tangential
        .enumerate()
        .filter(|(i, _)| model.dimension() == 3 || i % 2 == 0);
    let normal = step.pairs().map(|pair| pair.normal_force);
    normal.chain(tangential.map(|(_, force)| force)).collect()
}

fn tight() -> Settings {
    Settings {
        tolerance: 1e-12,
        ..Settings::default()
    }
}

#[test]
fn two_bricks_are_the_same_by_every_engine() {
    let model = two_bricks(8, Units::METRE_MEGAPASCAL).unwrap();
    let mut problem = Assembly::new(&model, &model.whole_step()).unwrap().problem;
    let expected = forces(&model, &tight());
    let points = problem.points.take();
    for engine in [
        Engine::Auto,
        Engine::Factored,
        Engine::Condensed,
        Engine::Explicit,
    ] {
        let counts = [points.clone(), None].map(|points| {
            problem.points = points;
            let settings = Settings { engine, ..tight() };
            let solution = algebraic::solve(&problem, &settings, &mut Silent).unwrap();
            assert!(solution.converged(), "{engine}: {}", solution.status);
            let lambda = [&solution.normal_force[..], &solution.tangential_force].concat();
            assert_close(&lambda, &expected, 1e-9, "λ");
            assert!(
                solution.certificate.worst() < 1e-8,
                "{:?}",
                solution.certificate
            );
            solution.figures.n_a
        });
        // Patches by the graph of K are about as good as those by the places of the pairs.
        assert!(4 * counts[1] <= 5 * counts[0], "{engine}: {counts:?}");
    }
}

/// Every case with one load step, whatever its law, dimension and supports.
#[test]
fn every_case_gives_the_same_forces_as_matrices() {
    let directory = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let mut solved = 0;
    for entry in std::fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let case = tresca::case::Case::load(&path).unwrap();
        if case.model.steps().len() > 1 {
            continue;
        }
        let step = case
            .model
            .steps()
            .first()
            .cloned()
            .unwrap_or_else(|| case.model.whole_step());
        let problem = Assembly::new(&case.model, &step).unwrap().problem;
        let settings = Settings {
            tolerance: 1e-11,
            coulomb_tolerance: 1e-11,
            max_outer_iterations: 200,
            ..case.settings().clone()
        };
        let solution = algebraic::solve(&problem, &settings, &mut Silent).unwrap();
        let outcome = tresca::solve_with(&case.model, &settings, &mut Silent).unwrap();
        assert_eq!(solution.status, outcome.status(), "{}", path.display());
        if !solution.converged() {
            continue;
        }
        let lambda = [&solution.normal_force[..], &solution.tangential_force].concat();
        // The forces that glue a slender beam feel the condition of A.
        let expected = forces(&case.model, &settings);
        assert_close(&lambda, &expected, 1e-7, &path.display().to_string());
        let worst = solution.certificate.worst();
        assert!(
            worst < 1e-7,
            "{}: {:#?}",
            path.display(),
            solution.certificate
        );
        solved += 1;
    }
    assert!(solved > 8, "{solved} cases");
}
