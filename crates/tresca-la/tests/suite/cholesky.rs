//! Orderings, sparse factor and trailing block against dense linear algebra.

use crate::common::{Random, assert_close, dense, from_triplets, grid};
use faer::linalg::solvers::Solve;
use faer::sparse::Triplet;
use faer::{Mat, Side};
use tresca_la::{
    BodySolver, FactorError, Ordering, OrderingError, Parallelism, SparseCholesky, SymmetricMatrix,
};

/// Grids whose dofs are few, many, 1, 2 and 3 per node; one without any edge,
/// one of two parts that do not touch, one of order 1.
fn matrices() -> Vec<(&'static str, SymmetricMatrix)> {
    let diagonal: Vec<_> = (0..5).map(|i| Triplet::new(i, i, 2.0)).collect();
    let mut halves = Vec::new();
    let part = grid([4, 4, 1], 2, 4);
    for shift in [0, part.order()] {
        for j in 0..part.order() {
            for (i, &v) in part
                .lower()
                .row_idx_of_col(j)
                .zip(part.lower().val_of_col(j))
            {
                halves.push(Triplet::new(i + shift, j + shift, v));
            }
        }
    }
    vec![
        ("chain", grid([40, 1, 1], 1, 1)),
        ("plate", grid([9, 8, 1], 2, 2)),
        ("brick", grid([6, 5, 4], 3, 3)),
        ("diagonal", from_triplets(5, &diagonal)),
        ("two parts", from_triplets(2 * part.order(), &halves)),
        ("one dof", grid([1, 1, 1], 1, 5)),
    ]
}

/// Trailing dofs: none, one, a scattered third out of order, all.
fn trailing_choices(n: usize) -> Vec<Vec<usize>> {
    vec![
        vec![],
        vec![n / 2],
        (0..n).rev().filter(|i| i % 3 == 1).collect(),
        (0..n).rev().collect(),
    ]
}

fn factor(matrix: &SymmetricMatrix, trailing: &[usize]) -> SparseCholesky {
    let ordering = Ordering::nested_dissection_with_trailing(matrix, trailing).unwrap();
    SparseCholesky::factor(matrix, ordering, Parallelism::Sequential).unwrap()
}

#[test]
fn orderings_are_permutations_with_the_trailing_dofs_last() {
    for (name, matrix) in matrices() {
        let n = matrix.order();
        for trailing in trailing_choices(n) {
            let ordering = Ordering::nested_dissection_with_trailing(&matrix, &trailing).unwrap();
            let mut sorted = ordering.to_original().to_vec();
            sorted.sort_unstable();
            assert!(sorted.into_iter().eq(0..n), "{name}");
            assert_eq!(ordering.trailing(), trailing.len());
            assert_eq!(&ordering.to_original()[n - trailing.len()..], trailing);
            for (new, &old) in ordering.to_original().iter().enumerate() {
                assert_eq!(ordering.from_original()[old], new);
            }
            let again = Ordering::nested_dissection_with_trailing(&matrix, &trailing).unwrap();
            assert_eq!(ordering.to_original(), again.to_original(), "{name}");
        }
    }
}

#[test]
fn concurrent_orderings_agree_with_lone_ones() {
    let matrix = grid([12, 12, 6], 1, 6);
    let alone = Ordering::nested_dissection(&matrix).unwrap();
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..4)
            .map(|_| scope.spawn(|| Ordering::nested_dissection(&matrix).unwrap()))
            .collect();
        for worker in workers {
            assert_eq!(worker.join().unwrap().to_original(), alone.to_original());
        }
    });
}

#[test]
fn nested_dissection_keeps_the_factor_sparse() {
    let matrix = grid([12, 12, 12], 1, 7);
    let natural = SparseCholesky::factor(
        &matrix,
        Ordering::natural(matrix.order()),
        Parallelism::Sequential,
    )
    .unwrap();
    let dissected = factor(&matrix, &[]);
    assert!(dissected.work().flops < 0.5 * natural.work().flops);
    assert!(dissected.work().nonzeros < natural.work().nonzeros);
    // The band of the natural ordering is known: nx ny + nx + 1 below the diagonal.
    assert!(natural.work().nonzeros <= (1728 * 158) as u64);
}

#[test]
fn trailing_faces_are_cut_off_first_where_that_pays() {
    // Operations with the face z = 0 last, over those of the plain ordering.
    let ratio = |nodes: [usize; 3]| {
        let matrix = grid(nodes, 1, 18);
        let face: Vec<usize> = (0..nodes[0] * nodes[1]).collect();
        factor(&matrix, &face).work().flops / factor(&matrix, &[]).work().flops
    };
    // Dissection that knows nothing of the face takes 1.72 here.
    let brick = ratio([14, 14, 14]);
    assert!(brick < 1.65, "{brick}");
    // Cut parallel to the face, this plate would take 7.6.
    let plate = ratio([20, 20, 7]);
    assert!(plate < 3.5, "{plate}");
}

#[test]
fn wrong_trailing_dofs_are_named() {
    let matrix = grid([3, 3, 1], 1, 8);
    let out = Ordering::nested_dissection_with_trailing(&matrix, &[1, 9]);
    assert_eq!(
        out.unwrap_err(),
        OrderingError::TrailingOutOfRange { dof: 9, order: 9 }
    );
    let twice = Ordering::nested_dissection_with_trailing(&matrix, &[4, 2, 4]);
    assert_eq!(
        twice.unwrap_err(),
        OrderingError::TrailingRepeated { dof: 4 }
    );
}

#[test]
fn solves_agree_with_dense_cholesky() {
    for (name, matrix) in matrices() {
        let n = matrix.order();
        let b = Random::new(9).vector(n);
        let column = Mat::from_fn(n, 1, |i, _| b[i]);
        let solution = dense(&matrix).llt(Side::Lower).unwrap().solve(&column);
        let expected: Vec<f64> = (0..n).map(|i| solution[(i, 0)]).collect();
        for trailing in trailing_choices(n) {
            let factor = factor(&matrix, &trailing);
            let mut x = b.clone();
            factor.solve_in_place(&mut x);
            assert_close(&x, &expected, 1e-13);
            let mut back = vec![0.0; n];
            matrix.mul(&x, &mut back);
            assert_close(&back, &b, 1e-13);
            assert_eq!(factor.order(), n, "{name}");
        }
    }
}

#[test]
fn trailing_block_is_the_factor_of_the_dense_schur_complement() {
    for (name, matrix) in matrices() {
        let full = dense(&matrix);
        let n = matrix.order();
        for c in trailing_choices(n) {
            let m = c.len();
            let block = factor(&matrix, &c).trailing().unwrap();
            assert_eq!(block.order(), m);
            // S = K_cc − K_cr K_rr⁻¹ K_rc, dense.
            let r: Vec<usize> = (0..n).filter(|i| !c.contains(i)).collect();
            let pick = |rows: &[usize], columns: &[usize]| {
                Mat::from_fn(rows.len(), columns.len(), |i, j| {
                    full[(rows[i], columns[j])]
                })
            };
            let coupling = pick(&r, &c);
            let interior = pick(&r, &r).llt(Side::Lower).unwrap();
            let schur = pick(&c, &c) - coupling.transpose() * interior.solve(&coupling);
            let expected = schur.llt(Side::Lower).unwrap();
            let factor = block.factor().to_dense();
            let inverse = block.inverse(Parallelism::Sequential);
            let dense_inverse = full
                .llt(Side::Lower)
                .unwrap()
                .solve(Mat::<f64>::identity(n, n));
            let x = Random::new(10).vector(m);
            let mut solved = x.clone();
            block.solve_in_place(&mut solved);
            for i in 0..m {
                let row: f64 = (0..m).map(|j| inverse[(i, j)] * x[j]).sum();
                assert!((row - solved[i]).abs() < 1e-12, "{name}");
                for j in 0..m {
                    assert!(
                        (factor[(i, j)] - expected.L()[(i, j)]).abs() < 1e-12,
                        "{name}"
                    );
                    let k = dense_inverse[(c[i], c[j])];
                    assert!((inverse[(i, j)] - k).abs() < 1e-13, "{name}");
                }
            }
        }
    }
}

#[test]
fn work_counts_are_those_of_the_factor() {
    // Full matrix: every column j of L has n − j entries.
    let n = 20;
    let matrix = grid([n, 1, 1], 1, 11);
    let chain = factor(&matrix, &[]);
    // A chain eliminates without fill from its ends.
    assert!(chain.work().nonzeros <= (3 * n) as u64);
    let full = grid([2, 2, 2], 3, 12);
    let counts = factor(&full, &[]);
    assert_eq!(counts.work().nonzeros, 24 * 25 / 2);
    assert_eq!(counts.work().flops, (24 * 25 * 49 / 6) as f64);
}

#[test]
fn threads_change_rounding_at_most() {
    let matrix = grid([12, 11, 8], 3, 13);
    let c: Vec<usize> = (0..396).collect();
    let ordering = Ordering::nested_dissection_with_trailing(&matrix, &c).unwrap();
    let solve = |parallelism| {
        let factor = SparseCholesky::factor(&matrix, ordering.clone(), parallelism).unwrap();
        let mut x = Random::new(14).vector(matrix.order());
        factor.solve_in_place(&mut x);
        let mut y = Random::new(15).vector(c.len());
        factor.trailing().unwrap().solve_in_place(&mut y);
        x.extend(y);
        x
    };
    let sequential = solve(Parallelism::Sequential);
    assert_eq!(sequential, solve(Parallelism::Sequential));
    for threads in [0, 2, 3] {
        assert_close(&solve(Parallelism::Threads(threads)), &sequential, 1e-14);
    }
}

#[test]
fn the_dof_of_a_bad_pivot_is_named_in_original_numbering() {
    for (bad, value) in [(17, 0.0), (3, -4.0), (58, f64::NAN)] {
        let good = grid([5, 4, 3], 1, 16);
        let mut triplets = Vec::new();
        for j in 0..good.order() {
            for (i, &v) in good
                .lower()
                .row_idx_of_col(j)
                .zip(good.lower().val_of_col(j))
            {
                // The bad dof is cut off from the rest, so that no other pivot can fail.
                let v = match (i == bad, j == bad) {
                    (true, true) => value,
                    (false, false) => v,
                    _ => 0.0,
                };
                triplets.push(Triplet::new(i, j, v));
            }
        }
        let matrix = from_triplets(good.order(), &triplets);
        let ordering = Ordering::nested_dissection(&matrix).unwrap();
        let error = SparseCholesky::factor(&matrix, ordering, Parallelism::Sequential).unwrap_err();
        // An unknown value spreads to whatever is eliminated after it.
        if !value.is_nan() {
            assert_eq!(error, FactorError::NotPositiveDefinite { dof: bad });
        }
        assert!(matches!(error, FactorError::NotPositiveDefinite { .. }));
    }
}

#[test]
fn ordering_of_another_matrix_is_refused() {
    let matrix = grid([3, 3, 1], 1, 17);
    let error = SparseCholesky::factor(&matrix, Ordering::natural(8), Parallelism::Sequential);
    assert_eq!(
        error.unwrap_err(),
        FactorError::OrderMismatch {
            ordering: 8,
            matrix: 9
        }
    );
}

#[test]
fn empty_matrix_is_factored() {
    let matrix = from_triplets(0, &[]);
    let factor = factor(&matrix, &[]);
    factor.solve_in_place(&mut []);
    assert_eq!(factor.trailing().unwrap().order(), 0);
    assert_eq!(factor.work().flops, 0.0);
}
