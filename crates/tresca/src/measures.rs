//! The sums that a certificate is made of, whoever brought the matrices.

use tresca_contact::Sliding;
use tresca_la::vector::{dot, norm};

use crate::Certificate;
use crate::ellipse::Ellipse;
use crate::layout::Layout;

/// A body that has moved without strain has forces and an energy all the same, from rounding in Ku. What
/// is below these parts of diag(K)u, and of uᵀdiag(K)u, is no figure to compare with.
pub(crate) const ROUNDING_OF_FORCES: f64 = 1e-6;
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

/// The same while bodies are added.
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
    /// A body: u, f, the contact forces −Bᵀλ on it, Ku and diag(K), over the free dofs.
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
    pub fn total(&self) -> Elastic {
        let [load, contact, internal, rigid] = self.squares.map(f64::sqrt);
        let forces = load
            .max(contact)
            .max(internal)
            .max(ROUNDING_OF_FORCES * rigid);
        let rounding = ROUNDING_OF_ENERGY * self.rigid_work;
        Elastic {
            residual: self.residual.sqrt() / scale(forces),
            strain_work: self.strain_work,
            load_work: self.load_work,
            energy: scale(f64::max(0.5 * self.strain_work, 0.5 * rounding)),
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
    pub lambda: &'a [f64],
    /// B u.
    pub relative: &'a [f64],
    /// B u of the step before.
    pub previous: &'a [f64],
}

/// What the pairs say.
#[derive(Default, Debug)]
pub(crate) struct Interface {
    penetration: f64,
    adhesion: f64,
    complementarity: f64,
    cone: f64,
    slip_law: f64,
    negative_work: f64,
    friction_work: f64,
    /// Σ λν (Nu − d) + Σ λτ·s, signed.
    contact_work: f64,
    largest_bound: f64,
    largest_normal: f64,
    largest_force: f64,
}

impl Interface {
    pub fn new(pairs: &Pairs<'_>) -> Self {
        let Pairs {
            layout,
            gaps,
            slidings,
            lambda,
            relative,
            previous,
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
            if !layout.moves_normally(i) {
                // Supports alone decide about this gap.
            } else if layout.never_opens(i) {
                sum.penetration = sum.penetration.max(overlap.abs());
            } else {
                sum.penetration = sum.penetration.max(overlap);
                sum.adhesion = sum.adhesion.max(-lambda[i]);
            }
            let force = layout.tangential(lambda, i);
            let (now, before) = (
                layout.tangential(relative, i),
                layout.tangential(previous, i),
            );
            let slip = [now[0] - before[0], now[1] - before[1]];
            let Some(bounds) = slidings[i].bounds(lambda[i]) else {
                sum.penetration = sum.penetration.max(norm(&now));
                sum.contact_work += dot(&force, &now);
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

/// The certificate without the balance of bodies. `length` is the largest displacement or gap, `dual` the
/// dual energy.
pub(crate) fn certificate(
    elastic: &Elastic,
    interface: &Interface,
    length: f64,
    dual: f64,
) -> Certificate {
    let Elastic {
        residual,
        strain_work,
        load_work,
        energy,
    } = *elastic;
    let cone_scale = if interface.largest_bound > 0.0 {
        interface.largest_bound
    } else {
        interface.largest_force
    };
    let primal = 0.5 * strain_work - load_work + interface.friction_work;
    Certificate {
        equilibrium: residual,
        penetration: interface.penetration / scale(length),
        normal_force_sign: interface.adhesion / scale(interface.largest_normal),
        complementarity: interface.complementarity / energy,
        cone_violation: interface.cone / scale(cone_scale),
        slip_law: interface.slip_law / energy,
        negative_dissipation: interface.negative_work / energy,
        duality_gap: (primal - dual) / energy,
        bodies: Vec::new(),
    }
}

/// The largest absolute value.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a: f64, x| a.max(x.abs()))
}

/// A scale that a figure may be divided by: 1 for a problem in which nothing happens.
pub(crate) fn scale(value: f64) -> f64 {
    if value > 0.0 { value } else { 1.0 }
}
