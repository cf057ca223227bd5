//! All methods against each other, against Clarabel, and against closed forms.

use crate::common::problems::{KINDS, Kind, random, rng};
use crate::common::{Plain, distance, norm, oracle, settings};
use tresca_qcqp::sets::{Block, BlockSet, Disc, HalfLine, Origin};
use tresca_qcqp::{
    DualSolution, InnerSolver, Method, ProductSet, Settings, Status, Unobserved, solve,
};

const GLOBAL: [Method; 3] = [Method::Gimssn, Method::Grssn, Method::Apgd];

/// Whether a method must converge, and not only be right if it does.
fn must_converge(method: Method, condition: f64) -> bool {
    GLOBAL.contains(&method) || condition <= 10.0
}

fn assert_solves(plain: &Plain, solution: &DualSolution, tolerance: f64, what: &str) {
    assert_eq!(solution.status, Status::Converged, "{what}");
    assert!(plain.set.contains(&solution.lambda), "{what}: not feasible");
    let seen = plain.relative_reduced_gradient(&solution.lambda, 1.0 / solution.figures.sigma_max);
    let floor = 1e-13 * norm(&plain.b);
    assert!(
        seen <= 1.01 * tolerance + floor,
        "{what}: reduced gradient {seen:.2e}"
    );
    assert!(
        (seen - solution.figures.relative_reduced_gradient).abs() <= 1e-3 * tolerance + floor,
        "{what}"
    );
}

#[test]
fn every_method_finds_the_minimiser_of_the_conic_solver() {
    let tolerance = 1e-9;
    for (seed, kind) in KINDS.into_iter().enumerate() {
        for condition in [1e1, 1e3] {
            let plain = random(kind, 12, condition, 7 + seed as u64);
            let reference = oracle::minimiser(&plain);
            let scale = norm(&reference).max(1.0);
            for &method in Method::ALL {
                let what = format!("{method}, {kind:?}, condition {condition:.0e}");
                let solution = plain.solve(&settings(method, tolerance), None);
                if solution.status != Status::Converged {
                    assert!(
                        !must_converge(method, condition),
                        "{what}: {}",
                        solution.status
                    );
                    continue;
                }
                if kind != Kind::AllOpen {
                    assert_solves(&plain, &solution, tolerance, &what);
                }
                let off = distance(&solution.lambda, &reference) / scale;
                assert!(off <= 1e-8 * condition, "{what}: off by {off:.2e}");
                let gap = plain.objective(&solution.lambda) - plain.objective(&reference);
                assert!(
                    gap.abs() <= 1e-9 * scale * norm(&plain.b),
                    "{what}: objective off by {gap:.2e}"
                );
            }
        }
    }
}

#[test]
fn global_methods_solve_ill_conditioned_problems_from_any_start() {
    for (seed, kind) in KINDS.into_iter().enumerate() {
        let plain = random(kind, 8, 1e5, 40 + seed as u64);
        for scale in [0.0, 1.0, 1e3] {
            let mut start = crate::common::problems::normals(&mut rng(seed as u64), plain.dim());
            start.iter_mut().for_each(|s| *s *= scale);
            for method in [Method::Grssn, Method::Apgd] {
                let solution = plain.solve(&settings(method, 1e-8), Some(&start));
                let what = format!("{method}, {kind:?}, start of size {scale}");
                if kind != Kind::AllOpen {
                    assert_solves(&plain, &solution, 1e-8, &what);
                } else {
                    assert_eq!(solution.status, Status::Converged, "{what}");
                }
            }
        }
    }
}

/// A cantilever pressed on a foundation that it lifts off from: one soft bending motion governs σmax, local
/// compliances are a million times smaller, and a projected gradient step moves next to nothing.
#[test]
fn bending_does_not_stop_the_default_method() {
    let count = 120;
    let place = |i: usize| (i + 1) as f64 / count as f64;
    // Deflection at x of a unit force at ξ: x²(3ξ − x)/6EI for x ≤ ξ (EI = 1).
    let deflection = |i: usize, j: usize| {
        let (x, xi) = (place(i.min(j)), place(i.max(j)));
        x * x * (3.0 * xi - x) / 6.0
    };
    let entry = |i, j| deflection(i, j) + if i == j { 1e-6 } else { 0.0 };
    let a: Vec<Vec<f64>> = (0..count)
        .map(|i| (0..count).map(|j| entry(i, j)).collect())
        .collect();
    let blocks = (0..count).map(|start| Block {
        start,
        set: BlockSet::HalfLine(HalfLine),
    });
    let set = ProductSet::new(count, blocks.collect()).unwrap();
    let mut plain = Plain {
        a,
        b: Vec::new(),
        set,
    };
    // Pressed near its middle, pulled up at the free end, over a foundation that is 0.002 away.
    let load: Vec<f64> = (0..count)
        .map(|i| match place(i) {
            x if x > 0.9 => -0.05,
            x if x > 0.4 => 0.03,
            _ => 0.0,
        })
        .collect();
    plain.b = plain.mul(&load);
    plain.b.iter_mut().for_each(|b| *b -= 0.002);
    for inner_solver in [InnerSolver::Iterative, InnerSolver::Direct] {
        let settings = Settings {
            inner_solver,
            ..settings(Method::Grssn, 1e-9)
        };
        let solution = plain.solve(&settings, None);
        assert_solves(&plain, &solution, 1e-9, "cantilever");
        assert!(
            solution.figures.iterations <= 15,
            "{} steps",
            solution.figures.iterations
        );
        let reference = oracle::minimiser(&plain);
        let (own, theirs) = (
            plain.objective(&solution.lambda),
            plain.objective(&reference),
        );
        assert!(
            own <= theirs + 1e-6 * theirs.abs(),
            "{own:e} against {theirs:e}"
        );
    }
}

#[test]
fn newton_methods_need_few_steps_and_less_than_the_gradient_method() {
    for seed in 0..6 {
        let plain = random(Kind::Mixed, 20, 1e3, 100 + seed);
        let newton = plain.solve(&settings(Method::Grssn, 1e-10), None);
        let gradient = plain.solve(
            &Settings {
                inner_solver: InnerSolver::Iterative,
                ..settings(Method::Apgd, 1e-10)
            },
            None,
        );
        assert!(
            newton.figures.iterations <= 15,
            "{} steps",
            newton.figures.iterations
        );
        assert!(
            newton.figures.n_a < gradient.figures.n_a,
            "{} and {} products",
            newton.figures.n_a,
            gradient.figures.n_a
        );
        let iterative = Settings {
            inner_solver: InnerSolver::Iterative,
            ..settings(Method::Grssn, 1e-10)
        };
        let iterative = plain.solve(&iterative, None);
        assert!(
            iterative.figures.iterations <= 15,
            "{} steps",
            iterative.figures.iterations
        );
        assert!(
            iterative.figures.n_a < gradient.figures.n_a,
            "{} and {} products",
            iterative.figures.n_a,
            gradient.figures.n_a
        );
        assert!(distance(&iterative.lambda, &newton.lambda) <= 1e-6 * norm(&newton.lambda));
    }
}

#[test]
fn one_pair_has_its_closed_form() {
    // A = I: the solution is the projection of b.
    let identity = |n: usize| -> Vec<Vec<f64>> {
        (0..n)
            .map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect())
            .collect()
    };
    let cases = [
        ([2.0, 3.0, 4.0], 1.0, [2.0, 0.6, 0.8]),
        ([-2.0, 3.0, 4.0], 10.0, [0.0, 3.0, 4.0]),
        ([-2.0, 0.0, 0.0], 1.0, [0.0, 0.0, 0.0]),
        ([1.0, 3.0, 4.0], 0.0, [1.0, 0.0, 0.0]),
    ];
    for (b, bound, expected) in cases {
        let set = ProductSet::contact_3d(&[bound]).unwrap();
        let plain = Plain {
            a: identity(3),
            b: b.to_vec(),
            set,
        };
        for &method in Method::ALL {
            let solution = plain.solve(&settings(method, 1e-12), None);
            assert_eq!(solution.status, Status::Converged, "{method}");
            assert!(
                distance(&solution.lambda, &expected) <= 1e-11,
                "{method}: {:?}",
                solution.lambda
            );
        }
    }
    // One dimension of friction, coupled to the normal: min x² + xy + y² − 3x − 3y, x ≥ 0, |y| ≤ ½.
    let a = vec![vec![2.0, 1.0], vec![1.0, 2.0]];
    let plain = Plain {
        a,
        b: vec![3.0, 3.0],
        set: ProductSet::contact_2d(&[0.5]).unwrap(),
    };
    for &method in Method::ALL {
        let solution = plain.solve(&settings(method, 1e-12), None);
        assert!(
            distance(&solution.lambda, &[1.25, 0.5]) <= 1e-11,
            "{method}: {:?}",
            solution.lambda
        );
    }
}

#[test]
fn a_problem_solved_by_zero_costs_nothing() {
    for b in [vec![0.0; 6], vec![-1.0, -2.0, 0.0, 0.0, 0.0, 0.0]] {
        let mut plain = random(Kind::Mixed, 2, 10.0, 3);
        plain.b = b;
        for &method in Method::ALL {
            let solution = plain.solve(&settings(method, 1e-10), None);
            assert_eq!(solution.status, Status::Converged);
            assert_eq!((solution.figures.n_a, solution.figures.iterations), (0, 0));
            assert_eq!(solution.lambda, [0.0; 6]);
            assert_eq!(solution.figures.relative_reduced_gradient, 0.0);
        }
    }
}

#[test]
fn the_exact_method_in_two_dimensions_ends_after_finitely_many_steps() {
    // Intervals have no curvature: once the sets are right, one linear solve is exact.
    for seed in 0..5 {
        let plain = random(Kind::TwoDimensional, 15, 1e3, 60 + seed);
        let solution = plain.solve(&settings(Method::Grssn, 1e-6), None);
        assert_eq!(solution.status, Status::Converged);
        assert!(
            solution.figures.relative_reduced_gradient <= 1e-12,
            "the last step left {:.1e}",
            solution.figures.relative_reduced_gradient
        );
    }
}

#[test]
fn a_semidefinite_operator_is_survived() {
    // Rank 2/3: the forces are not unique, the objective is.
    let rng = &mut rng(5);
    let mut spectrum = crate::common::problems::geometric_spectrum(18, 50.0);
    spectrum[12..].fill(0.0);
    let a = crate::common::problems::with_spectrum(rng, &spectrum);
    let set = ProductSet::contact_3d(&[0.4, 0.0, 1.0, 0.7, 0.2, 2.0]).unwrap();
    let mut plain = Plain {
        a,
        b: Vec::new(),
        set,
    };
    plain.b = plain.mul(&crate::common::problems::normals(rng, 18));
    let objectives: Vec<f64> = [Method::Grssn, Method::Gimssn, Method::Apgd]
        .map(|method| {
            let solution = plain.solve(&settings(method, 1e-9), None);
            assert_eq!(solution.status, Status::Converged, "{method}");
            plain.objective(&solution.lambda)
        })
        .to_vec();
    assert!((objectives[0] - objectives[1]).abs() <= 1e-9 * objectives[0].abs());
    assert!((objectives[0] - objectives[2]).abs() <= 1e-9 * objectives[0].abs());
}

/// Unknowns that move nothing: zero rows of A, with a point as their set and any b.
#[test]
fn unknowns_without_effect_are_harmless() {
    for seed in 0..3 {
        let plain = random(Kind::Everything, 8, 50.0, 700 + seed);
        let n = plain.dim();
        let mut padded = plain.clone();
        for (number, b) in [3.0, -2.0, 0.0].into_iter().enumerate() {
            padded.a.iter_mut().for_each(|row| row.push(0.0));
            padded.a.push(vec![0.0; n + number + 1]);
            padded.b.push(b);
        }
        let mut blocks = plain.set.blocks().to_vec();
        let point = BlockSet::Origin(Origin);
        blocks.insert(
            2,
            Block {
                start: n,
                set: point,
            },
        );
        blocks.insert(
            0,
            Block {
                start: n + 1,
                set: BlockSet::Disc(Disc { bound: 0.0 }),
            },
        );
        padded.set = ProductSet::new(n + 3, blocks).unwrap();
        for &method in Method::ALL {
            for inner_solver in [InnerSolver::Direct, InnerSolver::Iterative] {
                let settings = Settings {
                    inner_solver,
                    ..settings(method, 1e-9)
                };
                let (small, large) = (plain.solve(&settings, None), padded.solve(&settings, None));
                assert_eq!(small.status, large.status, "{method}");
                if small.status.is_converged() {
                    assert_eq!(large.lambda[n..], [0.0; 3]);
                    let off = distance(&small.lambda, &large.lambda[..n]);
                    assert!(off <= 1e-6 * norm(&small.lambda), "{method}: {off:.1e}");
                }
            }
        }
        // A half-line or a disc without effect stays where its start puts it.
        let mut blocks = plain.set.blocks().to_vec();
        blocks.push(Block {
            start: n,
            set: BlockSet::HalfLine(HalfLine),
        });
        blocks.push(Block {
            start: n + 1,
            set: BlockSet::Disc(Disc { bound: 1.0 }),
        });
        padded.set = ProductSet::new(n + 3, blocks).unwrap();
        padded.b[n..].fill(0.0);
        for method in [Method::Grssn, Method::Apgd] {
            let solution = padded.solve(&settings(method, 1e-9), None);
            assert_eq!(solution.status, Status::Converged, "{method}");
        }
    }
}

/// With intervals only and exact inner solves the last step is exact, and comes soon.
#[test]
fn finite_termination_leaves_rounding_only() {
    for seed in 0..20 {
        let plain = random(Kind::TwoDimensional, 20, 1e3, 800 + seed);
        for method in [Method::Grssn, Method::Mssn] {
            let settings = Settings {
                inner_solver: InnerSolver::Direct,
                ..settings(method, 1e-6)
            };
            let solution = plain.solve(&settings, None);
            if method == Method::Mssn && solution.status == Status::Stagnated {
                // Without globalisation it may cycle.
                continue;
            }
            assert_eq!(solution.status, Status::Converged, "{method}, {seed}");
            let [.., before, last] = &solution.records[..] else {
                panic!("one step at least")
            };
            assert!(
                solution.figures.iterations < 15,
                "{method}, {seed}: {} steps",
                solution.figures.iterations
            );
            assert!(before.relative_reduced_gradient > 1e-6);
            assert!(
                last.relative_reduced_gradient <= 1e-13,
                "{method}, {seed}: {:.1e}",
                last.relative_reduced_gradient
            );
        }
    }
}

/// Ellipses λ1²/g1² + λ2²/g2² ≤ 1 by λ = Dμ: the slip is normal to the ellipse.
#[test]
fn scaled_rows_give_ellipses_with_the_associated_law() {
    let m = 10;
    let plain = random(Kind::Mixed, m, 50.0, 31);
    let axes: Vec<[f64; 2]> = (0..m)
        .map(|i| [0.2 + 0.1 * i as f64, 1.1 - 0.1 * i as f64])
        .collect();
    let scale = |i: usize| {
        if i < m {
            1.0
        } else {
            axes[(i - m) / 2][(i - m) % 2]
        }
    };
    let scaled = Plain {
        a: (0..3 * m)
            .map(|i| {
                (0..3 * m)
                    .map(|j| scale(i) * plain.a[i][j] * scale(j))
                    .collect()
            })
            .collect(),
        b: (0..3 * m).map(|i| scale(i) * plain.b[i]).collect(),
        set: ProductSet::contact_3d(&vec![1.0; m]).unwrap(),
    };
    let solution = scaled.solve(&settings(Method::Grssn, 1e-11), None);
    assert_eq!(solution.status, Status::Converged);
    let lambda: Vec<f64> = (0..3 * m).map(|i| scale(i) * solution.lambda[i]).collect();
    let slip: Vec<f64> = plain
        .mul(&lambda)
        .iter()
        .zip(&plain.b)
        .map(|(a, b)| b - a)
        .collect();
    let mut slipping = 0;
    for (i, &[g1, g2]) in axes.iter().enumerate() {
        let (l, u) = (&lambda[m + 2 * i..][..2], &slip[m + 2 * i..][..2]);
        let level = (l[0] / g1).hypot(l[1] / g2);
        assert!(level <= 1.0 + 1e-12);
        let size = u[0].hypot(u[1]);
        if size <= 1e-9 {
            continue;
        }
        slipping += 1;
        assert!(level >= 1.0 - 1e-9);
        let normal = [l[0] / (g1 * g1), l[1] / (g2 * g2)];
        let cross = (u[0] * normal[1] - u[1] * normal[0]) / (size * normal[0].hypot(normal[1]));
        assert!(
            cross.abs() <= 1e-6,
            "pair {i} slips off the normal by {cross:.1e}"
        );
        assert!(u[0] * l[0] + u[1] * l[1] > 0.0, "friction opposes slip");
    }
    assert!(slipping >= 3);
}

/// What is learnt about A serves another b and another Λ.
#[test]
fn a_second_problem_on_the_same_operator_pays_for_no_estimate() {
    let plain = random(Kind::Mixed, 20, 1e3, 900);
    let other = random(Kind::Mixed, 20, 1e3, 901);
    for &method in Method::ALL {
        let settings = Settings {
            inner_solver: InnerSolver::Iterative,
            ..settings(method, 1e-8)
        };
        let mut problem = plain.problem();
        let first = solve(&mut problem, &settings, None, &mut Unobserved).unwrap();
        assert!(first.figures.n_a_setup > 0);
        problem.set_rhs(other.b.clone()).unwrap();
        problem.set_set(other.set.clone()).unwrap();
        let second = solve(&mut problem, &settings, None, &mut Unobserved).unwrap();
        let fresh = Plain {
            b: other.b.clone(),
            set: other.set.clone(),
            ..plain.clone()
        };
        let fresh = fresh.solve(&settings, None);
        assert_eq!(
            (second.status, second.figures.n_a_setup),
            (fresh.status, 0),
            "{method}"
        );
        if second.status.is_converged() {
            assert!(
                distance(&second.lambda, &fresh.lambda) <= 1e-4 * norm(&fresh.lambda),
                "{method}"
            );
            assert!(
                second.figures.n_a < fresh.figures.n_a,
                "{method}: {} and {}",
                second.figures.n_a,
                fresh.figures.n_a
            );
        }
    }
    assert!(plain.problem().set_rhs(vec![0.0; 3]).is_err());
}
