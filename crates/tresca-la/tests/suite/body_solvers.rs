//! What every solver of a body must fulfil, against dense linear algebra.

use crate::common::{Random, dense, grid};
use faer::{ColRef, Mat};
use tresca_la::{BodySolver, Ordering, Parallelism, SparseCholesky, SymmetricMatrix};

/// Makes a solver for a matrix with these trailing dofs.
type Make = fn(&SymmetricMatrix, &[usize]) -> Box<dyn BodySolver>;

/// Every implementation. A new one belongs here.
const SOLVERS: [(&str, Make); 2] = [
    ("Cholesky", |matrix, trailing| {
        cholesky(matrix, trailing, Parallelism::Sequential)
    }),
    ("Cholesky on two threads", |matrix, trailing| {
        cholesky(matrix, trailing, Parallelism::Threads(2))
    }),
];

fn cholesky(
    matrix: &SymmetricMatrix,
    trailing: &[usize],
    parallelism: Parallelism,
) -> Box<dyn BodySolver> {
    let ordering = Ordering::nested_dissection_with_trailing(matrix, trailing).unwrap();
    Box::new(SparseCholesky::factor(matrix, ordering, parallelism).unwrap())
}

/// Trailing dofs out of order, and K: a brick, a plate, one dof.
fn bodies() -> Vec<(SymmetricMatrix, Vec<usize>)> {
    let body = |nodes, components, seed| {
        let matrix = grid(nodes, components, seed);
        let trailing = (0..matrix.order()).rev().filter(|i| i % 4 == 1).collect();
        (matrix, trailing)
    };
    vec![
        body([6, 5, 4], 3, 21),
        body([11, 9, 1], 2, 22),
        body([1, 1, 1], 1, 23),
    ]
}

fn for_each(test: impl Fn(&str, &dyn BodySolver, &Mat<f64>, &[usize])) {
    for (name, make) in SOLVERS {
        for (matrix, trailing) in bodies() {
            test(name, &*make(&matrix, &trailing), &dense(&matrix), &trailing);
        }
    }
}

#[test]
fn known_solutions_come_back_as_exactly_as_stated() {
    for_each(|name, solver, k, _| {
        assert_eq!(solver.order(), k.nrows(), "{name}");
        let x = Random::new(3).vector(k.nrows());
        let mut found: Vec<f64> = (k * ColRef::from_slice(&x)).iter().copied().collect();
        solver.solve_in_place(&mut found);
        // Strictly dominant matrices: backward and forward error are of one size.
        let off = ColRef::from_slice(&found) - ColRef::from_slice(&x);
        let allowed = 100.0 * solver.accuracy() * ColRef::from_slice(&x).norm_l2();
        assert!(
            off.norm_l2() <= allowed,
            "{name}: {:e} off, {allowed:e} allowed",
            off.norm_l2()
        );
    });
}

#[test]
fn many_at_once_are_the_same_as_one_by_one() {
    for_each(|name, solver, k, _| {
        let n = k.nrows();
        let mut random = Random::new(5);
        let columns = Mat::from_fn(n, 7, |_, _| random.next());
        let mut many = columns.clone();
        solver.solve_many(many.as_mut());
        for j in 0..7 {
            let mut one: Vec<f64> = columns.col(j).iter().copied().collect();
            solver.solve_in_place(&mut one);
            let off = ColRef::from_slice(&one) - many.col(j);
            let allowed = 100.0 * solver.accuracy() * many.col(j).norm_l2();
            assert!(off.norm_l2() <= allowed, "{name}, column {j}");
        }
        solver.solve_many(Mat::zeros(n, 0).as_mut());
    });
}

#[test]
fn solves_repeat_bit_for_bit() {
    for_each(|name, solver, k, _| {
        let f = Random::new(7).vector(k.nrows());
        let solve = || {
            let mut x = f.clone();
            solver.solve_in_place(&mut x);
            x
        };
        assert_eq!(solve(), solve(), "{name}");
    });
}

/// (K⁻¹)_cc by the trailing block is what a solve does to a right-hand side on c.
#[test]
fn the_trailing_block_agrees_with_solves() {
    for_each(|name, solver, k, trailing| {
        let Some(block) = solver.trailing() else {
            return;
        };
        assert_eq!(block.order(), trailing.len(), "{name}");
        let f = Random::new(9).vector(trailing.len());
        let mut whole = vec![0.0; k.nrows()];
        for (&dof, f) in trailing.iter().zip(&f) {
            whole[dof] = *f;
        }
        solver.solve_in_place(&mut whole);
        let mut own = f;
        block.solve_in_place(&mut own);
        let size = own.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        for (&dof, own) in trailing.iter().zip(&own) {
            let off = (whole[dof] - own).abs();
            assert!(off <= 100.0 * solver.accuracy() * size, "{name}: {off:e}");
        }
    });
}

#[test]
fn the_work_is_stated_and_the_accuracy_at_least_rounding() {
    for_each(|name, solver, k, _| {
        let work = solver.work();
        assert!(work.nonzeros >= k.nrows() as u64, "{name}");
        assert!(work.flops >= k.nrows() as f64, "{name}");
        assert!((f64::EPSILON..1.0).contains(&solver.accuracy()), "{name}");
    });
}
