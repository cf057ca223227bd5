//! A, b and bounds alone give the forces of the problem that they come from.

use tresca::Silent;
use tresca::algebraic::{Dual, MatrixProblem, Operator, solve_dual};

use super::common::*;

/// A = B K⁻¹ Bᵀ (dense, by rows) and b = B K⁻¹ f − [d; s].
fn dual_of(problem: &MatrixProblem) -> (Vec<f64>, Vec<f64>) {
    let k = whole(&problem.stiffness);
    let n = k.rows();
    let dense = faer::Mat::from_fn(n, n, |i, j| {
        k.row(i)
            .find(|(column, _)| *column == j)
            .map_or(0.0, |(_, value)| value)
    });
    let factor = dense.llt(faer::Side::Lower).unwrap();
    use faer::linalg::solvers::Solve;
    let t = problem.tangential.as_ref().unwrap();
    let rows = problem.normal.rows() + t.rows();
    let row = |i: usize| {
        let (matrix, i) = match i.checked_sub(problem.normal.rows()) {
            None => (&problem.normal, i),
            Some(i) => (t, i),
        };
        let mut dense = vec![0.0; n];
        matrix.row(i).for_each(|(j, value)| dense[j] = value);
        dense
    };
    let b = faer::Mat::from_fn(rows, n, |i, j| row(i)[j]);
    let solved = factor.solve(b.transpose());
    let a = &b * &solved;
    let f = faer::Mat::from_fn(n, 1, |i, _| problem.conditions.load[i]);
    let free = &b * factor.solve(&f);
    let gap = problem.conditions.gap.clone().unwrap();
    let slip = problem
        .conditions
        .previous_slip
        .clone()
        .unwrap_or_else(|| vec![0.0; t.rows()]);
    let shift = [gap, slip].concat();
    let values = (0..rows * rows).map(|k| a[(k / rows, k % rows)]).collect();
    (values, (0..rows).map(|i| free[(i, 0)] - shift[i]).collect())
}

#[test]
fn dense_and_as_a_function() {
    for tangents in [1, 2] {
        for laws in CONVEX.into_iter().chain([Laws::Coulomb]) {
            let problem = random(laws, tangents, 0, 8);
            let expected = solved(&problem, &tight());
            let (a, b) = dual_of(&problem);
            let order = b.len();
            let diagonal: Vec<f64> = (0..order).map(|i| a[order * i + i]).collect();
            let function = {
                let a = a.clone();
                move |x: &[f64], y: &mut [f64]| {
                    for (row, y) in a.chunks_exact(order).zip(y) {
                        *y = row.iter().zip(x).map(|(a, x)| a * x).sum();
                    }
                }
            };
            let with_diagonal = match Operator::product(order, function.clone()) {
                Operator::Product { order, apply, .. } => Operator::Product {
                    order,
                    apply,
                    diagonal: Some(diagonal),
                },
                dense => dense,
            };
            for operator in [
                Operator::dense(order, &a).unwrap(),
                Operator::product(order, function),
                with_diagonal,
            ] {
                let dual = Dual::new(
                    operator,
                    b.clone(),
                    tangents,
                    problem.conditions.friction.clone(),
                );
                let solution = solve_dual(dual, &tight(), &mut Silent).unwrap();
                let what = format!("{laws:?}, {tangents} tangents");
                assert!(solution.converged(), "{what}: {}", solution.status);
                assert!(solution.displacement.is_empty());
                assert_close(&solution.normal_force, &expected.normal_force, 1e-8, &what);
                assert_close(&solution.gap, &expected.gap, 1e-8, &what);
                assert_close(&solution.slip, &expected.slip, 1e-8, &what);
                assert_eq!(solution.closed, expected.closed, "{what}");
                assert_eq!(solution.stick, expected.stick, "{what}");
                assert!(
                    solution.certificate.worst() < 1e-7,
                    "{what}: {:#?}",
                    solution.certificate
                );
            }
        }
    }
}

#[test]
fn a_start_at_the_solution_ends_at_once() {
    for laws in [Laws::Tresca, Laws::Orthotropic, Laws::Coulomb] {
        let problem = random(laws, 2, 0, 4);
        let settings = tresca::Settings {
            tolerance: 1e-9,
            ..tight()
        };
        let first = solved(&problem, &tight());
        let (a, b) = dual_of(&problem);
        let dual = Dual::new(
            Operator::dense(b.len(), &a).unwrap(),
            b,
            2,
            problem.conditions.friction.clone(),
        );
        let again = solve_dual(dual.with_start(first.forces()), &settings, &mut Silent).unwrap();
        assert!(again.converged());
        assert!(
            again.figures.iterations <= 2,
            "{laws:?}: {} iterations",
            again.figures.iterations
        );
    }
}

#[test]
fn one_triangle_stands_for_both_where_they_differ_by_rounding() {
    let problem = random(Laws::Tresca, 2, 0, 4);
    let (a, b) = dual_of(&problem);
    let order = b.len();
    let solved = |a: &[f64]| {
        let operator = Operator::dense(order, a).unwrap();
        let dual = Dual::new(operator, b.clone(), 2, problem.conditions.friction.clone());
        solve_dual(dual, &tight(), &mut Silent).unwrap()
    };
    // Both triangles the same to the last bit.
    let mut symmetric = a.clone();
    for i in 0..order {
        for j in 0..i {
            symmetric[order * j + i] = a[order * i + j];
        }
    }
    let expected = solved(&symmetric);
    assert!(expected.converged() && expected.notes.is_empty());
    let largest = a.iter().fold(0.0_f64, |l, v| l.max(v.abs()));
    let mut skew = symmetric.clone();
    skew[2 * order - 1] += 1e-10 * largest;
    let solution = solved(&skew);
    assert_eq!(solution.normal_force, expected.normal_force);
    assert_eq!(solution.tangential_force, expected.tangential_force);
    let [note] = &solution.notes[..] else {
        panic!("{:?}", solution.notes);
    };
    assert!(note.to_string().contains("1.0e-10"), "{note}");
    assert!(note.to_string().contains("one of its triangles"), "{note}");
    // What stands above the diagonal is looked at all the same.
    skew[2 * order - 1] = f64::NAN;
    let Err(error) = Operator::dense(order, &skew) else {
        panic!("not finite")
    };
    let entry = format!("{}", 2 * order - 1);
    assert!(error.to_string().contains(&entry), "{error}");
}
