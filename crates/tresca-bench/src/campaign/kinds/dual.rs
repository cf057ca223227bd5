//! The pure dual form: A and b.

use super::degenerate;
use crate::campaign::dense::Rows;
use crate::campaign::draw::{Family, bare, dress, with_spectrum};
use crate::campaign::problem::{Drawn, Problem};
use crate::campaign::random::Random;

/// A problem with K = 1 and B of this rank, so that A = BBᵀ, its condition (beside the kernel) to 1e5.
fn of_rank(random: &mut Random, family: Family, tangents: usize, m: usize, rank: usize) -> Problem {
    let order = (tangents + 1) * m;
    let condition = random.between(0.0, 5.0);
    let spectrum: Vec<f64> = (0..order)
        .map(|i| {
            if i < rank {
                random.decades(-0.5 * condition, 0.0)
            } else {
                0.0
            }
        })
        .collect();
    // B = Q diag(spectrum) Qᵀ has as many columns as rows; turned, the last ones are zero.
    let b = with_spectrum(random, &spectrum);
    let identity: Rows = (0..order)
        .map(|i| (0..order).map(|j| f64::from(u8::from(i == j))).collect())
        .collect();
    let mut problem = bare(vec![identity], Vec::new(), tangents);
    problem.normal = b[..m].to_vec();
    problem.tangential = b[m..].to_vec();
    problem.origin = vec![0.0; tangents * m];
    problem.gap = vec![0.0; m];
    dress(random, &mut problem, family);
    problem
}

fn family(random: &mut Random) -> Family {
    random.pick(&[
        Family::Frictionless,
        Family::Tresca,
        Family::Orthotropic,
        Family::Convex,
        Family::Closed,
    ])
}

pub fn regular(random: &mut Random) -> Drawn {
    let (family, tangents) = (family(random), random.count(0, 2));
    let m = random.count(1, 20);
    let problem = of_rank(random, family, tangents, m, (tangents + 1) * m);
    Drawn::plain(problem).dual()
}

pub fn singular(random: &mut Random) -> Drawn {
    let (family, tangents) = (family(random), random.count(0, 2));
    let m = random.count(2, 20);
    let order = (tangents + 1) * m;
    let rank = random.count(order.div_ceil(3), order - 1);
    let mut problem = of_rank(random, family, tangents, m, rank);
    // c in the range, too.
    problem.gap.fill(0.0);
    problem.origin.fill(0.0);
    Drawn::plain(problem).dual()
}

pub fn unbounded(random: &mut Random) -> Drawn {
    if random.chance(0.5) {
        let (family, tangents) = (family(random), random.count(0, 2));
        let m = random.count(2, 12);
        let order = (tangents + 1) * m;
        let rank = random.count(order.div_ceil(3), order - 1);
        return Drawn::plain(of_rank(random, family, tangents, m, rank)).dual();
    }
    degenerate::contradictory_held(random).dual()
}
