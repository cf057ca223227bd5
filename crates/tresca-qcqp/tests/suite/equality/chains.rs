//! Chains of springs, some of them floating, that random rows press and rub: limit analysis decides
//! which of them can be in equilibrium.

use super::no_equilibrium::assert_proof_over;
use super::*;
use crate::common::Plain;
use crate::common::problems::normal;
use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, Side};
use rand::RngExt;
use rand::rngs::StdRng;
use tresca_qcqp::CoulombBound;

/// How friction acts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Friction {
    /// Intervals.
    Plane,
    /// Discs.
    Space,
    /// Coulomb's law in the plane.
    PlanarCones,
    /// Coulomb's law in space.
    Cones,
}

/// The problem, with what oracles need to know of it.
struct Chains {
    floating: Floating,
    law: Vec<CoulombBound>,
    normals: Vec<Vec<f64>>,
    gaps: Vec<f64>,
}

/// One to three chains of three to eleven nodes, the first one held or not, the others floating, and one
/// to seven pairs. Frozen bounds: displacements are numbers, normal and tangential rows pair any two nodes.
/// Cones: every node has as many displacements as a pair has directions, and a pair is one of nodes.
/// `None` where nothing floats.
fn chains(friction: Friction, seed: u64) -> Option<Chains> {
    let rng = &mut rng(40_000 + seed);
    let sizes: Vec<usize> = (0..rng.random_range(1..4))
        .map(|_| rng.random_range(3..12))
        .collect();
    let held = rng.random::<f64>() < 0.5;
    let nodes: usize = sizes.iter().sum();
    let m = rng.random_range(1..8);
    let in_space = matches!(friction, Friction::Space | Friction::Cones);
    let frozen = matches!(friction, Friction::Plane | Friction::Space);
    let tangents = if in_space { 2 * m } else { m };
    let directions = if frozen { 1 } else { 1 + tangents / m };
    let n = directions * nodes;
    let mut stiffness = Mat::<f64>::zeros(n, n);
    // First dof, number of dofs and whether it floats, of every chain in every direction.
    let mut bodies = Vec::new();
    for direction in 0..directions {
        let mut at = direction * nodes;
        for (number, &size) in sizes.iter().enumerate() {
            let mut springs: Vec<(usize, usize)> = (1..size).map(|i| (i - 1, i)).collect();
            springs.extend(
                (0..3 * size).map(|_| (rng.random_range(0..size), rng.random_range(0..size))),
            );
            for (i, j) in springs {
                let k = 10_f64.powf(rng.random_range(-1.0..1.0));
                if i != j {
                    let (i, j) = (at + i, at + j);
                    stiffness[(i, i)] += k;
                    stiffness[(j, j)] += k;
                    stiffness[(i, j)] -= k;
                    stiffness[(j, i)] -= k;
                }
            }
            if held && number == 0 {
                stiffness[(at, at)] += 1.0;
            }
            bodies.push((at, size, !(held && number == 0)));
            at += size;
        }
    }
    let pair = |rng: &mut StdRng| {
        let (a, b) = (rng.random_range(0..nodes), rng.random_range(0..nodes));
        (a, b, a != b && rng.random::<f64>() < 0.7)
    };
    let row = |(a, b, two): (usize, usize, bool), direction: usize, sign: f64| {
        let mut row = vec![0.0; n];
        row[direction * nodes + a] += sign;
        if two {
            row[direction * nodes + b] -= sign;
        }
        row
    };
    let pairs: Vec<_> = (0..m).map(|_| pair(rng)).collect();
    let mut rows: Vec<Vec<f64>> = pairs.iter().map(|&pair| row(pair, 0, 1.0)).collect();
    let normals_of = rows.clone();
    if frozen {
        rows.extend((0..tangents).map(|_| row(pair(rng), 0, 1.0)));
    } else {
        for &pair in &pairs {
            rows.extend((1..directions).map(|direction| row(pair, direction, 1.0)));
        }
    }
    let size = 10_f64.powf(rng.random_range(-1.0..1.0));
    let mut load: Vec<f64> = normals(rng, n).iter().map(|f| f * size).collect();
    if !frozen {
        // Pressed more than pushed.
        load[..nodes].iter_mut().for_each(|f| *f = f.abs());
    }
    let gaps: Vec<f64> = normals(rng, m).iter().map(|d| 0.3 * d).collect();
    let bounds: Vec<f64> = (0..m)
        .map(|_| 10_f64.powf(rng.random_range(-2.0..1.0)))
        .collect();
    let coefficients: Vec<f64> = (0..m).map(|_| rng.random_range(0.0..1.5)).collect();

    // One spring of a floating chain to the ground, at its first node.
    let mut grounded = stiffness.clone();
    let (mut equality_rows, mut rhs, mut metric) = (Vec::new(), Vec::new(), Vec::new());
    for (at, size, _) in bodies.into_iter().filter(|&(_, _, floats)| floats) {
        let spring = 10_f64.powf(rng.random_range(-1.0..1.0));
        grounded[(at, at)] += spring;
        let resultant = |row: &[f64]| row[at..at + size].iter().sum::<f64>();
        // Rigid motions that were found from matrices are theirs to rounding only.
        let noisy = rows.iter().map(|row| resultant(row) + 1e-16 * normal(rng));
        equality_rows.push(noisy.collect::<Vec<f64>>());
        rhs.push(resultant(&load));
        metric.push(1.0 / spring);
    }
    if rhs.is_empty() {
        return None;
    }
    let count = rhs.len();
    let metric = (0..count)
        .map(|i| {
            (0..count)
                .map(|j| if i == j { metric[i] } else { 0.0 })
                .collect()
        })
        .collect();
    let factor = Llt::new(grounded.as_ref(), Side::Lower).unwrap();
    let dim = m + tangents;
    let responses = factor.solve(Mat::from_fn(n, dim, |i, j| rows[j][i]));
    let moved = factor.solve(Mat::from_fn(n, 1, |i, _| load[i]));
    let along = |row: &[f64], u: &Mat<f64>, j: usize| -> f64 {
        row.iter().enumerate().map(|(i, x)| x * u[(i, j)]).sum()
    };
    let a: Vec<Vec<f64>> = (0..dim)
        .map(|i| {
            let product =
                |j: usize| 0.5 * (along(&rows[i], &responses, j) + along(&rows[j], &responses, i));
            (0..dim).map(product).collect()
        })
        .collect();
    let b = (0..dim)
        .map(|i| along(&rows[i], &moved, 0) - gaps.get(i).copied().unwrap_or(0.0))
        .collect();
    let set = if in_space {
        ProductSet::contact_3d(&bounds)
    } else {
        ProductSet::contact_2d(&bounds)
    };
    let law = if frozen { 0 } else { m };
    Some(Chains {
        floating: Floating {
            plain: Plain {
                a,
                b,
                set: set.unwrap(),
            },
            equality: Equality {
                rows: equality_rows,
                rhs,
                metric,
            },
        },
        law: (0..law)
            .map(|i| CoulombBound {
                block: m + i,
                normal: i,
                coefficient: coefficients[i],
                limit: f64::INFINITY,
            })
            .collect(),
        normals: normals_of,
        gaps,
    })
}

/// What is within this of the limit load is left out.
const AT_THE_LIMIT: f64 = 1e-6;

/// How the runs of some problems ended.
#[derive(Debug, Default)]
struct Tally {
    impossible: usize,
    possible: usize,
    converged: usize,
    marginal: usize,
    contradictory: usize,
    wrong: Vec<String>,
}

fn run(friction: Friction, seeds: std::ops::Range<u64>) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds {
        let Some(chains) = chains(friction, seed) else {
            continue;
        };
        let Floating { plain, equality } = &chains.floating;
        let factor = oracle::load_factor(&plain.set, &chains.law, &equality.rows, &equality.rhs);
        let mut problem = chains.floating.problem();
        if !chains.law.is_empty() {
            problem = problem.with_coulomb(chains.law.clone()).unwrap();
        }
        let solution = solve(&mut problem, &Settings::default(), None, &mut Unobserved).unwrap();
        let what = format!(
            "{friction:?} {seed}: {} at load factor {factor:.9}, α = {:.1e}, {} outer, {} ascents, {} iterations, residuals {:.1e} {:.1e}",
            solution.status,
            norm(&solution.multiplier),
            solution.figures.outer_iterations,
            solution.records.last().map_or(0, |record| record.outer),
            solution.figures.iterations,
            solution.figures.relative_reduced_gradient,
            solution.figures.equality_residual,
        );
        if factor < 1.0 - AT_THE_LIMIT {
            tally.impossible += 1;
            if solution.status == Status::NoEquilibrium {
                assert_proof_over(&chains.floating, &chains.law, &solution);
            } else {
                tally.wrong.push(what);
            }
        } else if factor < 1.0 + AT_THE_LIMIT {
            tally.marginal += 1;
        } else if oracle::clearance(&chains.normals, &chains.gaps) < AT_THE_LIMIT {
            tally.contradictory += 1;
            if solution.status == Status::NoEquilibrium {
                tally.wrong.push(what);
            }
        } else {
            tally.possible += 1;
            tally.converged += usize::from(solution.status == Status::Converged);
            if solution.status == Status::Converged && chains.law.is_empty() {
                assert_solves(&chains.floating, &solution, 1e-8, &what);
            }
            // That statics can hold the load is not all that Coulomb's law asks.
            let wrong = if chains.law.is_empty() {
                solution.status != Status::Converged
            } else {
                solution.status == Status::NoEquilibrium
            };
            if wrong {
                tally.wrong.push(what);
            }
        }
    }
    tally
}

#[test]
fn friction_that_cannot_hold_a_chain_is_proved_so() {
    let tally = run(Friction::Plane, 0..400);
    assert!(tally.wrong.is_empty(), "{tally:#?}");
    assert!(tally.impossible > 100 && tally.possible > 50, "{tally:#?}");
}

#[test]
fn discs_that_cannot_hold_a_chain_are_proved_so() {
    let tally = run(Friction::Space, 0..400);
    assert!(tally.wrong.is_empty(), "{tally:#?}");
}

#[test]
fn cones_that_cannot_hold_a_chain_are_proved_so() {
    for friction in [Friction::Cones, Friction::PlanarCones] {
        let tally = run(friction, 0..200);
        assert!(tally.wrong.is_empty(), "{tally:#?}");
        assert!(tally.converged > 40, "{tally:#?}");
    }
}
