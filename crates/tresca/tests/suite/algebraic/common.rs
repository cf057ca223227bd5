//! Comparison, random problems.
#![allow(clippy::needless_range_loop)] // loops over indices, as in the formulas

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use tresca::algebraic::{Friction, Matrix, MatrixProblem, PairLaw, Solution, solve};
use tresca::{Settings, Silent};
use tresca_testkit::assert_near;
pub use tresca_testkit::largest;

pub fn rng(seed: u64) -> StdRng {
    StdRng::seed_from_u64(seed)
}

/// Uniform in (−1, 1).
pub fn uniform(rng: &mut StdRng) -> f64 {
    2.0 * rng.random::<f64>() - 1.0
}

pub fn uniforms(rng: &mut StdRng, count: usize) -> Vec<f64> {
    (0..count).map(|_| uniform(rng)).collect()
}

/// Below this a vector of a random problem, in which everything is about 1, is rounding.
const NOTHING: f64 = 1e-3;

/// Every entry, relative to the largest.
#[track_caller]
pub fn assert_close(found: &[f64], expected: &[f64], relative: f64, what: &str) {
    let scale = largest(expected).max(NOTHING);
    assert_near(found, expected, relative * scale, what);
}

pub fn dense(rows: &[Vec<f64>]) -> Matrix {
    let columns = rows.first().map_or(0, Vec::len);
    Matrix::from_dense((rows.len(), columns), &rows.concat()).unwrap()
}

/// M x.
pub fn product(matrix: &Matrix, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; matrix.rows()];
    matrix.add_product(x, &mut y);
    y
}

/// The blocks of K on one diagonal.
pub fn whole(blocks: &[Matrix]) -> Matrix {
    let n = blocks.iter().map(Matrix::rows).sum();
    let (mut row, mut column, mut value) = (Vec::new(), Vec::new(), Vec::new());
    let mut first = 0;
    for block in blocks {
        for i in 0..block.rows() {
            for (j, k) in block.row(i) {
                row.push(first + i);
                column.push(first + j);
                value.push(k);
            }
        }
        first += block.rows();
    }
    Matrix::from_triplets((n, n), &row, &column, &value).unwrap()
}

/// A random symmetric matrix of rank n − `kernel`, condition about 100 beside that.
pub fn stiffness(rng: &mut StdRng, n: usize, kernel: usize) -> Vec<Vec<f64>> {
    let mut k = vec![vec![0.0; n]; n];
    for (i, row) in k.iter_mut().enumerate() {
        row[i] = if i < kernel {
            0.0
        } else {
            100_f64.powf(i as f64 / n as f64)
        };
    }
    for _ in 0..n {
        // Reflections keep the eigenvalues.
        let v = uniforms(rng, n);
        let square: f64 = v.iter().map(|v| v * v).sum();
        for along_rows in [true, false] {
            for a in 0..n {
                let at = |k: &Vec<Vec<f64>>, b: usize| if along_rows { k[a][b] } else { k[b][a] };
                let along: f64 = (0..n).map(|b| at(&k, b) * v[b]).sum::<f64>() * 2.0 / square;
                for b in 0..n {
                    if along_rows {
                        k[a][b] -= along * v[b];
                    } else {
                        k[b][a] -= along * v[b];
                    }
                }
            }
        }
    }
    for i in 0..n {
        for j in 0..i {
            let mean = 0.5 * (k[i][j] + k[j][i]);
            (k[i][j], k[j][i]) = (mean, mean);
        }
    }
    k
}

/// The laws of a random problem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Laws {
    Frictionless,
    Tresca,
    Orthotropic,
    Tied,
    Bilateral,
    Mixed,
    Coulomb,
}

pub const CONVEX: [Laws; 6] = [
    Laws::Frictionless,
    Laws::Tresca,
    Laws::Orthotropic,
    Laws::Tied,
    Laws::Bilateral,
    Laws::Mixed,
];

fn law(kind: Laws, rng: &mut StdRng, pair: usize) -> PairLaw {
    let positive = |rng: &mut StdRng| 0.1 + rng.random::<f64>();
    match kind {
        Laws::Frictionless => PairLaw::Frictionless,
        Laws::Tresca => PairLaw::tresca(positive(rng)),
        Laws::Orthotropic => {
            // Now and then a direction without friction.
            let second = if pair % 3 == 2 { 0.0 } else { positive(rng) };
            PairLaw::Orthotropic {
                bounds: [positive(rng), second],
            }
        }
        Laws::Tied => PairLaw::Tied,
        Laws::Bilateral => PairLaw::Bilateral {
            bound: if pair.is_multiple_of(2) {
                0.0
            } else {
                positive(rng)
            },
        },
        Laws::Coulomb => PairLaw::Coulomb {
            coefficients: [0.3; 2],
            limit: if pair.is_multiple_of(2) {
                f64::INFINITY
            } else {
                0.2
            },
        },
        Laws::Mixed => {
            let kinds = [
                Laws::Frictionless,
                Laws::Tresca,
                Laws::Orthotropic,
                Laws::Tied,
                Laws::Bilateral,
            ];
            law(kinds[pair % kinds.len()], rng, pair)
        }
    }
}

/// A random problem of two blocks, the second with this kernel, that has an equilibrium.
pub fn random(kind: Laws, tangents: usize, kernel: usize, seed: u64) -> MatrixProblem {
    let rng = &mut rng(seed);
    let (m, orders) = (6, [20, 16]);
    let n: usize = orders.iter().sum();
    let first = dense(&stiffness(rng, orders[0], 0));
    let second = dense(&stiffness(rng, orders[1], kernel));
    let b: Vec<Vec<f64>> = (0..(1 + tangents) * m).map(|_| uniforms(rng, n)).collect();
    let laws: Vec<PairLaw> = (0..m).map(|pair| law(kind, rng, pair)).collect();
    // A load that admissible forces balance, beside some elastic forces.
    let b = dense(&b);
    let mut forces = vec![0.0; b.rows()];
    for (pair, law) in laws.iter().enumerate() {
        forces[pair] = 0.5 + rng.random::<f64>();
        for t in 0..tangents {
            forces[m + tangents * pair + t] = match law {
                PairLaw::Tresca { bound } | PairLaw::Bilateral { bound } => {
                    0.5 * bound * uniform(rng)
                }
                PairLaw::Orthotropic { bounds } => 0.5 * bounds[t] * uniform(rng),
                PairLaw::Coulomb { .. } => 0.05 * uniform(rng),
                _ => 0.0,
            };
        }
    }
    let k = whole(&[first.clone(), second.clone()]);
    let mut load = product(&k, &uniforms(rng, n));
    b.add_transposed_product(&forces, &mut load);
    let gap = (0..m).map(|_| 0.3 * uniform(rng)).collect();
    let mut problem = MatrixProblem::stacked(vec![first, second], &b, m, load)
        .unwrap()
        .with_gap(gap)
        .with_friction(Friction::PerPair(laws));
    if seed % 2 == 1 && tangents > 0 {
        let slip = uniforms(rng, tangents * m)
            .into_iter()
            .map(|slip| 0.1 * slip);
        problem = problem.with_previous_slip(slip.collect());
    }
    problem
}

pub fn tight() -> Settings {
    Settings {
        tolerance: 1e-12,
        coulomb_tolerance: 1e-11,
        max_outer_iterations: 200,
        ..Settings::default()
    }
}

#[track_caller]
pub fn solved(problem: &MatrixProblem, settings: &Settings) -> Solution {
    let solution = solve(problem, settings, &mut Silent).unwrap();
    assert!(
        solution.converged(),
        "{} {:?} {:?}",
        solution.status,
        solution.figures,
        solution.certificate
    );
    let worst = solution.certificate.worst();
    assert!(worst < 1e-7, "{:#?}", solution.certificate);
    solution
}
