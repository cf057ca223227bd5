//! Bounds that settle where they should, and those that never do.

use super::{METHODS, assert_bounds_follow, indentation, run, settings};
use crate::common::half_space::HalfSpace;
use crate::common::{Plain, distance, norm, oracle};
use tresca_qcqp::operator::{Dense, DualOperator, LocalModel, Tally};
use tresca_qcqp::{
    CoulombBound, CoulombMethod, DualProblem, InnerSolver, ProductSet, Settings, Status,
    Unobserved, solve,
};

/// λν = 1 − kλτ and λτ = F λν with Fk > 1: the bound jumps between two values for ever.
fn cycling() -> (Plain, Vec<CoulombBound>) {
    let (k, coefficient) = (0.9, 3.0);
    let plain = Plain {
        a: vec![vec![1.0, k], vec![k, 1.0]],
        b: vec![1.0, 10.0],
        set: ProductSet::contact_2d(&[0.0]).unwrap(),
    };
    let law = vec![CoulombBound {
        block: 1,
        normal: 0,
        coefficient,
        limit: f64::INFINITY,
    }];
    (plain, law)
}

/// A by its products alone: nothing can be solved contact by contact.
struct Products(Dense);

impl DualOperator for Products {
    fn dim(&self) -> usize {
        self.0.dim()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.0.multiply(x, y);
    }

    fn tally(&mut self) -> &mut Tally {
        self.0.tally()
    }

    fn local_model(&self) -> LocalModel {
        self.0.local_model()
    }
}

fn products_alone(plain: &Plain, law: Vec<CoulombBound>) -> DualProblem<'static> {
    let operator = Products(Dense::new(plain.packed()));
    DualProblem::new(operator, plain.b.clone(), plain.set.clone())
        .unwrap()
        .with_coulomb(law)
        .unwrap()
}

#[test]
fn a_cycle_of_the_bounds_is_recognised() {
    let (plain, law) = cycling();
    for coulomb in METHODS {
        let mut problem = products_alone(&plain, law.clone());
        let solution = solve(&mut problem, &settings(coulomb), None, &mut Unobserved).unwrap();
        assert_eq!(solution.status, Status::CoulombCycles, "{coulomb}");
        assert!(!solution.status.is_converged() && solution.figures.outer_residual > 0.1);
        assert!(problem.set().contains(&solution.lambda));
        // Less friction settles: λν = 1/(1 + Fk).
        let less = vec![CoulombBound {
            coefficient: 0.5,
            ..law[0]
        }];
        let (_, solution) = run(&plain, less, &settings(coulomb));
        assert_eq!(solution.status, Status::Converged);
        assert!((solution.lambda[0] - 1.0 / 1.45).abs() <= 1e-6);
        assert!((solution.lambda[1] - 0.5 / 1.45).abs() <= 1e-6);
    }
}

/// Where both ways are open the loop is not waited for as long as where it is asked for alone.
#[test]
fn a_loop_that_brings_nothing_is_given_up_early() {
    let (plain, law) = cycling();
    let steps = |coulomb| {
        run(&plain, law.clone(), &settings(coulomb))
            .1
            .figures
            .iterations
    };
    let [alone, fixed, both] = [
        CoulombMethod::InLoop,
        CoulombMethod::FixedPoint,
        CoulombMethod::Auto,
    ]
    .map(steps);
    assert!(alone > 20, "{alone}");
    assert!(
        fixed < both && both <= fixed + 10,
        "{both} beside {fixed} of the fixed point and {alone} of the loop"
    );
}

/// Two pairs whose normal forces depend on each other's friction, crosswise: near the solution the
/// bounds turn round it in a spiral that widens by Fk = 1.05 each time.
#[test]
fn a_widening_spiral_is_recognised() {
    let (k, coefficient) = (0.5, 2.1);
    let plain = Plain {
        a: vec![
            vec![1.0, 0.0, 0.0, k],
            vec![0.0, 1.0, -k, 0.0],
            vec![0.0, -k, 1.0, 0.0],
            vec![k, 0.0, 0.0, 1.0],
        ],
        b: vec![3.0, 1.0, 20.0, 20.0],
        set: ProductSet::contact_2d(&[0.0; 2]).unwrap(),
    };
    let law: Vec<CoulombBound> = (0..2)
        .map(|i| CoulombBound {
            block: 2 + i,
            normal: i,
            coefficient,
            limit: f64::INFINITY,
        })
        .collect();
    let first = 4.095 / 2.1025;
    let solution_bounds = [first, 2.1 + 1.05 * first];
    let run_from = |bounds: [f64; 2]| {
        let mut problem = products_alone(&plain, law.clone());
        problem
            .set_set(ProductSet::contact_2d(&bounds).unwrap())
            .unwrap();
        let start = [0.0; 4];
        solve(
            &mut problem,
            &settings(CoulombMethod::FixedPoint),
            Some(start[..].into()),
            &mut Unobserved,
        )
        .unwrap()
    };
    // The fixed point itself is found when started there.
    let solution = run_from(solution_bounds);
    assert_eq!(solution.status, Status::Converged);
    let off = distance(&solution.lambda[2..], &solution_bounds);
    assert!(off <= 1e-5, "off by {off:.1e}");
    let solution = run_from([solution_bounds[0] + 0.02, solution_bounds[1]]);
    assert_eq!(solution.status, Status::CoulombDiverges);
}

/// A block on an incline stays where tan θ < F, whatever the start of the iteration may hold.
#[test]
fn a_block_on_an_incline_slides_when_friction_is_too_small() {
    let half = HalfSpace::new(6, 0.3);
    for coefficient in [0.2, 0.6] {
        for coulomb in METHODS {
            for (number, (share, possible)) in [
                (0.0, true),
                (0.7, true),
                (0.999, true),
                (1.001, false),
                (1.5, false),
            ]
            .into_iter()
            .enumerate()
            {
                let what = format!("F = {coefficient}, {coulomb}, {share} of the limit");
                let floating = half.block([share * coefficient, 0.0, -1.0], 0.05, |_| 0.0);
                let mut problem = floating
                    .problem()
                    .with_coulomb(half.law(coefficient))
                    .unwrap();
                let inner_solver = [InnerSolver::Direct, InnerSolver::Iterative][number % 2];
                let settings = Settings {
                    inner_solver,
                    ..settings(coulomb)
                };
                let solution = solve(&mut problem, &settings, None, &mut Unobserved).unwrap();
                if !possible {
                    assert_eq!(solution.status, Status::NoEquilibrium, "{what}");
                    let motion = solution.motion.unwrap();
                    assert!(motion[0] > 0.8, "{what}: {motion:?}");
                    continue;
                }
                assert_eq!(solution.status, Status::Converged, "{what}");
                assert_bounds_follow(&problem, &solution, 1e-6);
                assert!(norm(&floating.residual(&solution.lambda)) <= 1e-6, "{what}");
                if share == 0.7 {
                    let frozen = Plain {
                        set: problem.set().clone(),
                        ..floating.plain.clone()
                    };
                    let (rows, rhs) = (&floating.equality.rows, &floating.equality.rhs);
                    let reference = oracle::constrained_minimiser(&frozen, rows, rhs).unwrap();
                    let off = distance(&reference, &solution.lambda) / norm(&reference);
                    assert!(off <= 1e-4, "{what}: off by {off:.1e}");
                }
            }
        }
    }
}

/// A loose reduced gradient must not keep the bounds from settling.
#[test]
fn bounds_settle_under_a_loose_tolerance() {
    let half = HalfSpace::new(6, 0.3);
    let plain = indentation(&half);
    for coulomb in METHODS {
        for inner_solver in [InnerSolver::Direct, InnerSolver::Iterative] {
            let settings = Settings {
                tolerance: 1e-2,
                inner_solver,
                ..settings(coulomb)
            };
            let (problem, solution) = run(&plain, half.law(0.5), &settings);
            assert_eq!(
                solution.status,
                Status::Converged,
                "{coulomb}, {inner_solver}"
            );
            assert!(solution.figures.relative_reduced_gradient <= 1e-2);
            assert_bounds_follow(&problem, &solution, 1e-6);
        }
    }
}

/// A block without load on a support with friction: apart, touching, and pushed into it.
#[test]
fn a_block_without_load_needs_no_friction() {
    let half = HalfSpace::new(5, 0.3);
    for (number, gap) in [0.1, 0.0, 0.0, -0.02].into_iter().enumerate() {
        let curved = if number == 2 { 0.0 } else { 0.3 };
        let floating = half.block([0.0; 3], 0.0, |p| {
            gap + curved * (p[0] * p[0] + p[1] * p[1])
        });
        for coulomb in METHODS {
            let mut problem = floating.problem().with_coulomb(half.law(0.5)).unwrap();
            let solution = solve(&mut problem, &settings(coulomb), None, &mut Unobserved).unwrap();
            let what = format!("{coulomb}, case {number}");
            assert_eq!(solution.status, Status::Converged, "{what}");
            assert!(
                norm(&solution.lambda) <= 1e-7,
                "{what}: {:.1e}",
                norm(&solution.lambda)
            );
        }
    }
}
