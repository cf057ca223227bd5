//! What is wrong with the input is said, and where.

use tresca::algebraic::{
    Dual, Forces, Friction, Kernel, Matrix, MatrixError, MatrixProblem, Operator, PairLaw, solve,
    solve_dual,
};
use tresca::{Settings, Silent};

use super::common::*;

/// The text of the error of a problem with something wrong.
#[track_caller]
fn refused(change: impl FnOnce(&mut MatrixProblem)) -> String {
    let mut problem = random(Laws::Tresca, 2, 0, 2);
    change(&mut problem);
    solve(&problem, &Settings::default(), &mut Silent)
        .unwrap_err()
        .to_string()
}

#[track_caller]
fn assert_says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "no `{part}` in: {message}");
    }
}

#[test]
fn arrays_that_are_no_matrix() {
    let csr = |starts: &[i32], indices: &[i32], values: &[f64]| {
        Matrix::from_csr((2, 3), starts, indices, values).unwrap_err()
    };
    assert!(matches!(
        csr(&[0, 1], &[0], &[1.0]),
        MatrixError::StartCount {
            expected: 3,
            found: 2
        }
    ));
    assert!(matches!(
        csr(&[0, 2, 1], &[0], &[1.0]),
        MatrixError::Starts { .. }
    ));
    assert!(matches!(
        csr(&[0, 0, -1], &[0], &[1.0]),
        MatrixError::Starts { .. }
    ));
    assert!(matches!(
        csr(&[0, 1, 1], &[3], &[1.0]),
        MatrixError::Index {
            entry: 0,
            count: 3,
            ..
        }
    ));
    assert!(matches!(
        csr(&[0, 1, 1], &[-1], &[1.0]),
        MatrixError::Index { .. }
    ));
    assert!(matches!(
        csr(&[0, 1, 1], &[0], &[]),
        MatrixError::ValueCount { .. }
    ));
    assert!(matches!(
        csr(&[0, 1, 1], &[0], &[f64::NAN]),
        MatrixError::NotFinite { .. }
    ));
    assert!(matches!(
        Matrix::from_dense((2, 2), &[1.0; 3]).unwrap_err(),
        MatrixError::ValueCount {
            expected: 4,
            found: 3
        }
    ));
}

#[test]
fn the_same_matrix_from_rows_columns_triplets_and_dense() {
    let dense = Matrix::from_dense((2, 3), &[1.0, 0.0, 2.0, 0.0, 3.0, 4.0]).unwrap();
    let csr =
        Matrix::from_csr((2, 3), &[0_i64, 2, 4], &[2, 0, 1, 2], &[2.0, 1.0, 3.0, 4.0]).unwrap();
    let csc = Matrix::from_csc(
        (2, 3),
        &[0_u32, 1, 2, 4],
        &[0, 1, 1, 0],
        &[1.0, 3.0, 4.0, 2.0],
    )
    .unwrap();
    // One entry twice: they add up.
    let coo = Matrix::from_triplets(
        (2, 3),
        &[1_i32, 0, 1, 0, 1],
        &[2, 0, 1, 2, 2],
        &[3.5, 1.0, 3.0, 2.0, 0.5],
    );
    let twice = Matrix::from_csc(
        (2, 3),
        &[0, 1, 2, 5],
        &[0, 1, 1, 0, 1],
        &[1.0, 3.0, 0.5, 2.0, 3.5],
    );
    assert_eq!(csr, dense);
    assert_eq!(csc, dense);
    assert_eq!(coo.unwrap(), dense);
    assert_eq!(twice.unwrap(), dense);
    assert_eq!(dense.transposed().transposed(), dense);
}

#[test]
fn shapes_and_lengths() {
    assert_says(&refused(|p| p.stiffness.clear()), &["no stiffness"]);
    assert_says(
        &refused(|p| p.stiffness[1] = Matrix::zeros(16, 17)),
        &["block 1", "16 rows", "17 columns"],
    );
    assert_says(
        &refused(|p| p.normal = Matrix::zeros(0, 36)),
        &["N has no rows"],
    );
    assert_says(
        &refused(|p| p.normal = Matrix::zeros(6, 35)),
        &["N is 6 × 35", "m × 36"],
    );
    assert_says(
        &refused(|p| p.tangential = Some(Matrix::zeros(7, 36))),
        &["T is 7 × 36", "6 × 36", "12 × 36"],
    );
    assert_says(
        &refused(|p| p.conditions.load.truncate(3)),
        &["load", "length 3", "expected 36"],
    );
    assert_says(
        &refused(|p| p.conditions.gap = Some(vec![0.0; 5])),
        &["gap", "length 5", "expected 6"],
    );
    assert_says(
        &refused(|p| p.conditions.previous_slip = Some(vec![0.0; 5])),
        &["previous slip", "expected 12"],
    );
    assert_says(
        &refused(|p| p.conditions.friction = Friction::tresca(&[1.0; 4])),
        &["friction laws", "length 4", "expected 6"],
    );
    assert_says(
        &refused(|p| {
            p.conditions.start = Some(Forces {
                normal: vec![0.0; 6],
                ..Forces::default()
            })
        }),
        &["start of the tangential forces", "length 0", "expected 12"],
    );
    assert_says(
        &refused(|p| p.kernel = Kernel::Given(vec![vec![1.0; 3]])),
        &["kernel vector", "length 3"],
    );
    assert_says(
        &refused(|p| p.points = Some(vec![[0.0; 3]; 2])),
        &["points"],
    );
    let b = Matrix::zeros(8, 5);
    let k = Matrix::zeros(5, 5);
    let message = MatrixProblem::stacked(k, &b, 3, vec![0.0; 5])
        .unwrap_err()
        .to_string();
    assert_says(&message, &["B is 8 × 5", "3, 6 or 9 rows"]);
}

#[test]
fn numbers_that_are_none() {
    assert_says(
        &refused(|p| p.conditions.load[4] = f64::NAN),
        &["load", "NaN", "index 4"],
    );
    let gap = |p: &mut MatrixProblem| {
        p.conditions.gap = Some(vec![0.0, f64::INFINITY, 0.0, 0.0, 0.0, 0.0])
    };
    assert_says(&refused(gap), &["gap", "inf", "index 1"]);
    for law in [
        PairLaw::tresca(-1.0),
        PairLaw::tresca(f64::NAN),
        PairLaw::Orthotropic {
            bounds: [1.0, f64::INFINITY],
        },
        PairLaw::coulomb(-0.1),
        PairLaw::Coulomb {
            coefficients: [0.1; 2],
            limit: f64::NAN,
        },
        PairLaw::Bilateral { bound: -1e-300 },
    ] {
        assert_says(
            &refused(|p| p.conditions.friction = law.into()),
            &["pair 0", "≥ 0"],
        );
    }
    // An infinite limit is none.
    let free = random(Laws::Coulomb, 2, 0, 2).with_friction(PairLaw::coulomb(0.2));
    solved(&free, &tight());
    let without = |law: PairLaw| {
        refused(|p| {
            p.tangential = None;
            p.conditions.friction = law.into();
            p.conditions.previous_slip = None;
        })
    };
    assert_says(
        &without(PairLaw::coulomb(0.1)),
        &["`coulomb`", "needs", "T"],
    );
    assert_says(&without(PairLaw::Tied), &["`tied`"]);
}

fn with_entry(matrix: &Matrix, row: usize, column: usize, added: f64) -> Matrix {
    let (mut rows, mut columns, mut values) = (vec![row], vec![column], vec![added]);
    for i in 0..matrix.rows() {
        for (j, value) in matrix.row(i) {
            rows.push(i);
            columns.push(j);
            values.push(value);
        }
    }
    Matrix::from_triplets((matrix.rows(), matrix.columns()), &rows, &columns, &values).unwrap()
}

#[test]
fn asymmetry_is_repaired_when_small_and_refused_when_not() {
    let message = refused(|p| p.stiffness[1] = with_entry(&p.stiffness[1], 2, 5, 0.1));
    assert_says(&message, &["block 1", "not symmetric", "(2, 5)", "(5, 2)"]);
    let triangle = |p: &mut MatrixProblem| {
        let k = &p.stiffness[0];
        let rows: Vec<Vec<f64>> = (0..k.rows())
            .map(|i| {
                let mut row = vec![0.0; k.rows()];
                k.row(i)
                    .filter(|(j, _)| *j <= i)
                    .for_each(|(j, value)| row[j] = value);
                row
            })
            .collect();
        p.stiffness[0] = dense(&rows);
    };
    assert_says(&refused(triangle), &["block 0", "only one triangle"]);

    let mut problem = random(Laws::Tresca, 2, 0, 2);
    let exact = solved(&problem, &tight());
    problem.stiffness[1] = with_entry(&problem.stiffness[1], 2, 5, 1e-10);
    let solution = solved(&problem, &tight());
    assert_close(&solution.displacement, &exact.displacement, 1e-8, "u");
    let notes: Vec<String> = solution.notes.iter().map(ToString::to_string).collect();
    assert!(
        notes
            .iter()
            .any(|note| note.contains("block 1") && note.contains("asymmetry")),
        "{notes:?}"
    );
}

#[test]
fn stiffness_that_is_none() {
    assert_says(
        &refused(|p| p.stiffness[1] = with_entry(&p.stiffness[1], 3, 3, -1e3)),
        &["not positive semidefinite", "dof 23"],
    );
    // Indefinite with a positive diagonal.
    let indefinite = |p: &mut MatrixProblem| {
        p.stiffness[0] = with_entry(&with_entry(&p.stiffness[0], 3, 4, 1e3), 4, 3, 1e3);
    };
    assert_says(
        &refused(indefinite),
        &["not positive semidefinite", "negative eigenvalue"],
    );
    assert_says(
        &refused(|p| {
            p.stiffness.push(Matrix::zeros(1, 1));
            p.conditions.load.push(0.0);
            p.normal =
                Matrix::from_triplets((6, 37), &[0, 1, 2, 3, 4, 5], &[0, 1, 2, 3, 4, 5], &[1.0; 6])
                    .unwrap();
            p.tangential = None;
            p.conditions.previous_slip = None;
            p.conditions.friction = PairLaw::Frictionless.into();
        }),
        &["dof 36", "not held"],
    );
}

#[test]
fn kernels_that_are_none_or_not_all() {
    let mut problem = random(Laws::Tresca, 2, 3, 2);
    let mut wrong = vec![0.0; 36];
    wrong[30] = 1.0;
    problem.kernel = Kernel::Given(vec![wrong]);
    let message = solve(&problem, &Settings::default(), &mut Silent)
        .unwrap_err()
        .to_string();
    assert_says(&message, &["kernel vector 0"]);
    problem.kernel = Kernel::Given(Vec::new());
    let message = solve(&problem, &Settings::default(), &mut Silent)
        .unwrap_err()
        .to_string();
    assert_says(&message, &["singular beyond the kernel", "dof 20"]);
}

#[test]
fn rows_that_are_zero_carry_no_force() {
    let mut problem = random(Laws::Tresca, 2, 0, 2);
    let mut rows = Vec::new();
    let t = problem.tangential.as_ref().unwrap();
    for i in 0..t.rows() {
        let mut row = vec![0.0; t.columns()];
        if i != 3 {
            t.row(i).for_each(|(j, value)| row[j] = value);
        }
        rows.push(row);
    }
    problem.tangential = Some(dense(&rows));
    let solution = solved(&problem, &tight());
    assert_eq!(solution.tangential_force[3], 0.0);
    let notes: Vec<String> = solution.notes.iter().map(ToString::to_string).collect();
    assert!(
        notes
            .iter()
            .any(|note| note.contains("zero") && note.contains("T[3]")),
        "{notes:?}"
    );
    assert_says(
        &refused(|p| {
            p.normal = Matrix::zeros(6, 36);
            p.tangential = Some(Matrix::zeros(12, 36));
        }),
        &["every row", "zero"],
    );
}

#[test]
fn dual_problems_that_are_none() {
    let refused = |operator: Operator, rhs: Vec<f64>, tangents: usize| {
        let dual = Dual::new(operator, rhs, tangents, PairLaw::tresca(1.0));
        solve_dual(dual, &Settings::default(), &mut Silent)
            .unwrap_err()
            .to_string()
    };
    let Err(error) = Operator::dense(2, &[1.0, 0.0, 0.5, 1.0]) else {
        panic!("not symmetric")
    };
    assert_says(&error.to_string(), &["not symmetric", "(1, 0)"]);
    let Err(error) = Operator::dense(2, &[1.0; 3]) else {
        panic!("too short")
    };
    assert_says(&error.to_string(), &["A has length 3", "expected 4"]);
    let identity = || Operator::dense(3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
    assert_says(
        &refused(identity(), vec![1.0; 2], 2),
        &["right-hand side b", "length 2"],
    );
    assert_says(
        &refused(identity(), vec![1.0; 3], 1),
        &["A is 3 × 3", "order of 2 per contact pair"],
    );
    let negative = Operator::product(3, |x, y| y.iter_mut().zip(x).for_each(|(y, x)| *y = -x));
    assert_says(
        &refused(negative, vec![1.0; 3], 2),
        &["not positive semidefinite"],
    );
    let broken = Operator::product(3, |_, y| y.fill(f64::NAN));
    assert_says(&refused(broken, vec![1.0; 3], 2), &["NaN"]);
}
