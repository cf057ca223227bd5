//! Coulomb's law, coefficients to 5.

use tresca::algebraic::PairLaw;

use super::{floating, ordinary};
use crate::campaign::dense::{Rows, dot};
use crate::campaign::draw::{Family, bare, dress, law};
use crate::campaign::problem::{Drawn, Problem};
use crate::campaign::random::Random;

/// K = 1 and rows of random numbers in so many dofs: W = BBᵀ couples everything with everything.
fn coupled(random: &mut Random, tangents: usize, m: usize, dofs: usize) -> Problem {
    let identity: Rows = (0..dofs)
        .map(|i| (0..dofs).map(|j| f64::from(u8::from(i == j))).collect())
        .collect();
    let pairs = (0..m)
        .map(|_| (0..=tangents).map(|_| random.normals(dofs)).collect())
        .collect();
    let mut problem = bare(vec![identity], pairs, tangents);
    dress(random, &mut problem, Family::Coulomb);
    problem
}

fn either_form(random: &mut Random, problem: Problem) -> Drawn {
    let drawn = Drawn::plain(problem);
    if random.chance(0.5) {
        drawn.dual()
    } else {
        drawn
    }
}

fn regular(random: &mut Random, tangents: usize) -> Drawn {
    let problem = if random.chance(0.5) {
        let m = random.count(1, 10);
        let order = (tangents + 1) * m;
        let dofs = random.count(order, order + 10);
        coupled(random, tangents, m, dofs)
    } else {
        ordinary::held(random, Family::Coulomb, tangents)
    };
    either_form(random, problem)
}

pub fn plane(random: &mut Random) -> Drawn {
    regular(random, 1)
}

pub fn space(random: &mut Random) -> Drawn {
    regular(random, 2)
}

pub fn singular(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    let m = random.count(2, 8);
    let order = (tangents + 1) * m;
    let dofs = random.count(order.div_ceil(3), order - 1);
    let mut problem = coupled(random, tangents, m, dofs);
    if random.chance(0.3) {
        // One contact twice.
        let (a, b) = (random.count(0, m - 2), m - 1);
        problem.normal[b] = problem.normal[a].clone();
        for t in 0..tangents {
            problem.tangential[tangents * b + t] = problem.tangential[tangents * a + t].clone();
        }
    }
    // Some displacement keeps clear of all contacts.
    let u = random.normals(dofs);
    for pair in 0..m {
        let slack = random.decades(-2.0, 0.0);
        problem.gap[pair] = dot(&problem.normal[pair], &u) + slack;
    }
    either_form(random, problem)
}

pub fn mixture(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    let mut problem = ordinary::held(random, Family::All, tangents);
    problem.laws[0] = law(random, Family::Coulomb, tangents);
    either_form(random, problem)
}

pub fn floating(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    Drawn::plain(floating::free(random, Family::Coulomb, tangents))
}

/// Half a turn of a rope of masses and springs on a drum, pulled by 1 at one end and by more at the other: up
/// to the load at which all of it slips there is an equilibrium, above it none.
pub fn rope(random: &mut Random) -> Drawn {
    let nodes = random.count(3, 14);
    let mu = random.between(0.1, 0.6);
    let share = if random.chance(0.8) {
        random.between(0.1, 0.99)
    } else {
        random.between(1.01, 1.3)
    };
    let wrap = std::f64::consts::PI;
    let step = wrap / (nodes - 1) as f64;
    let angle = |i: usize| step * i as f64;
    let dofs = 2 * nodes;
    let mut k = vec![vec![0.0; dofs]; dofs];
    let stiffness = random.decades(0.0, 2.0);
    for i in 0..nodes - 1 {
        let (a, b) = (angle(i), angle(i + 1));
        let along = [b.cos() - a.cos(), b.sin() - a.sin()];
        let length = along[0].hypot(along[1]);
        let g = [
            -along[0] / length,
            -along[1] / length,
            along[0] / length,
            along[1] / length,
        ];
        for (p, gp) in g.iter().enumerate() {
            for (q, gq) in g.iter().enumerate() {
                k[2 * i + p][2 * i + q] += stiffness * gp * gq;
            }
        }
    }
    let pairs = (0..nodes)
        .map(|i| {
            let (s, c) = angle(i).sin_cos();
            let (mut normal, mut tangent) = (vec![0.0; dofs], vec![0.0; dofs]);
            (normal[2 * i], normal[2 * i + 1]) = (-c, -s);
            (tangent[2 * i], tangent[2 * i + 1]) = (-s, c);
            vec![normal, tangent]
        })
        .collect();
    let mut problem = bare(vec![k], pairs, 1);
    problem.laws = vec![PairLaw::coulomb(mu); nodes];
    let lever = mu * (0.5 * step).tan();
    let ratio = ((1.0 + lever) / (1.0 - lever)).powi(nodes as i32);
    let pulled = 1.0 + share * (ratio - 1.0);
    let (s, c) = (-0.5 * step).sin_cos();
    problem.load[0] += s;
    problem.load[1] -= c;
    let (s, c) = (wrap + 0.5 * step).sin_cos();
    problem.load[dofs - 2] -= pulled * s;
    problem.load[dofs - 1] += pulled * c;
    Drawn::plain(problem)
}
