//! The conditions of contact and friction, Coulomb's law among them, as one residual.

use tresca::algebraic::PairLaw;

use crate::campaign::dense::{Cholesky, Rows, add, dot, eigen, kernel, largest, product};
use crate::campaign::problem::{Problem, bounds, is_closed};

/// How stiff the pairs of a problem are: what makes a force of a displacement.
pub struct Conditions<'a> {
    problem: &'a Problem,
    /// For each pair, 1 over the largest eigenvalue of its block of B K⁻¹ Bᵀ.
    stiffness: Vec<f64>,
    /// The motions of what floats, orthonormal.
    motions: Rows,
}

impl<'a> Conditions<'a> {
    /// What floats is held by its motions, as stiff as it is elsewhere. `None` if that fails.
    pub fn new(problem: &'a Problem) -> Option<Self> {
        let mut k = problem.whole();
        let most = (0..k.len()).map(|i| k[i][i]).fold(0.0, f64::max);
        let motions = motions(problem)?;
        for motion in &motions {
            for (row, amount) in k.iter_mut().zip(motion) {
                let held = if most > 0.0 { most } else { 1.0 };
                add(row, held * amount, motion);
            }
        }
        let factor = Cholesky::new(&k)?;
        let half: Rows = problem
            .contact()
            .iter()
            .map(|row| factor.forward(row))
            .collect();
        let (m, tangents) = (problem.pairs(), problem.tangents);
        let stiffness = (0..m).map(|pair| {
            let rows = std::iter::once(pair).chain((0..tangents).map(|t| m + tangents * pair + t));
            let own: Rows = rows.map(|row| half[row].clone()).collect();
            let block: Rows = own.iter().map(|row| product(&own, row)).collect();
            let most = eigen(&block)?.0.last().copied()?;
            Some(if most > 0.0 { 1.0 / most } else { 1.0 })
        });
        Some(Self {
            problem,
            stiffness: stiffness.collect::<Option<_>>()?,
            motions,
        })
    }

    /// The motions of what floats, orthonormal.
    pub fn motions(&self) -> &Rows {
        &self.motions
    }

    /// The residual of λ with B u − c, see [`residual`].
    pub fn residual(&self, lambda: &[f64], relative: &[f64]) -> f64 {
        residual(self.problem, &self.stiffness, lambda, relative)
    }
}

/// An orthonormal basis of the kernel of K.
pub fn motions(problem: &Problem) -> Option<Rows> {
    let mut motions = Vec::new();
    let mut first = 0;
    for block in &problem.stiffness {
        for own in kernel(block)? {
            let mut motion = vec![0.0; problem.dofs()];
            motion[first..first + own.len()].copy_from_slice(&own);
            motions.push(motion);
        }
        first += block.len();
    }
    Some(motions)
}

/// The largest of |λ − P(λ + ρ (Bu − c))| over the pairs, P the projection on the forces that their law allows
/// under the normal force there is, over the largest force or ρ |Bu − c|; zero for a solution alone.
pub fn residual(problem: &Problem, stiffness: &[f64], lambda: &[f64], relative: &[f64]) -> f64 {
    let (m, tangents) = (problem.pairs(), problem.tangents);
    let (mut worst, mut scale) = (0.0_f64, largest(lambda));
    let mut take = |apart: f64| {
        if apart > worst || apart.is_nan() {
            worst = apart;
        }
    };
    for (pair, law) in problem.laws.iter().enumerate() {
        let rho = stiffness[pair];
        let (force, gap) = (lambda[pair], relative[pair]);
        let rows = m + tangents * pair..m + tangents * (pair + 1);
        scale = scale.max(rho * gap.abs());
        let moved = force + rho * gap;
        let normal = if is_closed(law) {
            moved
        } else {
            moved.max(0.0)
        };
        take((force - normal).abs());
        let (own, slip) = (&lambda[rows.clone()], &relative[rows]);
        scale = scale.max(rho * largest(slip));
        let Some(bounds) = bounds(law, force) else {
            take(rho * largest(slip));
            continue;
        };
        let allowed = allowed(law, own, slip, rho, bounds);
        for (own, allowed) in own.iter().zip(allowed) {
            take((own - allowed).abs());
        }
    }
    if scale > 0.0 { worst / scale } else { worst }
}

/// The friction force that λτ + ρ · slip is projected on.
fn allowed(law: &PairLaw, own: &[f64], slip: &[f64], rho: f64, bounds: [f64; 2]) -> Vec<f64> {
    let figures = figures(law, bounds);
    let most = figures[..own.len()].iter().fold(0.0, |a: f64, b| a.max(*b));
    // In the coordinates in which the ellipse is a disc.
    let moved: Vec<f64> = own
        .iter()
        .zip(slip)
        .zip(figures)
        .map(|((own, slip), figure)| {
            let weight = if most > 0.0 { figure / most } else { 0.0 };
            own + rho * weight * weight * slip
        })
        .collect();
    onto(law, &moved, bounds)
}

/// The two figures whose ratio is that of the axes, without a normal force, too.
fn figures(law: &PairLaw, bounds: [f64; 2]) -> [f64; 2] {
    match *law {
        PairLaw::Coulomb { coefficients, .. } => coefficients,
        _ => bounds,
    }
}

/// The nearest friction force that the law allows, in the coordinates in which its ellipse is a disc.
pub fn onto(law: &PairLaw, force: &[f64], bounds: [f64; 2]) -> Vec<f64> {
    let tangents = force.len();
    let figures = &figures(law, bounds)[..tangents];
    let most = figures.iter().fold(0.0, |a: f64, b| a.max(*b));
    let radius = bounds[..tangents].iter().fold(0.0, |a: f64, b| a.max(*b));
    let scaled = force.iter().zip(figures);
    let scaled: Vec<f64> = scaled
        .map(|(x, f)| if *f > 0.0 { x / (f / most) } else { 0.0 })
        .collect();
    let length = dot(&scaled, &scaled).sqrt();
    let shrink = if length > radius {
        radius / length
    } else {
        1.0
    };
    let back = scaled.iter().zip(figures);
    back.map(|(x, f)| {
        if *f > 0.0 {
            x * shrink * (f / most)
        } else {
            0.0
        }
    })
    .collect()
}
