//! Rows that depend on each other or contradict each other; problems in which next to nothing happens.

use tresca::algebraic::PairLaw;

use super::ordinary::held;
use crate::campaign::dense::{add, dot};
use crate::campaign::draw::{
    Family, balance, bare, dress, forces, full, gap, law, node_pair, springs,
};
use crate::campaign::problem::{Drawn, Problem};
use crate::campaign::random::Random;

/// Appends a pair.
fn push(
    problem: &mut Problem,
    normal: Vec<f64>,
    tangential: Vec<Vec<f64>>,
    gap: f64,
    law: PairLaw,
) {
    problem.normal.push(normal);
    problem.origin.extend(tangential.iter().map(|_| 0.0));
    problem.tangential.extend(tangential);
    problem.gap.push(gap);
    problem.laws.push(law);
}

fn tangents_of(problem: &Problem, pair: usize) -> Vec<Vec<f64>> {
    let t = problem.tangents;
    problem.tangential[t * pair..t * (pair + 1)].to_vec()
}

/// Any family of pairs that may open.
fn opening(random: &mut Random) -> (Family, usize) {
    let family = random.pick(&[Family::Frictionless, Family::Tresca, Family::Orthotropic]);
    let low = usize::from(family != Family::Frictionless);
    (family, random.count(low, 2))
}

fn any_pair(random: &mut Random, problem: &Problem) -> usize {
    random.count(0, problem.pairs() - 1)
}

/// Pairs a second and a third time: the same normal, the same tangents or others, the same gap or another.
pub fn repeat(random: &mut Random, problem: &mut Problem, family: Family) {
    for _ in 0..random.count(1, 3) {
        let pair = any_pair(random, problem);
        let tangential = if random.chance(0.5) {
            tangents_of(problem, pair)
        } else {
            (0..problem.tangents)
                .map(|_| random.normals(problem.dofs()))
                .collect()
        };
        let gap = if random.chance(0.4) {
            problem.gap[pair]
        } else {
            problem.gap[pair] + 0.2 * random.normal()
        };
        let law = law(random, family, problem.tangents);
        push(problem, problem.normal[pair].clone(), tangential, gap, law);
    }
}

pub fn repeated(random: &mut Random) -> Drawn {
    let (family, tangents) = opening(random);
    let mut problem = held(random, family, tangents);
    // What they press on matters: overlaps.
    if random.chance(0.5) {
        problem.gap.iter_mut().for_each(|gap| *gap = -gap.abs());
    }
    repeat(random, &mut problem, family);
    Drawn::plain(problem)
}

/// Ties and bilateral pairs, some of them twice or thrice with the same rows and gap.
fn tied_again(random: &mut Random) -> (Problem, Vec<(usize, usize)>) {
    let tangents = random.count(1, 2);
    let mut problem = held(random, Family::Closed, tangents);
    let mut copies = Vec::new();
    for _ in 0..random.count(1, 3) {
        let pair = any_pair(random, &problem);
        let law = if random.chance(0.7) {
            problem.laws[pair]
        } else {
            law(random, Family::Closed, tangents)
        };
        copies.push((problem.pairs(), pair));
        let origin = problem.origin[tangents * pair..tangents * (pair + 1)].to_vec();
        let rows = tangents_of(&problem, pair);
        let (normal, gap) = (problem.normal[pair].clone(), problem.gap[pair]);
        push(&mut problem, normal, rows, gap, law);
        let first = problem.origin.len() - tangents;
        problem.origin[first..].copy_from_slice(&origin);
    }
    (problem, copies)
}

pub fn repeated_ties(random: &mut Random) -> Drawn {
    Drawn::plain(tied_again(random).0)
}

pub fn noisy_ties(random: &mut Random) -> Drawn {
    let (problem, copies) = tied_again(random);
    let mut noisy = problem.clone();
    for (copy, _) in copies {
        let noise = random.decades(-16.5, -14.0) * random.sign();
        noisy.gap[copy] += noise;
    }
    let mut drawn = Drawn::plain(problem);
    drawn.noisy = Some(noisy);
    drawn
}

/// A row this far from another.
fn beside(random: &mut Random, row: &[f64], angle: f64) -> Vec<f64> {
    let length = dot(row, row).sqrt();
    let away = random.normals(row.len());
    let size = dot(&away, &away).sqrt();
    let mut beside = row.to_vec();
    add(&mut beside, angle * length / size, &away);
    beside
}

pub fn near_dependent(random: &mut Random) -> Drawn {
    let (family, tangents) = opening(random);
    let mut problem = held(random, family, tangents);
    let angle = random.pick(&[1e-5, 1e-7]);
    for _ in 0..random.count(1, 3) {
        let pair = any_pair(random, &problem);
        let normal = beside(random, &problem.normal[pair], angle);
        let tangential = tangents_of(&problem, pair);
        let tangential = tangential
            .iter()
            .map(|row| beside(random, row, angle))
            .collect();
        let gap = problem.gap[pair] + angle * random.normal();
        let law = law(random, family, tangents);
        push(&mut problem, normal, tangential, gap, law);
    }
    Drawn {
        ill_determined: true,
        ..Drawn::plain(problem)
    }
}

pub fn near_dependent_ties(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    let mut problem = held(random, Family::Closed, tangents);
    let angle = random.pick(&[1e-5, 1e-7]);
    // Displacements that meet all of them.
    let u = random.normals(problem.dofs());
    for _ in 0..random.count(1, 2) {
        let pair = any_pair(random, &problem);
        let normal = beside(random, &problem.normal[pair], angle);
        let rows = tangents_of(&problem, pair);
        let law = problem.laws[pair];
        push(&mut problem, normal, rows, 0.0, law);
    }
    problem.gap = problem.normal.iter().map(|row| dot(row, &u)).collect();
    problem.origin = problem.tangential.iter().map(|row| dot(row, &u)).collect();
    Drawn {
        ill_determined: true,
        ..Drawn::plain(problem)
    }
}

pub fn dependent(random: &mut Random) -> Drawn {
    let (family, tangents) = opening(random);
    let mut problem = held(random, family, tangents);
    let u = random.normals(problem.dofs());
    for _ in 0..random.count(1, 6) {
        let (a, b) = (any_pair(random, &problem), any_pair(random, &problem));
        let mut normal: Vec<f64> = problem.normal[a]
            .iter()
            .map(|x| random.sign() * x)
            .collect();
        if random.chance(0.7) {
            normal = problem.normal[a].clone();
        }
        let factor = random.pick(&[1.0, -1.0, 2.0, 0.5]);
        add(&mut normal, factor, &problem.normal[b]);
        if dot(&normal, &normal) < 1e-6 {
            continue;
        }
        let rows = tangents_of(&problem, if random.chance(0.5) { a } else { b });
        let law = law(random, family, tangents);
        push(&mut problem, normal, rows, 0.0, law);
    }
    // Some displacement keeps clear of all of them.
    for pair in 0..problem.pairs() {
        let slack = if random.chance(0.3) {
            0.0
        } else {
            random.decades(-2.0, 0.0)
        };
        problem.gap[pair] = dot(&problem.normal[pair], &u) + slack;
    }
    Drawn::plain(problem)
}

/// Adds pairs that no displacement can meet.
fn contradict(random: &mut Random, problem: &mut Problem, family: Family) {
    let tangents = problem.tangents;
    let apart = random.decades(-3.0, 0.0);
    let pair = any_pair(random, problem);
    let rows = tangents_of(problem, pair);
    let normal = problem.normal[pair].clone();
    let opposite: Vec<f64> = normal.iter().map(|x| -x).collect();
    let tie = if tangents > 0 && random.chance(0.5) {
        PairLaw::Tied
    } else {
        PairLaw::Bilateral { bound: 0.0 }
    };
    match random.count(0, 4) {
        0 => {
            problem.laws[pair] = tie;
            let gap = problem.gap[pair] + apart;
            push(problem, normal, rows, gap, tie);
        }
        1 => {
            let gap = -problem.gap[pair] - apart;
            let law = law(random, family, tangents);
            push(problem, opposite, rows, gap, law);
        }
        2 => {
            problem.laws[pair] = tie;
            let gap = -problem.gap[pair] - apart;
            let law = law(random, family, tangents);
            push(problem, opposite, rows, gap, law);
        }
        3 => {
            // A row that is the sum of two ties, at another gap.
            let other = any_pair(random, problem);
            problem.laws[pair] = tie;
            problem.laws[other] = tie;
            let mut sum = normal;
            add(&mut sum, 1.0, &problem.normal[other]);
            let gap = problem.gap[pair] + problem.gap[other] + apart;
            push(problem, sum, rows, gap, tie);
        }
        _ => {
            // Two dofs between walls, with something between them: u1 ≤ a, u2 − u1 ≤ b, −u2 ≤ c, a + b + c < 0.
            let n = problem.dofs();
            let links = random.count(1, 3.min(n));
            let dofs = random.choose(links, n);
            let mut left = -apart;
            for link in 0..=links {
                let mut row = vec![0.0; n];
                if link > 0 {
                    row[dofs[link - 1]] = -1.0;
                }
                if link < links {
                    row[dofs[link]] = 1.0;
                }
                let gap = if link == links {
                    left
                } else {
                    0.5 * random.normal()
                };
                left -= gap;
                let rows = (0..tangents).map(|_| random.normals(n)).collect();
                let law = law(random, family, tangents);
                push(problem, row, rows, gap, law);
            }
        }
    }
}

fn any_family(random: &mut Random) -> (Family, usize) {
    if random.chance(0.3) {
        (Family::Frictionless, random.count(0, 2))
    } else {
        let family = random.pick(&[Family::Tresca, Family::Convex, Family::All]);
        (family, random.count(1, 2))
    }
}

pub fn contradictory_held(random: &mut Random) -> Drawn {
    let (family, tangents) = any_family(random);
    let mut problem = held(random, family, tangents);
    contradict(random, &mut problem, family);
    Drawn::plain(problem)
}

pub fn contradictory(random: &mut Random) -> Drawn {
    if random.chance(0.8) {
        return contradictory_held(random);
    }
    let (family, tangents) = any_family(random);
    let mut problem = super::floating::free(random, family, tangents);
    contradict(random, &mut problem, family);
    Drawn::plain(problem)
}

pub fn tie_loops(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    let dimension = tangents + 1;
    let count = random.count(2, 6);
    let nodes = random.count(2, 3);
    let held_bodies = random.count(0, count);
    let stiffness: Vec<_> = (0..count)
        .map(|body| {
            let motions = if body < held_bodies { 0 } else { dimension };
            // Translations: the same on all nodes.
            let axis = springs(random, nodes, motions == 0);
            let order = dimension * nodes;
            let mut k = vec![vec![0.0; order]; order];
            for a in 0..nodes {
                for b in 0..nodes {
                    for c in 0..dimension {
                        k[dimension * a + c][dimension * b + c] = axis[a][b];
                    }
                }
            }
            k
        })
        .collect();
    let dofs = count * nodes * dimension;
    let node = |body: usize| body * nodes;
    // The same node of each body is tied to the next: the last tie follows from the others.
    let mut axes = node_pair(random, dofs, tangents, 0, None);
    let axes: Vec<Vec<f64>> = axes
        .iter_mut()
        .map(|row| row[..dimension].to_vec())
        .collect();
    let mut pairs = Vec::new();
    for body in 0..count {
        let next = (body + 1) % count;
        let pair = axes.iter().map(|axis| {
            let mut row = vec![0.0; dofs];
            for (c, x) in axis.iter().enumerate() {
                row[dimension * node(body) + c] += x;
                row[dimension * node(next) + c] -= x;
            }
            row
        });
        pairs.push(pair.collect());
    }
    let others = random.count(1, 3);
    for _ in 0..others {
        let slave = random.count(0, count * nodes - 1);
        pairs.push(node_pair(random, dofs, tangents, slave, None));
    }
    let mut problem = bare(stiffness, pairs, tangents);
    dress(random, &mut problem, Family::Tresca);
    let tied_normals = random.chance(0.3);
    let mut left = 0.0;
    for body in 0..count {
        problem.laws[body] = if tied_normals {
            PairLaw::Bilateral {
                bound: random.decades(-2.0, 1.0),
            }
        } else {
            PairLaw::Tied
        };
        problem.gap[body] = if body + 1 == count || random.chance(0.5) {
            -left
        } else {
            0.3 * random.normal()
        };
        left += problem.gap[body];
    }
    problem.origin.fill(0.0);
    if random.chance(0.8) {
        let own = forces(random, &problem);
        balance(random, &mut problem, &own);
    }
    Drawn::plain(problem)
}

pub fn nothing(random: &mut Random) -> Drawn {
    let (family, tangents) = any_family(random);
    let mut problem = if random.chance(0.3) {
        let k = random.decades(-1.0, 1.0);
        let row = vec![random.sign() * random.decades(-0.5, 0.5)];
        let mut one = bare(vec![vec![vec![k]]], vec![vec![row; tangents + 1]], tangents);
        dress(random, &mut one, family);
        one
    } else if random.chance(0.3) {
        super::floating::free(random, family, tangents)
    } else {
        held(random, family, tangents)
    };
    problem.load.fill(0.0);
    problem.origin.fill(0.0);
    match random.count(0, 2) {
        0 => problem.gap.fill(0.0),
        1 => problem.gap.iter_mut().for_each(|gap| *gap = gap.abs()),
        _ => {}
    }
    Drawn::plain(problem)
}

pub fn tiny(random: &mut Random) -> Drawn {
    let tangents = random.count(0, 2);
    let dofs = random.count(1, 2);
    let stiffness = match random.count(0, 3) {
        0 if dofs == 2 => vec![vec![1.0, -1.0], vec![-1.0, 1.0]],
        _ => full(random, dofs, 0),
    };
    let row = |random: &mut Random| -> Vec<f64> {
        loop {
            let row: Vec<f64> = (0..dofs).map(|_| random.pick(&[-1.0, 0.0, 1.0])).collect();
            // No motion of the floating body is along it.
            if row.iter().any(|x| *x != 0.0) && row.iter().sum::<f64>() != 0.0 {
                return row;
            }
        }
    };
    let m = random.count(1, 3);
    let pairs = (0..m)
        .map(|_| (0..=tangents).map(|_| row(random)).collect())
        .collect();
    let mut problem = bare(vec![stiffness], pairs, tangents);
    let family = if tangents == 0 {
        Family::Frictionless
    } else {
        random.pick(&[Family::Tresca, Family::Convex])
    };
    dress(random, &mut problem, family);
    for pair in 0..m {
        problem.gap[pair] = match random.count(0, 3) {
            0 => 0.0,
            1 => random.pick(&[-0.5, 0.5, 1.0]),
            _ => gap(random),
        };
    }
    Drawn::plain(problem)
}
