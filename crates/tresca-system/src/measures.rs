//! The sums that a certificate is made of, whoever brought the matrices.

use tresca_contact::Sliding;
use tresca_la::vector::{dot, norm};

use crate::ellipse::Ellipse;
use crate::layout::Layout;

/// A body that has moved without strain has forces and an energy all the same, from rounding in Ku. What
/// is below these parts of diag(K)u, and of uᵀdiag(K)u, is no figure to compare with.
pub const ROUNDING_OF_FORCES: f64 = 1e-6;
const ROUNDING_OF_ENERGY: f64 = 1e-10;

/// What the bodies say: energies and the residual of equilibrium.
#[derive(Debug)]
pub(crate) struct Elastic {
    /// ‖Ku + Bᵀλ − f‖ relative to the forces that balance.
    pub residual: f64,
    /// uᵀKu.
    pub strain_work: f64,
    /// fᵀu.
    pub load_work: f64,
    /// The energy that others are compared with: ½uᵀKu, unless that is rounding.
    pub energy: f64,
}

/// The same of one body.
#[derive(Default)]
pub(crate) struct ElasticSums {
    residual: f64,
    strain_work: f64,
    load_work: f64,
    /// Squared norms of f, Bᵀλ, Ku and diag(K)u.
    squares: [f64; 4],
    /// uᵀdiag(K)u.
    rigid_work: f64,
}

impl ElasticSums {
    /// Adds u, f, the contact forces −Bᵀλ on it, Ku and diag(K), over the free dofs.
    pub fn add(
        &mut self,
        u: &[f64],
        f: &[f64],
        contact: &[f64],
        internal: &[f64],
        diagonal: &[f64],
    ) {
        self.strain_work += dot(u, internal);
        self.load_work += dot(u, f);
        let rigid: Vec<f64> = diagonal.iter().zip(u).map(|(k, u)| k * u).collect();
        self.rigid_work += dot(u, &rigid);
        for (square, forces) in self.squares.iter_mut().zip([f, contact, internal, &rigid]) {
            *square += dot(forces, forces);
        }
        for ((k, c), f) in internal.iter().zip(contact).zip(f) {
            self.residual += (k - c - f).powi(2);
        }
    }

    /// The figures of all bodies.
    pub fn total(bodies: &[Self]) -> Elastic {
        let mut sum = Self::default();
        for body in bodies {
            sum.residual += body.residual;
            sum.strain_work += body.strain_work;
            sum.load_work += body.load_work;
            sum.rigid_work += body.rigid_work;
            for (square, own) in sum.squares.iter_mut().zip(body.squares) {
                *square += own;
            }
        }
        let [load, contact, internal, rigid] = sum.squares.map(f64::sqrt);
        let forces = load
            .max(contact)
            .max(internal)
            .max(ROUNDING_OF_FORCES * rigid);
        let rounding = ROUNDING_OF_ENERGY * sum.rigid_work;
        Elastic {
            residual: sum.residual.sqrt() / scale(forces),
            strain_work: sum.strain_work,
            load_work: sum.load_work,
            energy: scale(f64::max(0.5 * sum.strain_work, 0.5 * rounding)),
        }
    }
}

/// The pairs as they are to be measured.
pub(crate) struct Pairs<'a> {
    pub layout: &'a Layout,
    /// d.
    pub gaps: &'a [f64],
    /// The law of every pair.
    pub slidings: &'a [Sliding],
    /// λ = \[λν; λτ\], the contact forces.
    pub forces: &'a [f64],
    /// B u, the slip since where it is counted from.
    pub relative: &'a [f64],
}

/// What the pairs say.
#[derive(Default, Debug)]
pub(crate) struct Interface {
    pub penetration: f64,
    pub adhesion: f64,
    pub complementarity: f64,
    pub cone: f64,
    pub slip_law: f64,
    pub negative_work: f64,
    pub friction_work: f64,
    /// Σ λν (Nu − d) + Σ λτ·s, signed.
    contact_work: f64,
    pub largest_bound: f64,
    pub largest_normal: f64,
    pub largest_force: f64,
}

impl Interface {
    pub fn new(pairs: &Pairs<'_>) -> Self {
        let Pairs {
            layout,
            gaps,
            slidings,
            forces: lambda,
            relative,
        } = *pairs;
        let mut sum = Self {
            largest_normal: largest(&lambda[..gaps.len()]),
            largest_force: largest(lambda),
            ..Self::default()
        };
        for (i, gap) in gaps.iter().enumerate() {
            let overlap = relative[i] - gap;
            sum.complementarity += (lambda[i] * overlap).abs();
            sum.contact_work += lambda[i] * overlap;
            let [normal, along] = layout.scale(i);
            if !layout.moves_normally(i) {
                // Supports alone decide about this gap.
            } else if layout.never_opens(i) {
                sum.penetration = sum.penetration.max(normal * overlap.abs());
            } else {
                sum.penetration = sum.penetration.max(normal * overlap);
                sum.adhesion = sum.adhesion.max(-lambda[i]);
            }
            let force = layout.tangential(lambda, i);
            let slip = layout.tangential(relative, i);
            let Some(bounds) = slidings[i].bounds(lambda[i]) else {
                sum.penetration = sum.penetration.max(along * norm(&slip));
                sum.contact_work += dot(&force, &slip);
                continue;
            };
            sum.contact_work += dot(&force, &slip);
            let ellipse = Ellipse(bounds);
            let work = ellipse.support(slip);
            sum.cone = sum.cone.max(ellipse.excess(force));
            let dissipated = dot(&force, &slip);
            sum.slip_law += (work - dissipated).abs();
            sum.negative_work += f64::max(-dissipated, 0.0);
            sum.friction_work += work;
            sum.largest_bound = sum.largest_bound.max(ellipse.largest());
        }
        sum
    }

    /// Primal less dual energy where equilibrium holds by construction: Σ h(s) − λᵀ(Bu − c).
    pub fn duality_gap(&self) -> f64 {
        self.friction_work - self.contact_work
    }
}

/// The largest absolute value.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a: f64, x| a.max(x.abs()))
}

/// A scale that a figure may be divided by: 1 for a problem in which nothing happens.
pub fn scale(value: f64) -> f64 {
    if value > 0.0 { value } else { 1.0 }
}
