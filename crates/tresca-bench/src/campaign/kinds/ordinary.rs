//! Bodies that are held, and rows of B that are independent.

use crate::campaign::dense::Rows;
use crate::campaign::draw::{Family, Pair, bare, dress, full, loose_pair, node_pair, springs};
use crate::campaign::problem::{Drawn, Problem};
use crate::campaign::random::Random;

/// One to three bodies, full or of springs.
fn bodies(random: &mut Random, dofs: usize) -> Vec<Rows> {
    let count = random.count(1, 3.min(dofs));
    let mut left = dofs;
    (0..count)
        .map(|body| {
            let own = if body + 1 == count {
                left
            } else {
                random.count(1, left - (count - 1 - body))
            };
            left -= own;
            if random.chance(0.5) {
                full(random, own, 0)
            } else {
                springs(random, own, true)
            }
        })
        .collect()
}

/// A problem of this family.
pub fn held(random: &mut Random, family: Family, tangents: usize) -> Problem {
    let dimension = tangents + 1;
    let (dofs, pairs): (usize, Vec<Pair>) = if random.chance(0.5) {
        let m = random.count(1, 10);
        let dofs = random.count(dimension * m, (dimension * m + 20).min(60));
        let pairs = (0..m).map(|_| loose_pair(random, dofs, tangents));
        (dofs, pairs.collect())
    } else {
        // Slaves and masters apart, so that no node is in two pairs.
        let m = random.count(1, 10);
        let masters = random.count(1, 8);
        let dofs = dimension * (m + masters);
        let pair = |slave| {
            let master = random.chance(0.6).then(|| m + random.count(0, masters - 1));
            node_pair(random, dofs, tangents, slave, master)
        };
        (dofs, (0..m).map(pair).collect())
    };
    let mut problem = bare(bodies(random, dofs), pairs, tangents);
    dress(random, &mut problem, family);
    problem
}

pub fn frictionless(random: &mut Random) -> Drawn {
    let tangents = random.count(0, 2);
    Drawn::plain(held(random, Family::Frictionless, tangents))
}

pub fn tresca(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    Drawn::plain(held(random, Family::Tresca, tangents))
}

pub fn orthotropic(random: &mut Random) -> Drawn {
    let tangents = if random.chance(0.2) { 1 } else { 2 };
    Drawn::plain(held(random, Family::Orthotropic, tangents))
}

pub fn mixture(random: &mut Random) -> Drawn {
    let tangents = random.count(1, 2);
    Drawn::plain(held(random, Family::Convex, tangents))
}
