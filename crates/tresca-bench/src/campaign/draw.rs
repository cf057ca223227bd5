//! The parts that random problems are made of.

use tresca::algebraic::PairLaw;

use super::dense::{Rows, add, dot, norm, product, transposed_product};
use super::problem::Problem;
use super::random::Random;

/// Q diag(spectrum) Qᵀ, Q a product of random reflections.
pub fn with_spectrum(random: &mut Random, spectrum: &[f64]) -> Rows {
    let n = spectrum.len();
    let mut a: Rows = (0..n)
        .map(|i| {
            (0..n)
                .map(|j| if i == j { spectrum[i] } else { 0.0 })
                .collect()
        })
        .collect();
    for _ in 0..n.min(4) {
        let v = random.normals(n);
        let square = dot(&v, &v);
        let w: Vec<f64> = product(&a, &v).iter().map(|x| x / square).collect();
        let c = dot(&v, &w) / square;
        for i in 0..n {
            for j in 0..n {
                a[i][j] += 4.0 * c * v[i] * v[j] - 2.0 * (v[i] * w[j] + w[i] * v[j]);
            }
        }
    }
    #[allow(clippy::needless_range_loop)] // two entries at a time
    for i in 0..n {
        for j in 0..i {
            let mean = 0.5 * (a[i][j] + a[j][i]);
            (a[i][j], a[j][i]) = (mean, mean);
        }
    }
    a
}

/// A full K with this many motions, its other eigenvalues in two decades. No dof of a body that floats is much softer
/// than the others: there rounding would decide whether it floats.
pub fn full(random: &mut Random, dofs: usize, motions: usize) -> Rows {
    loop {
        let spectrum: Vec<f64> = (0..dofs)
            .map(|i| {
                if i < motions {
                    0.0
                } else {
                    random.decades(-1.0, 1.0)
                }
            })
            .collect();
        let k = with_spectrum(random, &spectrum);
        let diagonal = (0..dofs).map(|i| k[i][i]);
        let (least, most) = diagonal.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), k| {
            (low.min(k), high.max(k))
        });
        if motions == 0 || least > 1e-3 * most {
            return k;
        }
    }
}

/// Masses on springs, one dof each, in a chain with some springs across; held at its first mass or floating.
pub fn springs(random: &mut Random, dofs: usize, held: bool) -> Rows {
    let mut k = vec![vec![0.0; dofs]; dofs];
    let spring = |k: &mut Rows, i: usize, j: usize, stiffness: f64| {
        k[i][i] += stiffness;
        k[j][j] += stiffness;
        k[i][j] -= stiffness;
        k[j][i] -= stiffness;
    };
    for i in 1..dofs {
        let stiffness = random.decades(-1.0, 1.0);
        spring(&mut k, i - 1, i, stiffness);
    }
    for _ in 0..dofs / 2 {
        let (i, j) = (random.count(0, dofs - 1), random.count(0, dofs - 1));
        if i != j {
            let stiffness = random.decades(-1.0, 1.0);
            spring(&mut k, i, j, stiffness);
        }
    }
    if held {
        k[0][0] += 1.0;
    }
    k
}

/// An orthonormal frame.
pub fn frame(random: &mut Random, dimension: usize) -> Rows {
    let mut frame: Rows = Vec::new();
    while frame.len() < dimension {
        let mut v = random.normals(dimension);
        for q in &frame {
            let share = dot(&v, q);
            add(&mut v, -share, q);
        }
        let length = norm(&v);
        if length > 0.1 {
            frame.push(v.into_iter().map(|x| x / length).collect());
        }
    }
    frame
}

/// The rows of one pair: the normal's, then those of the tangents.
pub type Pair = Rows;

/// Rows of random numbers.
pub fn loose_pair(random: &mut Random, dofs: usize, tangents: usize) -> Pair {
    (0..=tangents)
        .map(|_| (0..dofs).map(|_| random.between(-1.0, 1.0)).collect())
        .collect()
}

/// A frame at node `slave` (of 1 + tangents dofs), against node `master` if there is one.
pub fn node_pair(
    random: &mut Random,
    dofs: usize,
    tangents: usize,
    slave: usize,
    master: Option<usize>,
) -> Pair {
    let dimension = tangents + 1;
    frame(random, dimension)
        .into_iter()
        .map(|axis| {
            let mut row = vec![0.0; dofs];
            for (c, x) in axis.into_iter().enumerate() {
                row[dimension * slave + c] += x;
                if let Some(master) = master {
                    row[dimension * master + c] -= x;
                }
            }
            row
        })
        .collect()
}

/// Which laws a problem has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// No friction.
    Frictionless,
    /// Given bounds.
    Tresca,
    /// Two given bounds.
    Orthotropic,
    /// All of these, ties, and pairs that never open.
    Convex,
    /// Ties and pairs that never open.
    Closed,
    /// The same with and without a limit, coefficients to 5.
    Coulomb,
    /// Coulomb's law and all others.
    All,
}

/// A law of a family. Without tangents nothing resists sliding.
pub fn law(random: &mut Random, family: Family, tangents: usize) -> PairLaw {
    let bound = |random: &mut Random| {
        if random.chance(0.1) {
            0.0
        } else {
            random.decades(-2.0, 1.0)
        }
    };
    let coefficient = |random: &mut Random| match random.count(0, 9) {
        0 => 0.0,
        1..=5 => random.between(0.0, 1.0),
        _ => random.between(0.0, 5.0),
    };
    let family = match family {
        Family::Convex => random.pick(&[
            Family::Frictionless,
            Family::Tresca,
            Family::Orthotropic,
            Family::Closed,
        ]),
        Family::All => random.pick(&[
            Family::Frictionless,
            Family::Tresca,
            Family::Closed,
            Family::Coulomb,
            Family::Coulomb,
        ]),
        other => other,
    };
    if tangents == 0 {
        return match family {
            Family::Closed => PairLaw::Bilateral { bound: 0.0 },
            _ => PairLaw::Frictionless,
        };
    }
    match family {
        Family::Tresca => PairLaw::tresca(bound(random)),
        Family::Orthotropic => PairLaw::Orthotropic {
            bounds: [bound(random), bound(random)],
        },
        Family::Closed if random.chance(0.5) => PairLaw::Tied,
        Family::Closed => PairLaw::Bilateral {
            bound: bound(random),
        },
        Family::Coulomb => {
            let first = coefficient(random);
            let second = if random.chance(0.1) {
                coefficient(random)
            } else {
                first
            };
            let limit = if random.chance(0.1) {
                random.decades(-1.0, 1.0)
            } else {
                f64::INFINITY
            };
            PairLaw::Coulomb {
                coefficients: [first, second],
                limit,
            }
        }
        _ => PairLaw::Frictionless,
    }
}

/// d of a pair: none, an overlap or a gap.
pub fn gap(random: &mut Random) -> f64 {
    match random.count(0, 5) {
        0 => 0.0,
        1 => random.decades(-2.0, 0.5),
        _ => 0.5 * random.normal(),
    }
}

/// A problem of K and pairs, without load, gaps or laws.
pub fn bare(stiffness: Vec<Rows>, pairs: Vec<Pair>, tangents: usize) -> Problem {
    let m = pairs.len();
    let dofs = stiffness.iter().map(Vec::len).sum();
    let mut normal = Vec::new();
    let mut tangential = Vec::new();
    for pair in pairs {
        let mut rows = pair.into_iter();
        normal.extend(rows.next());
        tangential.extend(rows);
    }
    Problem {
        tangents,
        stiffness,
        normal,
        tangential,
        load: vec![0.0; dofs],
        gap: vec![0.0; m],
        origin: vec![0.0; tangents * m],
        laws: vec![PairLaw::Frictionless; m],
    }
}

/// Laws of a family, gaps, a slip to start from in a tenth of the cases, a load.
pub fn dress(random: &mut Random, problem: &mut Problem, family: Family) {
    let m = problem.pairs();
    problem.laws = (0..m)
        .map(|_| law(random, family, problem.tangents))
        .collect();
    problem.gap = (0..m).map(|_| gap(random)).collect();
    if random.chance(0.1) {
        problem.origin = random.normals(problem.tangents * m);
        problem.origin.iter_mut().for_each(|s| *s *= 0.1);
    }
    let size = random.decades(-1.0, 1.0);
    problem.load = random
        .normals(problem.dofs())
        .iter()
        .map(|f| size * f)
        .collect();
}

/// Forces that every law of the problem allows, well inside of what it allows.
pub fn forces(random: &mut Random, problem: &Problem) -> Vec<f64> {
    let m = problem.pairs();
    let mut forces: Vec<f64> = (0..m).map(|_| random.between(0.1, 1.0)).collect();
    for pair in 0..m {
        let tangents = problem.tangents;
        for t in 0..tangents {
            let bound = super::problem::bounds(&problem.laws[pair], forces[pair]);
            let most = bound.map_or(1.0, |bounds| bounds[t].min(10.0));
            forces.push(0.6 * most * random.between(-1.0, 1.0));
        }
    }
    forces
}

/// A load that these forces and some elastic ones balance.
pub fn balance(random: &mut Random, problem: &mut Problem, forces: &[f64]) {
    let u = random.normals(problem.dofs());
    let mut load = product(&problem.whole(), &u);
    let contact = transposed_product(&problem.contact(), forces, problem.dofs());
    add(&mut load, 1.0, &contact);
    problem.load = load;
}
