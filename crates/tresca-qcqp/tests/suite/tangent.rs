//! The tangent at a solution against the dense semismooth Newton system and finite differences.

use crate::common::problems::{KINDS, Kind, normals, random, rng};
use crate::common::{Plain, distance, dot, norm, settings};
use faer::linalg::solvers::Solve;
use faer::{ColRef, Mat};
use tresca_qcqp::operator::Dense;
use tresca_qcqp::sets::{Block, BlockSet, Line};
use tresca_qcqp::{
    DualProblem, DualSolution, InnerSolver, Method, ProductSet, QcqpError, Settings, Tangent,
    Unobserved, solve,
};

const PAIRS: usize = 8;
const CONDITION: f64 = 30.0;

fn solved(plain: &Plain, settings: &Settings) -> (DualProblem<'static>, DualSolution) {
    let mut problem = plain.problem();
    let solution = solve(&mut problem, settings, None, &mut Unobserved).unwrap();
    assert!(solution.status.is_converged());
    (problem, solution)
}

fn exact(inner_solver: InnerSolver) -> Settings {
    Settings {
        inner_solver,
        ..settings(Method::Grssn, 1e-13)
    }
}

/// δ with (I − G (I − ρA)) δ = ρ G v, the linearisation of λ = P(λ − ρ (Aλ − b)), by dense LU; G is the slanting
/// function of P at y.
fn linearised(plain: &Plain, solution: &DualSolution, v: &[f64]) -> Vec<f64> {
    let n = plain.dim();
    // λ = 0 needs no estimate of σmax; any ρ > 0 tells its states.
    let rho = match solution.figures.sigma_max {
        0.0 => 1.0,
        sigma => 1.0 / sigma,
    };
    let a_lambda = plain.mul(&solution.lambda);
    let y: Vec<f64> = (0..n)
        .map(|i| solution.lambda[i] - rho * (a_lambda[i] - plain.b[i]))
        .collect();
    let mut matrix = Mat::zeros(n, n);
    for j in 0..n {
        let mut column: Vec<f64> = (0..n).map(|i| -rho * plain.a[i][j]).collect();
        column[j] += 1.0;
        plain.set.slant(&y, &mut column);
        for i in 0..n {
            matrix[(i, j)] = f64::from(u8::from(i == j)) - column[i];
        }
    }
    let mut rhs: Vec<f64> = v.iter().map(|v| rho * v).collect();
    plain.set.slant(&y, &mut rhs);
    let delta = matrix.partial_piv_lu().solve(ColRef::from_slice(&rhs));
    delta.iter().copied().collect()
}

#[test]
fn the_response_is_that_of_the_dense_semismooth_newton_system() {
    for kind in KINDS {
        for seed in 0..4 {
            let plain = random(kind, PAIRS, CONDITION, 50 + seed);
            for (inner_solver, accuracy) in
                [(InnerSolver::Direct, 1e-9), (InnerSolver::Iterative, 1e-11)]
            {
                let settings = exact(inner_solver);
                let (mut problem, solution) = solved(&plain, &settings);
                let tangent = Tangent::at(&problem, &solution, &settings).unwrap();
                let v = normals(&mut rng(seed), plain.dim());
                let found = tangent
                    .response(&mut problem, &settings, &v, accuracy)
                    .unwrap();
                let expected = linearised(&plain, &solution, &v);
                let off = distance(&found, &expected);
                assert!(
                    off <= 1e-8 * norm(&v),
                    "{kind:?} {seed} {inner_solver:?}: {off:e}"
                );
            }
        }
    }
}

#[test]
fn product_and_solve_are_inverse_and_symmetric() {
    for kind in [Kind::Mixed, Kind::Everything, Kind::TwoDimensional] {
        let plain = random(kind, PAIRS, CONDITION, 60);
        for inner_solver in [InnerSolver::Direct, InnerSolver::Iterative] {
            let settings = exact(inner_solver);
            let (mut problem, solution) = solved(&plain, &settings);
            let tangent = Tangent::at(&problem, &solution, &settings).unwrap();
            assert!(tangent.curvature().iter().all(|c| *c >= 0.0));
            let rng = &mut rng(3);
            let (s, t) = (normals(rng, tangent.dim()), normals(rng, tangent.dim()));
            let image = tangent.product(&mut problem, &s);
            let other = tangent.product(&mut problem, &t);
            assert!((dot(&t, &image) - dot(&s, &other)).abs() <= 1e-12 * norm(&s) * norm(&t));
            let back = tangent
                .solve(&mut problem, &settings, &image, 1e-12)
                .unwrap();
            assert!(distance(&back, &s) <= 1e-9 * norm(&s), "{kind:?}");
            // Z is orthonormal.
            let full = tangent.expand(&problem, &s);
            assert!(distance(&tangent.restrict(&full), &s) <= 1e-14 * norm(&s));
        }
    }
}

#[test]
fn the_response_is_the_derivative_of_the_solution() {
    let step = 1e-5;
    let settings = exact(InnerSolver::Auto);
    let (mut checked, mut slipping) = (0, 0);
    for kind in [
        Kind::Mixed,
        Kind::SomeFrictionless,
        Kind::TwoDimensional,
        Kind::Everything,
    ] {
        for seed in 0..5 {
            let plain = random(kind, PAIRS, CONDITION, 70 + seed);
            let v = normals(&mut rng(seed), plain.dim());
            let moved = |h: f64| {
                let mut moved = plain.clone();
                moved.b.iter_mut().zip(&v).for_each(|(b, v)| *b += h * v);
                solved(&moved, &settings).1
            };
            let (ahead, behind) = (moved(step), moved(-step));
            let (mut problem, solution) = solved(&plain, &settings);
            // A block that changes its state on the way is not strictly complementary.
            if ahead.active_set != solution.active_set || behind.active_set != solution.active_set {
                continue;
            }
            checked += 1;
            slipping += solution.active_set.counts().slip;
            let tangent = Tangent::at(&problem, &solution, &settings).unwrap();
            let found = tangent
                .response(&mut problem, &settings, &v, 1e-12)
                .unwrap();
            let difference: Vec<f64> = ahead
                .lambda
                .iter()
                .zip(&behind.lambda)
                .map(|(a, b)| (a - b) / (2.0 * step))
                .collect();
            let off = distance(&found, &difference);
            assert!(off <= 1e-6 * norm(&found), "{kind:?} {seed}: {off:e}");
        }
    }
    assert!(
        checked >= 15 && slipping >= 15,
        "{checked} cases, {slipping} slipping pairs"
    );
}

#[test]
fn a_problem_at_rest_has_a_tangent() {
    let mut plain = random(Kind::AllStick, PAIRS, CONDITION, 80);
    plain.b.fill(0.0);
    let settings = exact(InnerSolver::Auto);
    let (mut problem, solution) = solved(&plain, &settings);
    assert_eq!(solution.figures.n_a, 0);
    let tangent = Tangent::at(&problem, &solution, &settings).unwrap();
    let rhs = normals(&mut rng(1), tangent.dim());
    let s = tangent.solve(&mut problem, &settings, &rhs, 1e-12).unwrap();
    assert!(distance(&tangent.product(&mut problem, &s), &rhs) <= 1e-9 * norm(&rhs));
}

#[test]
fn what_does_not_fit_or_cannot_be_solved_is_an_error() {
    // A moves the first unknown alone; the second is free and moves nothing.
    let mut packed = tresca_la::PackedLower::zeros(2);
    packed.set(0, 0, 1.0);
    let line = |start| Block {
        start,
        set: BlockSet::Line(Line),
    };
    let set = ProductSet::new(2, vec![line(0), line(1)]).unwrap();
    let mut problem = DualProblem::new(Dense::new(packed), vec![1.0, 0.0], set).unwrap();
    let settings = exact(InnerSolver::Auto);
    let solution = solve(&mut problem, &settings, None, &mut Unobserved).unwrap();
    let tangent = Tangent::at(&problem, &solution, &settings).unwrap();
    let mut response = |v: &[f64]| tangent.response(&mut problem, &settings, v, 1e-10);
    assert!(distance(&response(&[2.0, 0.0]).unwrap(), &[2.0, 0.0]) <= 1e-12);
    assert!(matches!(
        response(&[0.0, 1.0]),
        Err(QcqpError::Tangent { residual }) if residual > 0.5
    ));
    assert!(matches!(response(&[1.0]), Err(QcqpError::Dimension { .. })));
    let other = random(Kind::Mixed, 2, CONDITION, 1).problem();
    assert!(Tangent::at(&other, &solution, &settings).is_err());
}
