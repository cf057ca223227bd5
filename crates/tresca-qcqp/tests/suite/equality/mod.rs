//! Floating bodies: Gλ = e against Clarabel and against statics.

mod chains;
mod no_equilibrium;

use crate::common::half_space::{Floating, HalfSpace};
use crate::common::problems::{Kind, geometric_spectrum, normals, random, rng, with_spectrum};
use crate::common::{distance, dot, norm, oracle, settings};
use std::ops::ControlFlow;
use tresca_qcqp::sets::{Block, BlockSet};
use tresca_qcqp::{
    DualSolution, Equality, InnerSolver, IterationRecord, Method, ProductSet, QcqpError, Settings,
    Start, Status, Unobserved, solve,
};

/// A random problem with `count` random rows; e is what a random λ ∈ Λ gives, times `beyond`.
fn random_floating(kind: Kind, count: usize, beyond: f64, seed: u64) -> Floating {
    let plain = random(kind, 10, 1e2, seed);
    let rng = &mut rng(1000 + seed);
    let n = plain.dim();
    let rows: Vec<Vec<f64>> = (0..count).map(|_| normals(rng, n)).collect();
    let mut inside = normals(rng, n);
    plain.set.project(&mut inside);
    // Not at the edge of what is possible.
    inside.iter_mut().for_each(|l| *l *= 0.5 * beyond);
    let rhs = rows.iter().map(|row| dot(row, &inside)).collect();
    let metric = with_spectrum(rng, &geometric_spectrum(count, 20.0));
    Floating::new(plain.a, plain.b, plain.set, Equality { rows, rhs, metric })
}

/// The conditions of the problem, without any code of the methods.
fn assert_solves(floating: &Floating, solution: &DualSolution, tolerance: f64, what: &str) {
    assert_eq!(solution.status, Status::Converged, "{what}");
    let plain = &floating.plain;
    assert!(plain.set.contains(&solution.lambda), "{what}: not feasible");
    let mut gradient = plain.mul(&solution.lambda);
    for (i, r) in gradient.iter_mut().enumerate() {
        *r -= plain.b[i];
        for (row, alpha) in floating.equality.rows.iter().zip(&solution.multiplier) {
            *r -= alpha * row[i];
        }
    }
    let scale = norm(&plain.b).max(1.0);
    assert!(
        distance(&gradient, &solution.gradient) <= 1e-10 * scale,
        "{what}: gradient"
    );
    // Without an estimate any ρ will do.
    let rho = if solution.figures.sigma_max > 0.0 {
        1.0 / solution.figures.sigma_max
    } else {
        1.0
    };
    let mut y: Vec<f64> = solution
        .lambda
        .iter()
        .zip(&gradient)
        .map(|(l, r)| l - rho * r)
        .collect();
    plain.set.project(&mut y);
    let reduced = distance(&y, &solution.lambda) / rho;
    assert!(
        reduced <= 10.0 * tolerance * scale,
        "{what}: reduced gradient {reduced:.1e}"
    );
    let off = norm(&floating.residual(&solution.lambda));
    assert!(
        off <= 100.0 * tolerance * norm(&floating.equality.rhs).max(1.0),
        "{what}: Gλ − e = {off:.1e}"
    );
    let q = plain.objective(&solution.lambda);
    assert!(
        (q - solution.figures.objective).abs() <= 1e-9 * q.abs().max(1.0),
        "{what}: objective"
    );
}

#[test]
fn every_kind_agrees_with_the_conic_solver() {
    let kinds = [
        Kind::Mixed,
        Kind::SomeFrictionless,
        Kind::Frictionless,
        Kind::TinyBounds,
        Kind::AllStick,
        Kind::AllOpen,
        Kind::TwoDimensional,
        Kind::Everything,
    ];
    for (seed, kind) in kinds.into_iter().enumerate() {
        for count in [1, 3, 5] {
            let floating = random_floating(kind, count, 1.0, 50 + 10 * seed as u64 + count as u64);
            let Equality { rows, rhs, .. } = &floating.equality;
            let reference = oracle::constrained_minimiser(&floating.plain, rows, rhs).unwrap();
            for method in [Method::Grssn, Method::Apgd, Method::Gimssn] {
                for inner_solver in [InnerSolver::Direct, InnerSolver::Iterative] {
                    let what = format!("{method}, {inner_solver}, {kind:?}, {count} rows");
                    let settings = Settings {
                        inner_solver,
                        ..settings(method, 1e-9)
                    };
                    let solution =
                        solve(&mut floating.problem(), &settings, None, &mut Unobserved).unwrap();
                    assert_solves(&floating, &solution, 1e-9, &what);
                    assert_eq!(solution.multiplier.len(), count);
                    assert!(solution.figures.equality_residual <= 1e-9, "{what}");
                    let off = distance(&solution.lambda, &reference) / norm(&reference).max(1.0);
                    // Bounds far away are hard for the conic solver.
                    let allowed = if kind == Kind::AllStick { 1e-2 } else { 1e-5 };
                    assert!(off <= allowed, "{what}: off by {off:.1e}");
                    let gap = solution.figures.objective - floating.plain.objective(&reference);
                    let size = solution.figures.objective.abs().max(1.0);
                    assert!(gap <= 1e-7 * size, "{what}: objective higher by {gap:.1e}");
                    assert!(gap >= -1e-4 * size, "{what}: objective lower by {gap:.1e}");
                }
            }
        }
    }
}

#[test]
fn a_distant_block_lands_as_a_near_one() {
    let half = HalfSpace::new(8, 0.3);
    let m = half.pairs();
    let solve_at = |gap: f64| {
        let mut floating = half.block([0.2, 0.05, -1.0], 0.4, |p| {
            gap + 0.1 * (p[0] * p[0] + p[1] * p[1])
        });
        floating.plain.set = ProductSet::contact_3d(&vec![0.5 / m as f64; m]).unwrap();
        let settings = Settings {
            inner_solver: InnerSolver::Iterative,
            ..Settings::default()
        };
        let solution = solve(&mut floating.problem(), &settings, None, &mut Unobserved).unwrap();
        assert_eq!(solution.status, Status::Converged, "gap {gap}");
        solution
    };
    let near = solve_at(0.0);
    assert!(
        near.figures.outer_iterations <= 8 && near.figures.n_a <= 130,
        "{} {}",
        near.figures.outer_iterations,
        near.figures.n_a
    );
    for gap in [-0.3, 1e-3, 10.0, 1e4] {
        let far = solve_at(gap);
        assert!(
            distance(&far.lambda, &near.lambda) <= 1e-5 * norm(&near.lambda),
            "gap {gap}"
        );
        // The block has moved down by just that much more.
        assert!((far.multiplier[2] + gap - near.multiplier[2]).abs() <= 1e-6 * gap.abs().max(1.0));
        assert!(
            far.figures.n_a <= near.figures.n_a + 40,
            "gap {gap}: {} products, not {}",
            far.figures.n_a,
            near.figures.n_a
        );
    }
}

#[test]
fn without_load_nothing_is_pressed() {
    let half = HalfSpace::new(5, 0.3);
    let m = half.pairs();
    // Apart, touching in one point, touching everywhere, and pushed into the half-space.
    for (number, gap) in [0.1, 0.0, 0.0, -0.02].into_iter().enumerate() {
        let curved = if number == 2 { 0.0 } else { 0.3 };
        let mut floating = half.block([0.0; 3], 0.0, |p| {
            gap + curved * (p[0] * p[0] + p[1] * p[1])
        });
        for bounds in [0.0, 0.02] {
            floating.plain.set = ProductSet::contact_3d(&vec![bounds; m]).unwrap();
            for inner_solver in [InnerSolver::Direct, InnerSolver::Iterative] {
                let settings = Settings {
                    inner_solver,
                    ..Settings::default()
                };
                let solution =
                    solve(&mut floating.problem(), &settings, None, &mut Unobserved).unwrap();
                assert_solves(
                    &floating,
                    &solution,
                    1e-8,
                    &format!("case {number}, bounds {bounds}"),
                );
                assert!(
                    norm(&solution.lambda) <= 1e-7,
                    "case {number}: {:.1e}",
                    norm(&solution.lambda)
                );
                // No point is left inside of the half-space.
                let deepest = solution.gradient[..m]
                    .iter()
                    .copied()
                    .fold(f64::INFINITY, f64::min);
                assert!(deepest >= -1e-8, "case {number}: {deepest:.1e}");
            }
        }
    }
}

#[test]
fn a_second_solve_starts_where_the_first_one_ended() {
    let half = HalfSpace::new(6, 0.3);
    let m = half.pairs();
    let mut floating = half.block([0.1, 0.0, -1.0], 0.2, |p| 0.1 * (p[0] * p[0] + p[1] * p[1]));
    floating.plain.set = ProductSet::contact_3d(&vec![0.5 / m as f64; m]).unwrap();
    let mut problem = floating.problem();
    let settings = Settings {
        inner_solver: InnerSolver::Iterative,
        ..Settings::default()
    };
    let first = solve(&mut problem, &settings, None, &mut Unobserved).unwrap();
    let again = solve(
        &mut problem,
        &settings,
        Some(Start::from(&first)),
        &mut Unobserved,
    )
    .unwrap();
    assert_eq!((again.figures.n_a_setup, again.figures.iterations), (0, 0));
    assert_eq!(again.status, Status::Converged);

    // A heavier block: new e, new b, the old solution as a start.
    let heavier = half.block([0.1, 0.0, -1.1], 0.2, |p| 0.1 * (p[0] * p[0] + p[1] * p[1]));
    problem.set_equality_rhs(&heavier.equality.rhs).unwrap();
    problem.set_rhs(heavier.plain.b.clone()).unwrap();
    let warm = solve(
        &mut problem,
        &settings,
        Some(Start::from(&first)),
        &mut Unobserved,
    )
    .unwrap();
    let heavier = Floating {
        plain: crate::common::Plain {
            set: floating.plain.set.clone(),
            ..heavier.plain
        },
        ..heavier
    };
    assert_solves(&heavier, &warm, 1e-8, "warm");
    let cold = solve(&mut heavier.problem(), &settings, None, &mut Unobserved).unwrap();
    assert!(distance(&warm.lambda, &cold.lambda) <= 1e-6 * norm(&cold.lambda));
    assert!(
        warm.figures.n_a < cold.figures.n_a,
        "{} and {}",
        warm.figures.n_a,
        cold.figures.n_a
    );
}

#[test]
fn units_change_neither_counts_nor_verdicts() {
    let half = HalfSpace::new(6, 0.3);
    let m = half.pairs();
    for share in [0.8, 1.001] {
        let build = |length: f64, force: f64| {
            let mut floating = half.block([0.4 * share, 0.0, -1.0], 0.1, |_| 0.0);
            let Equality { rows, rhs, metric } = &mut floating.equality;
            // Rotations stay radians, so their rows are lengths and their resultants moments.
            let row = |i: usize| if i < 3 { 1.0 } else { length };
            for i in 0..6 {
                rows[i].iter_mut().for_each(|g| *g *= row(i));
                rhs[i] *= row(i) * force;
                for (j, entry) in metric[i].iter_mut().enumerate() {
                    *entry *= length / force / row(i) / row(j);
                }
            }
            let plain = &mut floating.plain;
            plain
                .a
                .iter_mut()
                .flatten()
                .for_each(|a| *a *= length / force);
            plain.b.iter_mut().for_each(|b| *b *= length);
            plain.set = ProductSet::contact_3d(&vec![0.4 * force / m as f64; m]).unwrap();
            floating
        };
        for inner_solver in [InnerSolver::Direct, InnerSolver::Iterative] {
            let settings = Settings {
                inner_solver,
                ..Settings::default()
            };
            let run = |floating: Floating| {
                solve(&mut floating.problem(), &settings, None, &mut Unobserved).unwrap()
            };
            let reference = run(build(1.0, 1.0));
            assert_eq!(reference.status == Status::NoEquilibrium, share > 1.0);
            for (length, force) in [(2f64.powi(40), 2f64.powi(-18)), (1e3, 1e6)] {
                let solution = run(build(length, force));
                assert_eq!(solution.status, reference.status);
                assert!(
                    solution
                        .figures
                        .iterations
                        .abs_diff(reference.figures.iterations)
                        <= 1
                );
                assert!(
                    solution.figures.n_a.abs_diff(reference.figures.n_a) <= 6,
                    "{} and {}",
                    solution.figures.n_a,
                    reference.figures.n_a
                );
                let scaled: Vec<f64> = reference.lambda.iter().map(|l| l * force).collect();
                assert!(distance(&solution.lambda, &scaled) <= 1e-5 * norm(&scaled));
            }
        }
    }
}

#[test]
fn records_run_on_and_the_observer_can_stop_anywhere() {
    let half = HalfSpace::new(5, 0.3);
    let m = half.pairs();
    let mut floating = half.block([0.2, 0.0, -1.0], 0.2, |p| 0.1 * (p[0] * p[0] + p[1] * p[1]));
    floating.plain.set = ProductSet::contact_3d(&vec![0.5 / m as f64; m]).unwrap();
    let whole = solve(
        &mut floating.problem(),
        &Settings::default(),
        None,
        &mut Unobserved,
    )
    .unwrap();
    for (k, pair) in whole.records.windows(2).enumerate() {
        assert_eq!(pair[0].iteration, k);
        assert!(pair[1].n_a >= pair[0].n_a);
        assert!(pair[1].outer == pair[0].outer || pair[1].outer == pair[0].outer + 1);
    }
    let problems = whole.records.last().unwrap().outer + 1;
    assert_eq!(whole.figures.iterations + problems, whole.records.len());
    for stop in 0..whole.records.len() - 1 {
        let mut seen = Vec::new();
        let mut observer = |record: &IterationRecord| {
            seen.push(record.clone());
            if record.iteration == stop {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let solution = solve(
            &mut floating.problem(),
            &Settings::default(),
            None,
            &mut observer,
        )
        .unwrap();
        // A frozen problem that has just converged is not the end: the request stands.
        assert_eq!(solution.status, Status::Interrupted, "at {stop}");
        assert_eq!(seen, solution.records);
        assert_eq!(seen.len(), stop + 1);
        assert!(floating.plain.set.contains(&solution.lambda));
    }
    let limited = Settings {
        max_outer_iterations: 1,
        ..Settings::default()
    };
    let solution = solve(&mut floating.problem(), &limited, None, &mut Unobserved).unwrap();
    assert_eq!(solution.status, Status::IterationLimit);
    let limited = Settings {
        max_iterations: 2,
        ..Settings::default()
    };
    let solution = solve(&mut floating.problem(), &limited, None, &mut Unobserved).unwrap();
    assert_eq!(
        (solution.status, solution.figures.iterations),
        (Status::IterationLimit, 2)
    );
}

#[test]
fn wrong_constraints_are_refused() {
    let base = random_floating(Kind::Mixed, 2, 1.0, 9);
    let refusal = |change: &dyn Fn(&mut Equality)| {
        let mut equality = base.equality.clone();
        change(&mut equality);
        base.plain.problem().with_equality(&equality).err().unwrap()
    };
    let error = refusal(&|e| e.rhs.push(0.0));
    assert_eq!(
        error.to_string(),
        "the right-hand side e has length 3, but the equality constraint has 2 rows"
    );
    assert!(matches!(
        refusal(&|e| e.rows[0].truncate(3)),
        QcqpError::Dimension { found: 3, .. }
    ));
    assert!(matches!(
        refusal(&|e| e.rows[1][2] = f64::NAN),
        QcqpError::NotFinite { index: 2, .. }
    ));
    assert_eq!(refusal(&|e| e.metric[0][0] = -1.0), QcqpError::Metric);
    assert_eq!(refusal(&|e| e.metric[0][1] += 1.0), QcqpError::Metric);
    assert_eq!(refusal(&|e| e.metric[0][0] = f64::NAN), QcqpError::Metric);
    let lambda = vec![0.0; base.plain.dim()];
    let start = Start {
        lambda: &lambda,
        multiplier: &[0.0; 5],
    };
    let error = solve(
        &mut base.problem(),
        &Settings::default(),
        Some(start),
        &mut Unobserved,
    )
    .unwrap_err();
    assert!(matches!(
        error,
        QcqpError::Rows {
            expected: 2,
            found: 5,
            ..
        }
    ));
    // A block of bound 0 beside lines: the set of another problem is refused.
    let other = ProductSet::new(
        1,
        vec![Block {
            start: 0,
            set: BlockSet::HalfLine(tresca_qcqp::sets::HalfLine),
        }],
    )
    .unwrap();
    assert!(base.problem().set_set(other).is_err());
}
