//! How runs end, and what is refused at the door.

use crate::common::problems::{Kind, random};
use crate::common::{dot, settings};
use faer::Mat;
use std::ops::ControlFlow;
use tresca_la::PackedLower;
use tresca_qcqp::operator::{Dense, LocalModel};
use tresca_qcqp::sets::{Block, BlockSet, Disc, HalfLine};
use tresca_qcqp::{
    DualOperator, DualProblem, IterationRecord, Method, ProductSet, QcqpError, Settings, Status,
    Unobserved, solve,
};

#[test]
fn an_unconverged_run_says_so_and_returns_its_best_feasible_point() {
    let plain = random(Kind::Mixed, 15, 1e4, 1);
    for &method in Method::ALL {
        for limit in [0, 2] {
            let settings = Settings {
                max_iterations: limit,
                ..settings(method, 1e-12)
            };
            let solution = plain.solve(&settings, None);
            assert_eq!(solution.status, Status::IterationLimit, "{method}");
            assert!(!solution.status.is_converged());
            assert_eq!(solution.figures.iterations, limit);
            assert!(plain.set.contains(&solution.lambda));
            let best = solution
                .records
                .iter()
                .map(|r| r.relative_reduced_gradient)
                .fold(9.0, f64::min);
            assert_eq!(solution.figures.relative_reduced_gradient, best);
            let seen =
                plain.relative_reduced_gradient(&solution.lambda, 1.0 / solution.figures.sigma_max);
            assert!(
                (seen - best).abs() <= 1e-9,
                "{method}: {seen} is not {best}"
            );
        }
    }
}

#[test]
fn a_tolerance_below_rounding_stagnates() {
    let plain = random(Kind::Mixed, 10, 1e3, 2);
    for method in [Method::Ssn, Method::Mssn, Method::Grssn, Method::Apgd] {
        let solution = plain.solve(&settings(method, 1e-30), None);
        assert_eq!(solution.status, Status::Stagnated, "{method}");
        assert!(
            solution.figures.relative_reduced_gradient <= 1e-12,
            "{method}"
        );
    }
}

#[test]
fn the_observer_sees_every_iteration_and_can_stop() {
    let plain = random(Kind::Mixed, 15, 1e3, 3);
    for &method in Method::ALL {
        let mut seen = Vec::new();
        let mut observer = |record: &IterationRecord| {
            seen.push(record.clone());
            if record.iteration == 2 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let solution = solve(
            &mut plain.problem(),
            &settings(method, 1e-12),
            None,
            &mut observer,
        )
        .unwrap();
        assert_eq!(solution.status, Status::Interrupted, "{method}");
        assert_eq!(seen, solution.records);
        assert_eq!(seen.len(), 3);
        assert!(plain.set.contains(&solution.lambda));
        for (k, record) in seen.iter().enumerate() {
            assert_eq!(record.iteration, k);
            let counts = record.counts;
            assert_eq!(counts.open + counts.closed, 15);
            assert_eq!(counts.stick + counts.slip, 15);
        }
        let drop = seen[1].objective - seen[2].objective;
        assert!(
            (drop - seen[2].decrease).abs() <= 1e-9 * seen[0].objective.abs().max(1.0),
            "{method}"
        );
    }
}

#[test]
fn what_is_returned_belongs_together() {
    let plain = random(Kind::SomeFrictionless, 15, 1e2, 4);
    for &method in Method::ALL {
        let solution = plain.solve(&settings(method, 1e-10), None);
        let gradient: Vec<f64> = plain
            .mul(&solution.lambda)
            .iter()
            .zip(&plain.b)
            .map(|(a, b)| a - b)
            .collect();
        let off = crate::common::distance(&gradient, &solution.gradient);
        assert!(
            off <= 1e-11 * crate::common::norm(&plain.b),
            "{method}: gradient off by {off:.1e}"
        );
        let q = 0.5 * (dot(&solution.lambda, &gradient) - dot(&solution.lambda, &plain.b));
        assert!((q - solution.figures.objective).abs() <= 1e-12 * q.abs());
        for (block, state) in plain.set.blocks().iter().zip(solution.active_set.states()) {
            let x = &solution.lambda[block.range()];
            match block.set {
                BlockSet::HalfLine(_) => {
                    assert_eq!(x[0] > 0.0, *state == tresca_qcqp::sets::BlockState::Free);
                }
                BlockSet::Disc(Disc { bound: 0.0 }) => assert_eq!(x, [0.0, 0.0]),
                BlockSet::Disc(Disc { bound }) => {
                    let on_circle = x[0].hypot(x[1]) >= bound * (1.0 - 1e-9);
                    assert_eq!(on_circle, *state == tresca_qcqp::sets::BlockState::Bound);
                }
                _ => unreachable!(),
            }
        }
    }
}

/// An operator that breaks after some products.
struct Breaking {
    inner: Dense,
    left: usize,
}

impl DualOperator for Breaking {
    fn dim(&self) -> usize {
        self.inner.dim()
    }
    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.inner.multiply(x, y);
        match self.left.checked_sub(1) {
            Some(left) => self.left = left,
            None => y[0] = f64::NAN,
        }
    }
    fn tally(&mut self) -> &mut tresca_qcqp::Tally {
        self.inner.tally()
    }
    fn local_model(&self) -> LocalModel {
        self.inner.local_model()
    }
}

#[test]
fn a_product_that_is_not_finite_is_caught_at_once() {
    let plain = random(Kind::Mixed, 15, 1e3, 5);
    let run = |method, left| {
        let operator = Breaking {
            inner: Dense::new(plain.packed()),
            left,
        };
        let mut problem = DualProblem::new(operator, plain.b.clone(), plain.set.clone()).unwrap();
        solve(
            &mut problem,
            &settings(method, 1e-12),
            None,
            &mut Unobserved,
        )
    };
    for &method in Method::ALL {
        assert!(
            matches!(
                run(method, 2),
                Err(QcqpError::OperatorNotFinite { index: 0, .. })
            ),
            "{method}"
        );
        let solution = run(method, 30).unwrap();
        assert_eq!(solution.status, Status::Diverged, "{method}");
        assert!(solution.lambda.iter().all(|l| l.is_finite()));
        assert!(solution.figures.relative_reduced_gradient.is_finite());
        assert!(plain.set.contains(&solution.lambda));
        assert!(
            solution.figures.n_a < 200,
            "{method}: {} products after the first NaN",
            solution.figures.n_a
        );
    }
}

#[test]
fn wrong_input_is_refused_with_the_place() {
    let set = |bounds: &[f64]| ProductSet::contact_3d(bounds);
    assert_eq!(
        set(&[1.0, -2.0]),
        Err(QcqpError::Bound {
            block: 3,
            value: -2.0
        })
    );
    assert!(matches!(
        set(&[f64::NAN]),
        Err(QcqpError::Bound { block: 1, .. })
    ));
    let half_line = |start| Block {
        start,
        set: BlockSet::HalfLine(HalfLine),
    };
    assert_eq!(
        ProductSet::new(2, vec![half_line(0)]),
        Err(QcqpError::Cover { index: 1, found: 0 })
    );
    assert_eq!(
        ProductSet::new(1, vec![half_line(0), half_line(0)]),
        Err(QcqpError::Cover { index: 0, found: 2 })
    );
    assert!(matches!(
        ProductSet::new(1, vec![half_line(1)]),
        Err(QcqpError::BlockRange {
            block: 0,
            dimension: 1
        })
    ));

    let plain = random(Kind::Mixed, 2, 10.0, 6);
    let dense = || Dense::new(plain.packed());
    let error = DualProblem::new(dense(), vec![0.0; 5], plain.set.clone())
        .err()
        .unwrap();
    assert_eq!(
        error.to_string(),
        "the right-hand side b has length 5, but the dual operator has order 6"
    );
    let mut b = plain.b.clone();
    b[4] = f64::INFINITY;
    let error = DualProblem::new(dense(), b, plain.set.clone())
        .err()
        .unwrap();
    assert_eq!(
        error.to_string(),
        "the right-hand side b holds inf at index 4: every entry must be finite"
    );
    let other = set(&[1.0]).unwrap();
    assert!(matches!(
        DualProblem::new(dense(), plain.b.clone(), other)
            .err()
            .unwrap(),
        QcqpError::Dimension {
            expected: 6,
            found: 3,
            ..
        }
    ));
    let start = [f64::NAN; 6];
    let error = solve(
        &mut plain.problem(),
        &Settings::default(),
        Some(start[..].into()),
        &mut Unobserved,
    )
    .unwrap_err();
    assert!(matches!(
        error,
        QcqpError::NotFinite {
            what: "the start",
            index: 0,
            ..
        }
    ));
}

#[test]
fn operators_that_cannot_be_dual_operators_are_refused() {
    /// Any matrix at all.
    struct Any(Mat<f64>, tresca_qcqp::Tally);
    impl DualOperator for Any {
        fn dim(&self) -> usize {
            self.0.nrows()
        }
        fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
            for (i, y) in y.iter_mut().enumerate() {
                *y = (0..x.len()).map(|j| self.0[(i, j)] * x[j]).sum();
            }
        }
        fn tally(&mut self) -> &mut tresca_qcqp::Tally {
            &mut self.1
        }
        fn local_model(&self) -> LocalModel {
            LocalModel::Diagonal(vec![1.0; self.dim()])
        }
    }
    let refusal = |entry: &dyn Fn(usize, usize) -> f64| {
        let set = ProductSet::contact_3d(&[1.0; 3]).unwrap();
        let operator = Any(Mat::from_fn(9, 9, entry), Default::default());
        let mut problem = DualProblem::new(operator, vec![1.0; 9], set).unwrap();
        solve(&mut problem, &Settings::default(), None, &mut Unobserved).unwrap_err()
    };
    assert_eq!(refusal(&|_, _| 0.0), QcqpError::ZeroOperator);
    let skew = |i: usize, j: usize| {
        if i == j {
            2.0
        } else if i < j {
            0.3
        } else {
            -0.3
        }
    };
    assert!(matches!(refusal(&skew), QcqpError::NotSymmetric { .. }));
    let negative = |i: usize, j: usize| {
        if i != j {
            0.0
        } else if i == 4 {
            -3.0
        } else {
            1.0
        }
    };
    assert!(matches!(refusal(&negative), QcqpError::NotPositive { .. }));
}

#[test]
fn the_packed_matrix_is_the_matrix() {
    let plain = random(Kind::Mixed, 5, 10.0, 8);
    let x = crate::common::problems::normals(&mut crate::common::problems::rng(1), 15);
    let mut y = vec![0.0; 15];
    PackedLower::symmetric_mul(&plain.packed(), &x, &mut y);
    assert!(crate::common::distance(&y, &plain.mul(&x)) <= 1e-13);
}
