//! Random problems with known spectrum.
#![allow(clippy::needless_range_loop)] // loops over indices, as in the formulas

use super::Plain;
use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use tresca_qcqp::ProductSet;
use tresca_qcqp::sets::{Block, BlockSet, Disc, HalfLine, Interval, Line};

pub fn rng(seed: u64) -> StdRng {
    StdRng::seed_from_u64(seed)
}

/// A normal random number (Box and Muller).
pub fn normal(rng: &mut StdRng) -> f64 {
    let (u, v): (f64, f64) = (rng.random(), rng.random());
    (-2.0 * (1.0 - u).ln()).sqrt() * (std::f64::consts::TAU * v).cos()
}

pub fn normals(rng: &mut StdRng, n: usize) -> Vec<f64> {
    (0..n).map(|_| normal(rng)).collect()
}

/// Q diag(spectrum) Qᵀ, Q a product of as many random reflections.
pub fn with_spectrum(rng: &mut StdRng, spectrum: &[f64]) -> Vec<Vec<f64>> {
    let n = spectrum.len();
    let mut a = vec![vec![0.0; n]; n];
    for (i, s) in spectrum.iter().enumerate() {
        a[i][i] = *s;
    }
    for _ in 0..n {
        let v = normals(rng, n);
        let square = super::dot(&v, &v);
        // A ← (I − 2vvᵀ/vᵀv) A (I − 2vvᵀ/vᵀv)
        let w: Vec<f64> = a.iter().map(|row| super::dot(row, &v) / square).collect();
        let c = super::dot(&v, &w) / square;
        for i in 0..n {
            for j in 0..n {
                a[i][j] += -2.0 * (v[i] * w[j] + w[i] * v[j]) + 4.0 * c * v[i] * v[j];
            }
        }
    }
    for i in 0..n {
        for j in 0..i {
            a[i][j] = 0.5 * (a[i][j] + a[j][i]);
            a[j][i] = a[i][j];
        }
    }
    a
}

/// n eigenvalues from 1 down to 1/condition, in geometric progression.
pub fn geometric_spectrum(n: usize, condition: f64) -> Vec<f64> {
    let last = (n.max(2) - 1) as f64;
    (0..n).map(|i| condition.powf(-(i as f64) / last)).collect()
}

/// What the random problem is like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Half-lines and discs, some active, some not.
    Mixed,
    /// Half of the discs are points.
    SomeFrictionless,
    /// All discs are points.
    Frictionless,
    /// Nothing touches.
    AllOpen,
    /// Everything closed and sticking: an unconstrained problem.
    AllStick,
    /// Friction that hardly matters.
    TinyBounds,
    /// Half-lines and intervals.
    TwoDimensional,
    /// Free lines, half-lines, intervals and discs in no special order, some bounds 0.
    Everything,
}

pub const KINDS: [Kind; 8] = [
    Kind::Mixed,
    Kind::SomeFrictionless,
    Kind::Frictionless,
    Kind::AllOpen,
    Kind::AllStick,
    Kind::TinyBounds,
    Kind::TwoDimensional,
    Kind::Everything,
];

/// A random problem with m pairs whose matrix has the given condition number.
pub fn random(kind: Kind, m: usize, condition: f64, seed: u64) -> Plain {
    let rng = &mut rng(seed);
    let n = if kind == Kind::TwoDimensional {
        2 * m
    } else {
        3 * m
    };
    let a = with_spectrum(rng, &geometric_spectrum(n, condition));
    let wish = normals(rng, n);
    let mut bounds: Vec<f64> = (0..m).map(|_| 1.5 * rng.random::<f64>()).collect();
    match kind {
        Kind::SomeFrictionless => bounds.iter_mut().step_by(2).for_each(|g| *g = 0.0),
        Kind::Frictionless => bounds.fill(0.0),
        Kind::AllStick => bounds.fill(1e3),
        Kind::TinyBounds => bounds.iter_mut().for_each(|g| *g *= 1e-8),
        _ => {}
    }
    let set = match kind {
        Kind::TwoDimensional => ProductSet::contact_2d(&bounds),
        Kind::Everything => ProductSet::new(n, everything(n, rng)),
        _ => ProductSet::contact_3d(&bounds),
    };
    let mut plain = Plain {
        a,
        b: Vec::new(),
        set: set.unwrap(),
    };
    plain.b = match kind {
        // The unconstrained minimiser pulls everywhere: b = −A|w| and b = A w with w ≥ 0 on the normals.
        Kind::AllOpen => (0..n)
            .map(|i| if i < m { -wish[i].abs() } else { 0.0 })
            .collect(),
        Kind::AllStick => {
            let inside: Vec<f64> = wish
                .iter()
                .enumerate()
                .map(|(i, w)| if i < m { w.abs() } else { *w })
                .collect();
            plain.mul(&inside)
        }
        _ => plain.mul(&wish),
    };
    plain
}

fn everything(n: usize, rng: &mut StdRng) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut start = 0;
    while start < n {
        let bound = if rng.random::<f64>() < 0.2 {
            0.0
        } else {
            1.5 * rng.random::<f64>()
        };
        let choice = rng.random_range(0..4);
        let set = match choice {
            0 => BlockSet::Line(Line),
            1 => BlockSet::HalfLine(HalfLine),
            2 if start + 1 < n => BlockSet::Disc(Disc { bound }),
            _ => BlockSet::Interval(Interval { bound }),
        };
        blocks.push(Block { start, set });
        start = blocks[blocks.len() - 1].range().end;
    }
    blocks.reverse();
    blocks
}
