//! Numbers of any size: the same iterations, and the answer in the same proportion.

use tresca::algebraic::{self, Dual, Matrix, MatrixProblem, Operator, PairLaw, Solution};
use tresca::{Settings, Silent};

const PAIRS: usize = 4;
const DOFS: usize = 14;

/// What everything is multiplied by.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    force: f64,
    stiffness: f64,
    /// Of the first row of N, and of both rows of T of the last pair.
    rows: [f64; 2],
}

const ONE: Sizes = Sizes {
    force: 1.0,
    stiffness: 1.0,
    rows: [1.0; 2],
};

fn number(i: usize, j: usize, seed: usize) -> f64 {
    let phase = 12.9898 * i as f64 + 78.233 * j as f64 + 37.719 * seed as f64;
    2.0 * (43_758.545 * phase.sin()).rem_euclid(1.0) - 1.0
}

fn solve(sizes: Sizes, law: PairLaw) -> Solution {
    let Sizes {
        force,
        stiffness,
        rows,
    } = sizes;
    let length = force / stiffness;
    let half = |i: usize, j: usize| number(i, j, 1) + if i == j { 3.0 } else { 0.0 };
    let k = |i: usize, j: usize| (0..DOFS).map(|l| half(i, l) * half(j, l)).sum::<f64>();
    let dense = |rows: usize, entry: &dyn Fn(usize, usize) -> f64| {
        let values: Vec<f64> = (0..rows * DOFS)
            .map(|i| entry(i / DOFS, i % DOFS))
            .collect();
        Matrix::from_dense((rows, DOFS), &values).unwrap()
    };
    let n_size = |i: usize| if i == 0 { rows[0] } else { 1.0 };
    let t_size = |i: usize| if i / 2 == PAIRS - 1 { rows[1] } else { 1.0 };
    let problem = MatrixProblem::new(
        vec![dense(DOFS, &|i, j| stiffness * k(i, j))],
        dense(PAIRS, &|i, j| n_size(i) * number(i, j, 2)),
        (0..DOFS).map(|i| 5.0 * force * number(i, 0, 3)).collect(),
    )
    .with_tangential(dense(2 * PAIRS, &|i, j| t_size(i) * number(i, j, 4)))
    .with_gap(
        (0..PAIRS)
            .map(|i| 0.1 * n_size(i) * length * number(i, 0, 5))
            .collect(),
    )
    .with_friction(
        (0..PAIRS)
            .map(|i| scaled(law, force, n_size(i), t_size(2 * i)))
            .collect::<Vec<_>>(),
    );
    algebraic::solve(
        &problem,
        &Settings {
            tolerance: 1e-10,
            ..Settings::default()
        },
        &mut Silent,
    )
    .unwrap()
}

/// The law of forces that count `force` times, divided by the sizes of their rows.
fn scaled(law: PairLaw, force: f64, normal: f64, tangential: f64) -> PairLaw {
    match law {
        PairLaw::Tresca { bound } => PairLaw::tresca(bound * force / tangential),
        PairLaw::Coulomb {
            coefficients,
            limit,
        } => PairLaw::Coulomb {
            coefficients: coefficients.map(|f| f * normal / tangential),
            limit,
        },
        other => other,
    }
}

fn agree(found: &Solution, expected: &Solution, sizes: Sizes) {
    let Sizes {
        force,
        stiffness,
        rows,
    } = sizes;
    assert!(found.converged(), "{sizes:?}: {}", found.status);
    assert_eq!(
        found.figures.iterations, expected.figures.iterations,
        "{sizes:?}"
    );
    assert!(
        found.figures.n_a.abs_diff(expected.figures.n_a) <= 1,
        "{sizes:?}"
    );
    assert!(
        found.certificate.worst() < 1e-6,
        "{sizes:?}: {:?}",
        found.certificate
    );
    let close = |found: f64, expected: f64, unit: f64, what: &str| {
        let found = found / unit;
        assert!(
            (found - expected).abs() < 1e-7 * (1.0 + expected.abs()),
            "{sizes:?}, {what}: {found} is not {expected}"
        );
    };
    for (u, v) in found.displacement.iter().zip(&expected.displacement) {
        close(*u, *v, force / stiffness, "u");
    }
    for (i, (x, y)) in found
        .normal_force
        .iter()
        .zip(&expected.normal_force)
        .enumerate()
    {
        close(
            *x,
            *y,
            force / if i == 0 { rows[0] } else { 1.0 },
            "normal force",
        );
    }
    for (i, (x, y)) in found
        .tangential_force
        .iter()
        .zip(&expected.tangential_force)
        .enumerate()
    {
        close(
            *x,
            *y,
            force / if i / 2 == PAIRS - 1 { rows[1] } else { 1.0 },
            "friction",
        );
    }
}

#[test]
fn numbers_of_any_size_give_the_same_iterations_and_the_answer_in_proportion() {
    let laws = [
        PairLaw::Frictionless,
        PairLaw::tresca(0.3),
        PairLaw::Coulomb {
            coefficients: [0.4; 2],
            limit: f64::INFINITY,
        },
        PairLaw::Tied,
    ];
    for law in laws {
        let expected = solve(ONE, law);
        assert!(
            expected.converged(),
            "{law:?} {} {:?}",
            expected.status,
            expected.notes
        );
        for size in [1e-200, 1e-100, 1e-12, 1e12, 1e100, 1e200] {
            for sizes in [
                Sizes { force: size, ..ONE },
                Sizes {
                    stiffness: size,
                    ..ONE
                },
                Sizes {
                    force: size,
                    stiffness: size,
                    ..ONE
                },
            ] {
                agree(&solve(sizes, law), &expected, sizes);
            }
        }
        // Rows of one size are left alone, rows of many sizes get one: both have to be of the second kind.
        let expected = solve(
            Sizes {
                rows: [1e4, 1e-4],
                ..ONE
            },
            law,
        );
        for rows in [[1e12, 1e12], [1e-12, 1e-12], [1e12, 1e-12], [1e-12, 1e12]] {
            let mut in_proportion = expected.clone();
            in_proportion.normal_force[0] *= 1e4;
            in_proportion.tangential_force[2 * PAIRS - 2..]
                .iter_mut()
                .for_each(|x| *x *= 1e-4);
            agree(
                &solve(Sizes { rows, ..ONE }, law),
                &in_proportion,
                Sizes { rows, ..ONE },
            );
        }
    }
}

#[test]
fn the_dual_form_takes_numbers_of_any_size() {
    let solve = |a: f64, b: f64, bound: f64| {
        let values = [2.0 * a, 0.5 * a, 0.5 * a, a];
        let operator = Operator::dense(2, &values).unwrap();
        let dual = Dual::new(operator, vec![b, b], 1, PairLaw::tresca(bound));
        algebraic::solve_dual(dual, &Settings::default(), &mut Silent).unwrap()
    };
    let expected = solve(1.0, 1.0, 0.2);
    assert!(expected.converged());
    for a in [1e-200, 1e-100, 1.0, 1e100, 1e200] {
        for b in [1e-90, 1.0, 1e90] {
            let found = solve(a, b, 0.2 * b / a);
            assert!(
                found.converged(),
                "{a:e}, {b:e}: {} {:?} {:?}",
                found.status,
                found.failure,
                found.certificate
            );
            assert_eq!(found.figures.n_a, expected.figures.n_a, "{a:e}, {b:e}");
            let force = found.normal_force[0] * (a / b);
            assert!(
                (force - expected.normal_force[0]).abs() < 1e-7,
                "{a:e}, {b:e}: {force}"
            );
        }
    }
}
