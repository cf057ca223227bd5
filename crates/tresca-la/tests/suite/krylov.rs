//! Krylov methods against known solutions and spectra.

use crate::common::{DenseOperator, Random, assert_close, orthogonal, with_spectrum};
use faer::Mat;
use tresca_la::LinearOperator;
use tresca_la::krylov::cg::{self, ConjugateGradient, Proposal};
use tresca_la::krylov::{Identity, InverseDiagonal, bicgstab, lanczos};
use tresca_la::vector::norm;

fn product(operator: &mut DenseOperator, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; x.len()];
    operator.apply(x, &mut y);
    operator.products = 0;
    y
}

#[test]
fn cg_ends_after_as_many_steps_as_there_are_distinct_eigenvalues() {
    let values: Vec<f64> = (0..30).map(|i| [1.0, 2.5, 7.0, 11.0][i % 4]).collect();
    let mut operator = DenseOperator::new(with_spectrum(&values, 1));
    let exact = Random::new(2).vector(30);
    let b = product(&mut operator, &exact);
    let mut x = vec![0.0; 30];
    let mut workspace = ConjugateGradient::with_capacity(30);
    let record = cg::solve(
        &mut operator,
        &mut Identity(30),
        &b,
        &mut x,
        1e-10 * norm(&b),
        30,
        &mut workspace,
    );
    assert_eq!(record.outcome, cg::CgOutcome::Converged);
    assert_eq!(record.iterations, 4);
    assert_eq!(operator.products, 5, "one per step and one for the start");
    assert_close(&x, &exact, 1e-9);
}

#[test]
fn cg_with_the_exact_diagonal_solves_a_diagonal_system_in_one_step() {
    let diagonal: Vec<f64> = (0..12).map(|i| 10.0_f64.powi(i - 6)).collect();
    let mut operator = DenseOperator::diagonal(&diagonal);
    let exact = Random::new(3).vector(12);
    let b = product(&mut operator, &exact);
    let mut x = vec![0.0; 12];
    let record = cg::solve(
        &mut operator,
        &mut InverseDiagonal::new(&diagonal),
        &b,
        &mut x,
        1e-12 * norm(&b),
        12,
        &mut ConjugateGradient::default(),
    );
    assert_eq!(record.iterations, 1);
    assert_close(&x, &exact, 1e-12);
}

#[test]
fn a_proposed_step_that_is_not_accepted_changes_nothing() {
    let mut operator = DenseOperator::new(with_spectrum(&[1.0, 2.0, 3.0, 4.0], 4));
    let b = [1.0, -1.0, 0.5, 2.0];
    let mut cg = ConjugateGradient::with_capacity(4);
    cg.start(&b);
    let mut x = [0.0; 4];
    let Proposal::Step { alpha, curvature } = cg.propose(&mut operator, &mut Identity(4)) else {
        panic!("a positive definite operator has a step");
    };
    assert_eq!(cg.residual(), b);
    // First step: steepest descent.
    assert_close(cg.direction(), &b, 0.0);
    let direction_product = product(&mut operator, &b);
    assert_close(cg.product(), &direction_product, 0.0);
    assert!((alpha * curvature - norm(&b).powi(2)).abs() < 1e-12);
    cg.accept(&mut x);
    let left: Vec<f64> = b
        .iter()
        .zip(product(&mut operator, &x))
        .map(|(b, ax)| b - ax)
        .collect();
    assert_close(cg.residual(), &left, 1e-14);
}

#[test]
fn cg_reports_a_solved_and_an_indefinite_system() {
    let mut cg = ConjugateGradient::default();
    cg.start(&[0.0, 0.0]);
    let mut operator = DenseOperator::diagonal(&[1.0, -1.0]);
    assert_eq!(
        cg.propose(&mut operator, &mut Identity(2)),
        Proposal::Solved
    );
    assert_eq!(operator.products, 0, "nothing to do costs nothing");
    cg.start(&[1.0, 2.0]);
    assert_eq!(
        cg.propose(&mut operator, &mut Identity(2)),
        Proposal::NotPositiveDefinite
    );
    let mut x = [0.0, 0.0];
    let record = cg::solve(
        &mut DenseOperator::diagonal(&[f64::NAN, 1.0]),
        &mut Identity(2),
        &[1.0, 1.0],
        &mut x,
        1e-6,
        5,
        &mut cg,
    );
    assert_eq!(record.outcome, cg::CgOutcome::NotPositiveDefinite);
}

#[test]
fn bicgstab_solves_nonsymmetric_systems_with_two_products_per_iteration() {
    let n = 40;
    let mut random = Random::new(5);
    for shift in [1.0, 0.3] {
        // Eigenvalues around 3 ± i: far from symmetric, yet definite.
        let noise = Mat::from_fn(n, n, |_, _| shift * random.next() / (n as f64).sqrt());
        let rotation = Mat::from_fn(n, n, |i, j| match (i % 2, i ^ 1 == j) {
            _ if i == j => 3.0,
            (0, true) => 1.0,
            (1, true) => -1.0,
            _ => 0.0,
        });
        let q = orthogonal(n, 6);
        let mut operator = DenseOperator::new(&q * rotation * q.transpose() + noise);
        let exact = random.vector(n);
        let b = product(&mut operator, &exact);
        let mut x = vec![0.0; n];
        let goal = 1e-11 * norm(&b);
        let record = bicgstab::solve(
            &mut operator,
            &mut Identity(n),
            &b,
            &mut x,
            n,
            |residual| residual <= goal,
            &mut bicgstab::Workspace::with_capacity(n),
        );
        assert_eq!(record.outcome, bicgstab::BicgstabOutcome::Converged);
        assert_eq!(record.products, operator.products);
        assert!(record.products <= 1 + 2 * record.iterations);
        assert!(record.products >= 2 * record.iterations);
        assert_close(&x, &exact, 1e-9);
    }
}

#[test]
fn bicgstab_preconditioner_changes_the_way_but_not_the_solution() {
    let n = 20;
    let diagonal: Vec<f64> = (0..n).map(|i| 4.0_f64.powi(i as i32 - 10)).collect();
    let mut matrix = DenseOperator::diagonal(&diagonal).matrix;
    for i in 1..n {
        matrix[(i, i - 1)] = 0.3 * diagonal[i];
    }
    let mut operator = DenseOperator::new(matrix);
    let exact = Random::new(7).vector(n);
    let b = product(&mut operator, &exact);
    let mut x = vec![0.0; n];
    let goal = 1e-13 * norm(&b);
    let record = bicgstab::solve(
        &mut operator,
        &mut InverseDiagonal::new(&diagonal),
        &b,
        &mut x,
        60,
        |residual| residual <= goal,
        &mut bicgstab::Workspace::default(),
    );
    assert_eq!(record.outcome, bicgstab::BicgstabOutcome::Converged);
    let left = norm(
        &b.iter()
            .zip(product(&mut operator, &x))
            .map(|(b, ax)| b - ax)
            .collect::<Vec<_>>(),
    );
    assert!(left <= 1e-12 * norm(&b), "true residual {left}");
}

#[test]
fn bicgstab_reports_breakdown_and_limit() {
    // Antisymmetric: r̂ᵀA p vanishes in the first iteration.
    let turn = Mat::from_fn(2, 2, |i, j| i as f64 - j as f64);
    let mut x = [0.0, 0.0];
    let mut workspace = bicgstab::Workspace::default();
    let record = bicgstab::solve(
        &mut DenseOperator::new(turn),
        &mut Identity(2),
        &[1.0, 1.0],
        &mut x,
        10,
        |_| false,
        &mut workspace,
    );
    assert_eq!(record.outcome, bicgstab::BicgstabOutcome::Breakdown);
    assert_eq!(x, [0.0, 0.0]);
    let values: Vec<f64> = (1..30).map(f64::from).collect();
    let record = bicgstab::solve(
        &mut DenseOperator::diagonal(&values),
        &mut Identity(29),
        &[1.0; 29],
        &mut [0.0; 29],
        3,
        |_| false,
        &mut workspace,
    );
    assert_eq!(record.outcome, bicgstab::BicgstabOutcome::IterationLimit);
    assert_eq!(record.iterations, 3);
}

#[test]
fn lanczos_brackets_the_largest_eigenvalue() {
    for (seed, values) in [
        (1, (1..=60).map(f64::from).collect::<Vec<_>>()),
        (2, (0..60).map(|i| 0.8_f64.powi(i)).collect()),
        (3, (0..60).map(|i| f64::from(i % 3) - 5.0).collect()),
    ] {
        let largest = values.iter().copied().fold(f64::MIN, f64::max);
        let mut operator = DenseOperator::new(with_spectrum(&values, seed));
        for products in [4, 8, 16] {
            operator.products = 0;
            let estimate = lanczos::largest_eigenvalue(&mut operator, None, products, 0.0);
            assert!(estimate.value <= largest * (1.0 + 1e-12 * largest.signum()));
            assert!(
                estimate.upper_bound() >= largest - 1e-9,
                "{} below {largest} after {products}",
                estimate.upper_bound()
            );
            assert_eq!(estimate.products.len(), operator.products);
            assert_eq!(estimate.basis.len(), operator.products);
            assert!(operator.products <= products);
        }
    }
}

#[test]
fn lanczos_returns_what_it_promises() {
    let values: Vec<f64> = (0..50).map(|i| 1.0 / f64::from(i + 1)).collect();
    let mut operator = DenseOperator::new(with_spectrum(&values, 8));
    let estimate = lanczos::largest_eigenvalue(&mut operator, None, 30, 0.01);
    assert!(estimate.residual <= 0.01 * estimate.value);
    assert!((estimate.value - 1.0).abs() <= 0.01);
    let used = operator.products;
    assert!(used < 30, "the tolerance must stop it");
    for (i, v) in estimate.basis.iter().enumerate() {
        assert_close(&product(&mut operator, v), &estimate.products[i], 0.0);
        for (j, w) in estimate.basis.iter().enumerate() {
            let expected = if i == j { 1.0 } else { 0.0 };
            assert!((tresca_la::vector::dot(v, w) - expected).abs() < 1e-12);
        }
    }
    let image = product(&mut operator, &estimate.vector);
    let residual: Vec<f64> = image
        .iter()
        .zip(&estimate.vector)
        .map(|(ay, y)| ay - estimate.value * y)
        .collect();
    assert!((norm(&residual) - estimate.residual).abs() < 1e-12);
    let again = lanczos::largest_eigenvalue(&mut operator, None, 30, 0.01);
    assert_eq!(again.value.to_bits(), estimate.value.to_bits());
}

#[test]
fn lanczos_stops_when_the_krylov_space_is_exhausted() {
    let mut operator = DenseOperator::diagonal(&[2.0, 5.0, 5.0, 2.0]);
    let estimate = lanczos::largest_eigenvalue(&mut operator, None, 10, 0.0);
    assert!((estimate.value - 5.0).abs() < 1e-14);
    assert!(operator.products <= 3);
    let start = [0.0, 0.0, 0.0, 3.0];
    let estimate = lanczos::largest_eigenvalue(&mut operator, Some(&start), 10, 0.0);
    assert_eq!(
        estimate.value, 2.0,
        "only its eigenspace is seen from there"
    );
    let zero = lanczos::largest_eigenvalue(&mut DenseOperator::diagonal(&[0.0; 3]), None, 5, 0.1);
    assert_eq!(zero.value, 0.0);
}
