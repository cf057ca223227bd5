//! More than one solve on one factorisation; starts; interruption.

use tresca::algebraic::{Friction, PairLaw, prepare, solve};
use tresca::{Method, Settings, Silent};

use super::common::*;

#[test]
fn other_loads_gaps_and_bounds_on_the_same_factors() {
    for kernel in [0, 3] {
        let problem = random(Laws::Tresca, 2, kernel, 2);
        let mut prepared = prepare(&problem, &tight(), &mut Silent).unwrap();
        for seed in [4, 6, 8] {
            let mut other = random(Laws::Tresca, 2, kernel, seed);
            // The load of another problem need not have an equilibrium here; a scaled one has.
            other.conditions.load = problem
                .conditions
                .load
                .iter()
                .map(|f| f * (0.7 + 0.02 * seed as f64))
                .collect();
            if kernel > 0 {
                other.conditions.friction = problem.conditions.friction.clone();
            }
            let mut whole = problem.clone();
            whole.conditions = other.conditions.clone();
            let expected = solved(&whole, &tight());
            let found = prepared
                .solve(&other.conditions, &tight(), &mut Silent)
                .unwrap();
            assert_close(&found.displacement, &expected.displacement, 1e-9, "u");
            assert_close(&found.normal_force, &expected.normal_force, 1e-9, "λν");
        }
        let mut changed = problem.conditions.clone();
        changed.friction = PairLaw::Tied.into();
        let error = prepared.solve(&changed, &tight(), &mut Silent).unwrap_err();
        assert!(error.to_string().contains("another kind"), "{error}");
    }
}

#[test]
fn coulomb_coefficients_may_change() {
    let problem = random(Laws::Coulomb, 2, 0, 2);
    let mut prepared = prepare(&problem, &tight(), &mut Silent).unwrap();
    for coefficient in [0.0, 0.1, 0.5] {
        let whole = problem.clone().with_friction(PairLaw::coulomb(coefficient));
        let expected = solved(&whole, &tight());
        let found = prepared
            .solve(&whole.conditions, &tight(), &mut Silent)
            .unwrap();
        assert_close(
            &found.tangential_force,
            &expected.tangential_force,
            1e-8,
            "λτ",
        );
    }
}

#[test]
fn a_start_at_the_solution_ends_at_once() {
    for laws in [Laws::Tresca, Laws::Orthotropic, Laws::Mixed, Laws::Coulomb] {
        for kernel in [0, 3] {
            let problem = random(laws, 2, kernel, 2);
            let first = solved(&problem, &tight());
            let settings = Settings {
                tolerance: 1e-8,
                coulomb_tolerance: 1e-6,
                ..tight()
            };
            let run = |problem| solve(problem, &settings, &mut Silent).unwrap();
            let cold = run(&problem);
            let warm = run(&problem.clone().with_start(first.forces()));
            assert!(cold.converged() && warm.converged());
            assert!(
                warm.figures.iterations <= 2,
                "{laws:?}, kernel {kernel}: {} iterations",
                warm.figures.iterations
            );
            assert!(
                warm.figures.iterations < cold.figures.iterations,
                "{laws:?}, kernel {kernel}"
            );
        }
    }
}

/// A load cycle step by step: friction counts from the slip of the step before.
#[test]
fn incremental_friction_remembers() {
    // One dof along each axis, springs 1 and 2, pressed down for good, pushed to and fro.
    let k = dense(&[vec![1.0, 0.0], vec![0.0, 2.0]]);
    let problem =
        tresca::algebraic::MatrixProblem::new(k, dense(&[vec![1.0, 0.0]]), vec![5.0, 0.0])
            .with_tangential(dense(&[vec![0.0, 1.0]]))
            .with_friction(PairLaw::tresca(1.0));
    let mut prepared = prepare(&problem, &tight(), &mut Silent).unwrap();
    let mut conditions = problem.conditions.clone();
    // (push, slip): slides at 3 − 1, sticks on the way back until the friction has turned.
    for (push, expected) in [
        (0.5, 0.0),
        (3.0, 1.0),
        (2.0, 1.0),
        (0.0, 0.5),
        (-3.0, -1.0),
        (0.0, -0.5),
    ] {
        conditions.load[1] = push;
        let solution = prepared.solve(&conditions, &tight(), &mut Silent).unwrap();
        assert!(solution.converged());
        assert!(
            (solution.slip[0] - expected).abs() < 1e-9,
            "push {push}: {}",
            solution.slip[0]
        );
        assert!(
            solution.certificate.worst() < 1e-9,
            "{:#?}",
            solution.certificate
        );
        conditions.previous_slip = Some(solution.slip.clone());
        conditions.start = Some(solution.forces());
    }
}

#[test]
fn every_method_finds_the_same() {
    let problem = random(Laws::Tresca, 2, 0, 6);
    let expected = solved(&problem, &tight());
    for method in [
        Method::Ssn,
        Method::Mssn,
        Method::Imssn,
        Method::Gimssn,
        Method::Apgd,
    ] {
        let settings = Settings {
            method,
            tolerance: 1e-9,
            max_iterations: 100_000,
            ..Settings::default()
        };
        let solution = solve(&problem, &settings, &mut Silent).unwrap();
        assert!(solution.converged(), "{method}: {}", solution.status);
        assert_close(
            &solution.normal_force,
            &expected.normal_force,
            1e-5,
            &method.to_string(),
        );
    }
}

#[test]
fn one_law_for_all_is_the_same_as_one_for_each() {
    let one = random(Laws::Tresca, 2, 0, 2).with_friction(PairLaw::tresca(0.4));
    let each = one.clone().with_friction(Friction::tresca(&[0.4; 6]));
    assert_eq!(
        solved(&one, &tight()).tangential_force,
        solved(&each, &tight()).tangential_force
    );
}
