//! Coulomb's law: fixed points checked by the conic solver, and both ways to them.

mod settling;
mod sweeps;

use crate::common::half_space::HalfSpace;
use crate::common::{Plain, distance, norm, oracle};
use std::ops::ControlFlow;
use tresca_qcqp::sets::BlockState;
use tresca_qcqp::{
    CoulombBound, CoulombMethod, DualProblem, DualSolution, InnerSolver, IterationRecord, Method,
    ProductSet, QcqpError, Settings, Start, Status, Unobserved, solve,
};

const METHODS: [CoulombMethod; 2] = [CoulombMethod::FixedPoint, CoulombMethod::InLoop];

/// A sphere pressed into the half-space, shifted and twisted.
fn indentation(half: &HalfSpace) -> Plain {
    let m = half.pairs();
    let mut b = vec![0.0; 3 * m];
    for (i, p) in half.points.iter().enumerate() {
        b[i] = 0.1 - 0.6 * (p[0] * p[0] + p[1] * p[1]);
        b[m + 2 * i] = 0.04 + 0.05 * p[1];
        b[m + 2 * i + 1] = -0.05 * p[0];
    }
    Plain {
        a: half.compliance.clone(),
        b,
        set: ProductSet::contact_3d(&vec![0.0; m]).unwrap(),
    }
}

fn settings(coulomb: CoulombMethod) -> Settings {
    Settings {
        coulomb,
        ..Settings::default()
    }
}

fn run(
    plain: &Plain,
    law: Vec<CoulombBound>,
    settings: &Settings,
) -> (DualProblem<'static>, DualSolution) {
    let mut problem = plain.problem().with_coulomb(law).unwrap();
    let solution = solve(&mut problem, settings, None, &mut Unobserved).unwrap();
    (problem, solution)
}

/// The bounds of the problem are those that follow from λ.
fn assert_bounds_follow(problem: &DualProblem, solution: &DualSolution, tolerance: f64) {
    let (mut off, mut size) = (0.0, 0.0);
    for bound in problem.coulomb() {
        let follows = (bound.coefficient * solution.lambda[bound.normal].max(0.0)).min(bound.limit);
        let has = problem.set().blocks()[bound.block].set.bound().unwrap();
        off += (follows - has).powi(2);
        size += follows * follows;
    }
    assert!(
        off.sqrt() <= tolerance * size.sqrt(),
        "bounds off by {:.1e}",
        (off / size).sqrt()
    );
    assert!(problem.set().contains(&solution.lambda));
}

#[test]
fn the_solution_is_that_of_the_problem_with_its_own_bounds() {
    let half = HalfSpace::new(5, 0.3);
    let plain = indentation(&half);
    for coefficient in [0.1, 0.3, 0.6, 1.0] {
        for coulomb in METHODS {
            let what = format!("F = {coefficient}, {coulomb}");
            let settings = Settings {
                coulomb_tolerance: 1e-9,
                tolerance: 1e-10,
                ..settings(coulomb)
            };
            let (problem, solution) = run(&plain, half.law(coefficient), &settings);
            assert_eq!(solution.status, Status::Converged, "{what}");
            assert!(solution.figures.outer_residual <= 1e-9, "{what}");
            assert_bounds_follow(&problem, &solution, 1e-9);
            let frozen = Plain {
                set: problem.set().clone(),
                ..plain.clone()
            };
            let reference = oracle::minimiser(&frozen);
            // The conic solver is not so exact near the many discs that are all but points.
            let off = distance(&reference, &solution.lambda) / norm(&reference);
            assert!(off <= 1e-4, "{what}: off by {off:.1e}");
            let gap = frozen.objective(&solution.lambda) - frozen.objective(&reference);
            assert!(gap <= 1e-12, "{what}: objective higher by {gap:.1e}");
            let seen = frozen
                .relative_reduced_gradient(&solution.lambda, 1.0 / solution.figures.sigma_max);
            assert!(seen <= 1.1e-10, "{what}: reduced gradient {seen:.1e}");
            let counts = solution.active_set.counts();
            assert!(
                counts.closed > 0 && counts.open > 0 && counts.slip > counts.open,
                "{what}: {counts:?}"
            );
        }
    }
}

#[test]
fn both_ways_agree_and_keep_to_their_work() {
    for side in [8, 12] {
        let half = HalfSpace::new(side, 0.3);
        let plain = indentation(&half);
        for coefficient in [0.1, 0.3, 0.6, 1.0] {
            for inner_solver in [InnerSolver::Direct, InnerSolver::Iterative] {
                let solutions = METHODS.map(|coulomb| {
                    let settings = Settings {
                        inner_solver,
                        ..settings(coulomb)
                    };
                    let (problem, solution) = run(&plain, half.law(coefficient), &settings);
                    assert_eq!(solution.status, Status::Converged);
                    let frozen = Plain {
                        set: problem.set().clone(),
                        ..plain.clone()
                    };
                    let tresca = frozen.solve(&settings, None);
                    let work = solution.figures.n_a as f64 / tresca.figures.n_a as f64;
                    let allowed = if coulomb == CoulombMethod::InLoop {
                        2.5
                    } else {
                        3.0
                    };
                    assert!(
                        work <= allowed,
                        "{coulomb}, {inner_solver}, F = {coefficient}: {work:.2} times the work"
                    );
                    solution
                });
                let [fixed_point, in_loop] = &solutions;
                assert!(
                    fixed_point.figures.outer_iterations <= 10,
                    "{} outer iterations",
                    fixed_point.figures.outer_iterations
                );
                assert_eq!(in_loop.figures.outer_iterations, in_loop.figures.iterations);
                let off = distance(&fixed_point.lambda, &in_loop.lambda) / norm(&in_loop.lambda);
                assert!(off <= 3e-6, "off by {off:.1e}");
            }
        }
    }
}

#[test]
fn every_method_can_solve_the_frozen_problems() {
    let half = HalfSpace::new(5, 0.3);
    let plain = indentation(&half);
    let (_, reference) = run(&plain, half.law(0.4), &Settings::default());
    for &method in Method::ALL {
        let settings = Settings {
            method,
            max_iterations: 20_000,
            ..Settings::default()
        };
        let (_, solution) = run(&plain, half.law(0.4), &settings);
        if matches!(method, Method::Grssn | Method::Gimssn | Method::Apgd) {
            assert_eq!(solution.status, Status::Converged, "{method}");
        }
        if solution.status.is_converged() {
            let off = distance(&solution.lambda, &reference.lambda) / norm(&reference.lambda);
            assert!(off <= 1e-5, "{method}: off by {off:.1e}");
        }
    }
}

#[test]
fn no_friction_and_much_friction_have_their_limits() {
    let half = HalfSpace::new(5, 0.3);
    let m = half.pairs();
    let plain = indentation(&half);
    for coulomb in METHODS {
        let (_, without) = run(&plain, half.law(0.0), &settings(coulomb));
        let frictionless = plain.solve(&Settings::default(), None);
        assert!(
            distance(&without.lambda, &frictionless.lambda) <= 1e-6 * norm(&frictionless.lambda)
        );

        let (_, much) = run(&plain, half.law(20.0), &settings(coulomb));
        assert_eq!(much.status, Status::Converged, "{coulomb}");
        // What is closed sticks: the same as bounds of nothing where open and of plenty where closed.
        let bounds: Vec<f64> = much.lambda[..m]
            .iter()
            .map(|&l| if l > 0.0 { 1e3 } else { 0.0 })
            .collect();
        let stuck = Plain {
            set: ProductSet::contact_3d(&bounds).unwrap(),
            ..plain.clone()
        };
        let stuck = stuck.solve(&Settings::default(), None);
        assert!(
            distance(&much.lambda, &stuck.lambda) <= 1e-6 * norm(&stuck.lambda),
            "{coulomb}"
        );

        // A cap below all bounds makes it Tresca's law.
        let capped = half.law(0.5).into_iter().map(|bound| CoulombBound {
            limit: 1e-4,
            ..bound
        });
        let (problem, solution) = run(&plain, capped.collect(), &settings(coulomb));
        assert_eq!(solution.status, Status::Converged);
        assert_bounds_follow(&problem, &solution, 1e-6);
        for i in 0..m {
            let bound = problem.set().blocks()[m + i].set.bound().unwrap();
            assert!(bound <= 1e-4);
            if solution.lambda[i] > 1e-3 {
                assert_eq!(bound, 1e-4);
            }
        }
    }
}

#[test]
fn a_load_step_starts_from_the_last_one() {
    let half = HalfSpace::new(8, 0.3);
    let plain = indentation(&half);
    for coulomb in METHODS {
        let settings = Settings {
            inner_solver: InnerSolver::Iterative,
            ..settings(coulomb)
        };
        let (mut problem, first) = run(&plain, half.law(0.3), &settings);
        let more: Vec<f64> = plain.b.iter().map(|b| 1.02 * b).collect();
        problem.set_rhs(more.clone()).unwrap();
        let warm = solve(
            &mut problem,
            &settings,
            Some(Start::from(&first)),
            &mut Unobserved,
        )
        .unwrap();
        assert_eq!(
            (warm.status, warm.figures.n_a_setup),
            (Status::Converged, 0)
        );
        assert_bounds_follow(&problem, &warm, 1e-6);
        let (_, cold) = run(
            &Plain {
                b: more,
                ..plain.clone()
            },
            half.law(0.3),
            &settings,
        );
        assert!(
            distance(&warm.lambda, &cold.lambda) <= 3e-6 * norm(&cold.lambda),
            "{coulomb}"
        );
        assert!(
            warm.figures.n_a < cold.figures.n_a,
            "{coulomb}: {} and {}",
            warm.figures.n_a,
            cold.figures.n_a
        );
        // Nothing new: nothing to do.
        let again = solve(
            &mut problem,
            &settings,
            Some(Start::from(&warm)),
            &mut Unobserved,
        )
        .unwrap();
        assert_eq!(again.status, Status::Converged);
        assert!(again.figures.n_a <= 8, "{coulomb}: {}", again.figures.n_a);
    }
}

#[test]
fn a_body_that_does_not_touch_needs_no_bounds() {
    let half = HalfSpace::new(4, 0.3);
    let m = half.pairs();
    let mut plain = indentation(&half);
    plain.b[..m].iter_mut().for_each(|b| *b = -b.abs());
    for coulomb in METHODS {
        let (problem, solution) = run(&plain, half.law(0.5), &settings(coulomb));
        assert_eq!(
            (solution.status, solution.figures.n_a),
            (Status::Converged, 0)
        );
        assert!(solution.lambda.iter().all(|&l| l == 0.0));
        assert!(
            problem
                .set()
                .blocks()
                .iter()
                .all(|b| b.set.bound().unwrap_or(0.0) == 0.0)
        );
        assert!(
            solution
                .active_set
                .states()
                .iter()
                .all(|&s| s == BlockState::Bound)
        );
    }
}

#[test]
fn the_observer_can_stop_between_bounds() {
    let half = HalfSpace::new(5, 0.3);
    let plain = indentation(&half);
    for coulomb in METHODS {
        let (_, whole) = run(&plain, half.law(0.6), &settings(coulomb));
        for stop in 0..whole.records.len() - 1 {
            let mut observer = |record: &IterationRecord| {
                if record.iteration == stop {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            };
            let mut problem = plain.problem().with_coulomb(half.law(0.6)).unwrap();
            let solution = solve(&mut problem, &settings(coulomb), None, &mut observer).unwrap();
            assert_eq!(solution.status, Status::Interrupted, "{coulomb}, at {stop}");
            assert_eq!(solution.records.len(), stop + 1);
            assert!(problem.set().contains(&solution.lambda));
        }
        let limited = Settings {
            max_outer_iterations: 2,
            ..settings(coulomb)
        };
        if coulomb == CoulombMethod::FixedPoint {
            let (_, solution) = run(&plain, half.law(0.6), &limited);
            assert_eq!(
                (solution.status, solution.figures.outer_iterations),
                (Status::IterationLimit, 2)
            );
        }
    }
}

#[test]
fn wrong_laws_are_refused() {
    let half = HalfSpace::new(2, 0.3);
    let plain = indentation(&half);
    let bound = CoulombBound {
        block: 4,
        normal: 0,
        coefficient: 0.3,
        limit: f64::INFINITY,
    };
    let refusal = |bounds: Vec<CoulombBound>| plain.problem().with_coulomb(bounds).err().unwrap();
    for wrong in [
        CoulombBound { block: 99, ..bound },
        CoulombBound { block: 1, ..bound },
        CoulombBound {
            normal: 99,
            ..bound
        },
        CoulombBound { normal: 4, ..bound },
        CoulombBound {
            coefficient: -0.1,
            ..bound
        },
        CoulombBound {
            coefficient: f64::NAN,
            ..bound
        },
        CoulombBound {
            limit: -1.0,
            ..bound
        },
        CoulombBound {
            limit: f64::NAN,
            ..bound
        },
    ] {
        assert!(
            matches!(refusal(vec![wrong]), QcqpError::Coulomb { bound: 0, .. }),
            "{wrong:?}"
        );
    }
    assert!(matches!(
        refusal(vec![bound; 2]),
        QcqpError::Coulomb { bound: 1, .. }
    ));
    let settings = Settings {
        method: Method::Apgd,
        ..settings(CoulombMethod::InLoop)
    };
    let error = settings.validate().unwrap_err().to_string();
    assert!(
        error.contains("coulomb") && error.contains("grssn"),
        "{error}"
    );
}
