//! Singular A: rows that repeat, that depend on each other, that contradict each other.

use crate::common::{Plain, dot, norm, settings};
use faer::Mat;
use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use tresca_qcqp::sets::{Block, BlockSet, Disc, HalfLine, Line};
use tresca_qcqp::{Method, ProductSet, Status};

fn half_lines(count: usize) -> ProductSet {
    of(count, BlockSet::HalfLine(HalfLine))
}

fn lines(count: usize) -> ProductSet {
    of(count, BlockSet::Line(Line))
}

fn of(count: usize, set: BlockSet) -> ProductSet {
    let block = |start| Block { start, set };
    ProductSet::new(count, (0..count).map(block).collect()).unwrap()
}

/// A = B K⁻¹ Bᵀ and b = B K⁻¹ f − d for a diagonal K.
fn posed(rows: &[Vec<f64>], k: &[f64], f: &[f64], gaps: &[f64], set: ProductSet) -> Plain {
    let entry = |x: &[f64], y: &[f64]| (0..k.len()).map(|i| x[i] * y[i] / k[i]).sum::<f64>();
    Plain {
        a: rows
            .iter()
            .map(|x| rows.iter().map(|y| entry(x, y)).collect())
            .collect(),
        b: rows
            .iter()
            .zip(gaps)
            .map(|(x, d)| entry(x, f) - d)
            .collect(),
        set,
    }
}

#[test]
fn of_a_row_that_stands_twice_the_smaller_gap_holds() {
    // u₁ ≤ −0.41 and u₁ ≤ −0.4: the first one alone acts, with 2 · (0.5 + 0.41) less f.
    let rows = vec![vec![1.0, 0.3]; 2];
    let plain = posed(
        &rows,
        &[2.0, 1.0],
        &[1.0, 0.2],
        &[-0.41, -0.4],
        half_lines(2),
    );
    for &method in Method::ALL {
        let solution = plain.solve(&settings(method, 1e-10), None);
        assert_eq!(solution.status, Status::Converged, "{method}");
        let force = plain.b[0] / plain.a[0][0];
        assert!(
            (solution.lambda[0] - force).abs() < 1e-8 * force,
            "{method}"
        );
        assert!(solution.lambda[1].abs() < 1e-8 * force, "{method}");
    }
}

#[test]
fn ties_that_agree_share_their_force() {
    for noise in [0.0, 1e-16, 1e-14, 1e-13, 1e-12, 1e-11] {
        let gaps = [0.1, 0.1 + noise, 0.1 - noise];
        let rows = vec![vec![1.0, 0.0]; 3];
        let plain = posed(&rows, &[2.0, 1.0], &[1.0, 1.0], &gaps, lines(3));
        for &method in Method::ALL {
            let solution = plain.solve(&settings(method, 1e-8), None);
            assert_eq!(solution.status, Status::Converged, "{method}, {noise}");
            let sum: f64 = solution.lambda.iter().sum();
            assert!((sum - 0.8).abs() < 1e-6, "{method}, {noise}: {sum}");
            assert!(
                norm(&solution.lambda) < 1.0,
                "{method}: {:?}",
                solution.lambda
            );
        }
    }
}

#[test]
fn ties_that_contradict_each_other_are_infeasible_with_a_proof() {
    for noise in [1e-8, 1e-6, 1e-3, 1.0] {
        let gaps = [0.1, 0.1 + noise, 0.1 - noise];
        let rows = vec![vec![1.0, 0.0]; 3];
        let plain = posed(&rows, &[2.0, 1.0], &[1.0, 1.0], &gaps, lines(3));
        for &method in Method::ALL {
            let solution = plain.solve(&settings(method, 1e-10), None);
            assert_eq!(solution.status, Status::Infeasible, "{method}, {noise}");
            proves(&plain, &solution.contradiction.unwrap());
        }
    }
}

#[test]
fn a_body_squeezed_by_more_than_there_is_room_is_infeasible() {
    let mut rng = StdRng::seed_from_u64(7);
    for _ in 0..100 {
        let k = rng.random_range(0.1..10.0);
        let gaps = [rng.random_range(-1.0..-0.01), rng.random_range(-1.0..-0.01)];
        let f = rng.random_range(-1.0..1.0);
        let rows = [vec![1.0], vec![-1.0]];
        let plain = posed(&rows, &[k], &[f], &gaps, half_lines(2));
        for &method in Method::ALL {
            let solution = plain.solve(&settings(method, 1e-8), None);
            assert_eq!(solution.status, Status::Infeasible, "{method}");
            proves(&plain, &solution.contradiction.unwrap());
        }
    }
}

#[test]
fn dependent_rows_with_a_solution_are_solved_by_every_method() {
    let mut solved = 0;
    for seed in 0..200 {
        let mut rng = StdRng::seed_from_u64(seed);
        let dofs = rng.random_range(1..6);
        let rows = rng.random_range(2..10);
        let k: Vec<f64> = (0..dofs).map(|_| rng.random_range(0.1..10.0)).collect();
        let f: Vec<f64> = (0..dofs).map(|_| rng.random_range(-1.0..1.0)).collect();
        let b: Vec<Vec<f64>> = (0..rows)
            .map(|_| (0..dofs).map(|_| rng.random_range(-1.0..1.0)).collect())
            .collect();
        // Gaps that one displacement leaves open or just closes.
        let u: Vec<f64> = (0..dofs).map(|_| rng.random_range(-1.0..1.0)).collect();
        let room = |rng: &mut StdRng| f64::max(rng.random_range(-0.3..0.3), 0.0);
        let gaps: Vec<f64> = b.iter().map(|row| dot(row, &u) + room(&mut rng)).collect();
        let plain = posed(&b, &k, &f, &gaps, half_lines(rows));
        let reference = plain.solve(&settings(Method::Apgd, 1e-9), None);
        let expected = plain.objective(&reference.lambda);
        for &method in Method::ALL {
            let solution = plain.solve(&settings(method, 1e-9), None);
            assert_eq!(solution.status, Status::Converged, "{method}, seed {seed}");
            let found = plain.objective(&solution.lambda);
            assert!(
                (found - expected).abs() <= 1e-6 * (1.0 + expected.abs()),
                "{method}, seed {seed}: {found} is not {expected}"
            );
            solved += 1;
        }
    }
    assert_eq!(solved, 200 * Method::ALL.len());
}

/// y ≥ 0 (where forces must be), Ay = 0, bᵀy > 0.
fn proves(plain: &Plain, y: &[f64]) {
    let mut inside = y.to_vec();
    plain.set.project(&mut inside);
    assert_eq!(inside, y);
    assert!((norm(y) - 1.0).abs() < 1e-12);
    assert!(norm(&plain.mul(y)) < 1e-10);
    assert!(dot(&plain.b, y) > 1e-9 * norm(&plain.b));
}

/// A of low rank with a condition of up to 1e5 in its range, b in the range, forces over twelve decades.
fn low_rank(seed: u64, glued: bool) -> Plain {
    let mut rng = StdRng::seed_from_u64(seed);
    let pairs = rng.random_range(1..25);
    let order = 3 * pairs;
    let rank = rng.random_range(f64::max(1.0, order as f64 / 3.0) as usize..=order);
    let scale = 10_f64.powf(rng.random_range(-6.0..6.0));
    let force = 10_f64.powf(rng.random_range(-6.0..6.0));
    let condition = rng.random_range(0.5..5.0);
    let random = Mat::from_fn(order, order, |_, _| rng.random_range(-1.0..1.0));
    let q = random.qr().compute_Q();
    let e: Vec<f64> = (0..rank)
        .map(|_| 10_f64.powf(rng.random_range(-condition..0.0)))
        .collect();
    let entry = |i: usize, j: usize| {
        let sum: f64 = (0..rank).map(|k| q[(i, k)] * e[k] * q[(j, k)]).sum();
        scale * sum
    };
    let a: Vec<Vec<f64>> = (0..order)
        .map(|i| (0..order).map(|j| entry(i.max(j), i.min(j))).collect())
        .collect();
    let x: Vec<f64> = (0..order)
        .map(|_| force * rng.random_range(-1.0..1.0))
        .collect();
    let b: Vec<f64> = a.iter().map(|row| dot(row, &x)).collect();
    let mut blocks = Vec::new();
    for pair in 0..pairs {
        let tied = glued && rng.random_range(0.0..1.0) < 0.5;
        let bound = force * 10_f64.powf(rng.random_range(-2.0..1.0));
        let start = 3 * pair;
        let normal = if tied {
            BlockSet::Line(Line)
        } else {
            BlockSet::HalfLine(HalfLine)
        };
        blocks.push(Block { start, set: normal });
        if tied {
            blocks.extend([1, 2].map(|k| Block {
                start: start + k,
                set: BlockSet::Line(Line),
            }));
        } else {
            blocks.push(Block {
                start: start + 1,
                set: BlockSet::Disc(Disc { bound }),
            });
        }
    }
    Plain {
        a,
        b,
        set: ProductSet::new(order, blocks).unwrap(),
    }
}

#[test]
fn a_of_low_rank_is_solved() {
    for seed in 0..300 {
        let plain = low_rank(seed, seed % 2 == 0);
        for method in [Method::Grssn, Method::Apgd] {
            let settings = tresca_qcqp::Settings {
                max_iterations: 1000,
                ..settings(method, 1e-8)
            };
            let solution = plain.solve(&settings, None);
            if method == Method::Apgd && solution.status == Status::IterationLimit {
                continue;
            }
            assert_eq!(
                solution.status,
                Status::Converged,
                "{method}, seed {seed}: {:e} {}",
                solution.figures.relative_reduced_gradient,
                solution.figures.proximal_steps
            );
            let seen =
                plain.relative_reduced_gradient(&solution.lambda, 1.0 / solution.figures.sigma_max);
            assert!(seen < 2e-8, "{method}, seed {seed}: {seen:e}");
        }
    }
}
