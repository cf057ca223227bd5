//! Bodies that float.

use crate::campaign::draw::{
    Family, Pair, balance, bare, dress, forces, full, loose_pair, springs,
};
use crate::campaign::problem::{Drawn, Problem};
use crate::campaign::random::Random;

/// A held body and one that floats, or only that, touched by full rows; a load that may be balanced, or not.
pub fn free(random: &mut Random, family: Family, tangents: usize) -> Problem {
    let motions = random.count(1, 3);
    let own = random.count(motions + 1, 14);
    let mut stiffness = vec![full(random, own, motions)];
    if random.chance(0.6) {
        let other = random.count(1, 14);
        stiffness.insert(random.count(0, 1), full(random, other, 0));
    }
    let dofs: usize = stiffness.iter().map(Vec::len).sum();
    // Enough pairs to hold the motions, if they push the right way.
    let most = (dofs / (tangents + 1)).clamp(1, 8);
    let m = random.count(1, most);
    let pairs = (0..m).map(|_| loose_pair(random, dofs, tangents)).collect();
    let mut problem = bare(stiffness, pairs, tangents);
    dress(random, &mut problem, family);
    load(random, &mut problem);
    problem
}

/// In most cases a load that forces balance; else any, or one against which they push.
fn load(random: &mut Random, problem: &mut Problem) {
    let mut own = forces(random, problem);
    match random.count(0, 5) {
        0 => return,
        1 => {
            let share = random.between(-2.0, 3.0);
            own.iter_mut().for_each(|force| *force *= share);
        }
        _ => {}
    }
    balance(random, problem, &own);
}

pub fn frictionless(random: &mut Random) -> Drawn {
    let tangents = random.count(0, 2);
    Drawn::plain(free(random, Family::Frictionless, tangents))
}

pub fn tresca(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    Drawn::plain(free(random, Family::Tresca, tangents))
}

pub fn mixture(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    Drawn::plain(free(random, Family::Convex, tangents))
}

/// Chains of masses, held or not, with pairs between any two masses, or a mass and the ground.
pub fn chains(random: &mut Random) -> Drawn {
    let sizes: Vec<usize> = (0..random.count(1, 3))
        .map(|_| random.count(3, 12))
        .collect();
    let first_held = random.chance(0.5) && sizes.len() > 1;
    let stiffness = sizes
        .iter()
        .enumerate()
        .map(|(body, &size)| springs(random, size, body == 0 && first_held))
        .collect();
    let dofs: usize = sizes.iter().sum();
    let m = random.count(sizes.len(), sizes.len() + 5);
    let mut pairs: Vec<Pair> = (0..m)
        .map(|_| {
            (0..2)
                .map(|_| {
                    let mut row = vec![0.0; dofs];
                    let (a, b) = (random.count(0, dofs - 1), random.count(0, dofs - 1));
                    row[a] += 1.0;
                    if a != b && random.chance(0.7) {
                        row[b] -= 1.0;
                    }
                    row
                })
                .collect()
        })
        .collect();
    // Every chain is touched.
    let mut first = 0;
    for (body, size) in sizes.iter().enumerate() {
        let touched = |row: &Vec<f64>| row[first..first + size].iter().sum::<f64>() != 0.0;
        if !pairs.iter().flatten().any(touched) {
            let mut row = vec![0.0; dofs];
            row[first + random.count(0, size - 1)] = 1.0;
            let pair = &mut pairs[body];
            pair[1] = row;
        }
        first += size;
    }
    let mut problem = bare(stiffness, pairs, 1);
    dress(random, &mut problem, Family::Tresca);
    if random.chance(0.5) {
        load(random, &mut problem);
    }
    Drawn::plain(problem)
}
