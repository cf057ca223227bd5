//! The work: counts are kept, do not depend on units, and do not creep up.

use crate::common::half_space::HalfSpace;
use crate::common::problems::{Kind, normals, random, rng};
use crate::common::{Plain, distance, norm, settings};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tresca_qcqp::operator::{Dense, LocalModel};
use tresca_qcqp::sets::{Block, BlockSet, Disc, Interval};
use tresca_qcqp::{
    CoulombMethod, DualOperator, DualProblem, DualSolution, InnerSolver, Method, ProductSet,
    Settings, Status, Unobserved, solve,
};

/// Counts the products that really happen, apart from the operator's own counter.
struct Watched {
    inner: Dense,
    seen: Arc<AtomicUsize>,
    explicit: bool,
}

impl DualOperator for Watched {
    fn dim(&self) -> usize {
        self.inner.dim()
    }
    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.seen.fetch_add(1, Ordering::Relaxed);
        self.inner.multiply(x, y);
    }
    fn tally(&mut self) -> &mut tresca_qcqp::Tally {
        self.inner.tally()
    }
    fn local_model(&self) -> LocalModel {
        self.inner.local_model()
    }
    fn explicit(&self) -> Option<&dyn tresca_la::SymmetricEntries> {
        self.inner.explicit().filter(|_| self.explicit)
    }
}

#[test]
fn every_multiplication_is_counted() {
    let plain = random(Kind::Mixed, 15, 1e2, 1);
    let start = normals(&mut rng(2), plain.dim());
    for &method in Method::ALL {
        for (explicit, start) in [(false, None), (true, None), (false, Some(&start[..]))] {
            let seen = Arc::new(AtomicUsize::new(0));
            let inner = Dense::new(plain.packed());
            let operator = Watched {
                inner,
                seen: seen.clone(),
                explicit,
            };
            let mut problem =
                DualProblem::new(operator, plain.b.clone(), plain.set.clone()).unwrap();
            // Twice, to see that the second run does not count the first one's products.
            for first in [true, false] {
                let before = seen.load(Ordering::Relaxed);
                let solution = solve(
                    &mut problem,
                    &settings(method, 1e-8),
                    start.map(Into::into),
                    &mut Unobserved,
                )
                .unwrap();
                assert_eq!(
                    solution.figures.n_a,
                    seen.load(Ordering::Relaxed) - before,
                    "{method}"
                );
                assert_eq!(
                    solution.records.last().unwrap().n_a,
                    solution.figures.n_a,
                    "{method}"
                );
                assert_eq!(solution.records.len(), solution.figures.iterations + 1);
                // What is known of A is not asked for again.
                assert_eq!(solution.figures.n_a_setup > 0, first);
                assert!(solution.figures.n_a_setup <= 12);
            }
        }
    }
}

/// The problem in other units: lengths in 1/`length`, forces in 1/`force` of the old unit.
fn converted(plain: &Plain, length: f64, force: f64) -> Plain {
    let blocks = plain.set.blocks().iter().map(|&block| Block {
        set: match block.set {
            BlockSet::Interval(set) => BlockSet::Interval(Interval {
                bound: set.bound * force,
            }),
            BlockSet::Disc(set) => BlockSet::Disc(Disc {
                bound: set.bound * force,
            }),
            set => set,
        },
        ..block
    });
    Plain {
        a: plain
            .a
            .iter()
            .map(|row| row.iter().map(|a| a * (length / force)).collect())
            .collect(),
        b: plain.b.iter().map(|b| b * length).collect(),
        set: ProductSet::new(plain.dim(), blocks.collect()).unwrap(),
    }
}

#[test]
fn units_change_neither_iterations_nor_products() {
    for (seed, kind) in [Kind::Mixed, Kind::SomeFrictionless, Kind::Everything]
        .into_iter()
        .enumerate()
    {
        let plain = random(kind, 15, 1e2, 500 + seed as u64);
        for &method in Method::ALL {
            for inner_solver in [InnerSolver::Direct, InnerSolver::Iterative] {
                let settings = Settings {
                    inner_solver,
                    ..settings(method, 1e-8)
                };
                let reference = plain.solve(&settings, None);
                // Powers of four change no rounding, roots included: bit for bit the same run.
                let (length, force) = (2f64.powi(40), 2f64.powi(-18));
                let solution = converted(&plain, length, force).solve(&settings, None);
                let scaled: Vec<f64> = reference.lambda.iter().map(|l| l * force).collect();
                assert_eq!(solution.lambda, scaled, "{method}, {kind:?}");
                assert_eq!(work(&solution), work(&reference), "{method}, {kind:?}");
                // m, MN, MPa to mm, N, MPa.
                let (length, force) = (1e3, 1e6);
                let solution = converted(&plain, length, force).solve(&settings, None);
                let scaled: Vec<f64> = reference.lambda.iter().map(|l| l * force).collect();
                assert!(distance(&solution.lambda, &scaled) <= 1e-5 * norm(&scaled));
                let ((iterations, n_a), (expected, expected_n_a)) =
                    (work(&solution), work(&reference));
                assert!(iterations.abs_diff(expected) <= 1, "{method}, {kind:?}");
                assert!(
                    n_a.abs_diff(expected_n_a) as f64 <= 2.0 + 0.02 * expected_n_a as f64,
                    "{method}, {kind:?}, {inner_solver}: {iterations} {n_a}, not {expected} {expected_n_a}"
                );
            }
        }
    }
}

fn work(solution: &DualSolution) -> (usize, usize) {
    (solution.figures.iterations, solution.figures.n_a)
}

/// Counts on one problem. A method that changes on purpose changes the table; a
/// band leaves room for another compiler's rounding.
#[test]
fn work_stays_within_its_band() {
    let plain = random(Kind::Mixed, 40, 1e3, 11);
    let iterative = InnerSolver::Iterative;
    let table = [
        (Method::Ssn, InnerSolver::Auto, 9, 757),
        (Method::Mssn, InnerSolver::Auto, 291, 602),
        (Method::Imssn, InnerSolver::Auto, 278, 1346),
        (Method::Gimssn, InnerSolver::Auto, 310, 1776),
        (Method::Grssn, InnerSolver::Auto, 8, 36),
        (Method::Grssn, iterative, 9, 91),
        (Method::Apgd, InnerSolver::Auto, 150, 162),
    ];
    let mut report = String::new();
    let mut inside = true;
    for (method, inner_solver, iterations, n_a) in table {
        let solution = plain.solve(
            &Settings {
                inner_solver,
                ..settings(method, 1e-8)
            },
            None,
        );
        assert_eq!(solution.status, Status::Converged);
        let within = |found: usize, expected: usize| {
            found.abs_diff(expected) as f64 <= 1.0 + 0.15 * expected as f64
        };
        inside &=
            within(solution.figures.iterations, iterations) && within(solution.figures.n_a, n_a);
        report += &format!(
            "{method} {inner_solver}: {:?}, table {:?}\n",
            work(&solution),
            (iterations, n_a)
        );
    }
    assert!(
        inside,
        "work has left its band (iterations, n_A):\n{report}"
    );
}

/// The same for problems with outer iterations: a floating block, held by Tresca's or Coulomb's law.
#[test]
fn work_of_outer_iterations_stays_within_its_band() {
    let half = HalfSpace::new(10, 0.3);
    let m = half.pairs();
    let mut tresca = half.block([0.2, 0.1, -1.0], 0.3, |p| 0.1 * (p[0] * p[0] + p[1] * p[1]));
    tresca.plain.set = ProductSet::contact_3d(&vec![0.4 / m as f64; m]).unwrap();
    let table = [
        (None, InnerSolver::Direct, 5, 5, 28),
        (None, InnerSolver::Iterative, 5, 8, 83),
        (
            Some(CoulombMethod::FixedPoint),
            InnerSolver::Direct,
            17,
            8,
            49,
        ),
        (
            Some(CoulombMethod::FixedPoint),
            InnerSolver::Iterative,
            21,
            13,
            208,
        ),
        (Some(CoulombMethod::InLoop), InnerSolver::Direct, 5, 7, 36),
        (
            Some(CoulombMethod::InLoop),
            InnerSolver::Iterative,
            5,
            15,
            111,
        ),
    ];
    let (mut report, mut inside) = (String::new(), true);
    for (coulomb, inner_solver, problems, iterations, n_a) in table {
        let mut settings = Settings {
            inner_solver,
            ..Settings::default()
        };
        let mut problem = tresca.problem();
        if let Some(coulomb) = coulomb {
            settings.coulomb = coulomb;
            problem = problem.with_coulomb(half.law(0.5)).unwrap();
        }
        let solution = solve(&mut problem, &settings, None, &mut Unobserved).unwrap();
        assert_eq!(solution.status, Status::Converged);
        let found = 1 + solution.records.last().unwrap().outer;
        let within = |found: usize, expected: usize| {
            found.abs_diff(expected) as f64 <= 1.0 + 0.15 * expected as f64
        };
        inside &= within(found, problems)
            && within(solution.figures.iterations, iterations)
            && within(solution.figures.n_a, n_a);
        report += &format!(
            "{coulomb:?} {inner_solver}: {:?}, table {:?}\n",
            (found, solution.figures.iterations, solution.figures.n_a),
            (problems, iterations, n_a)
        );
    }
    assert!(
        inside,
        "work has left its band (inner problems, iterations, n_A):\n{report}"
    );
}
