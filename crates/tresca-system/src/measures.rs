//! The sums that a certificate is made of, whoever brought the matrices.

use tresca_contact::Sliding;
use tresca_la::vector::{dot, norm};

use crate::ellipse::Ellipse;
use crate::layout::Layout;

/// What rounding may do to a displacement, relative to what the loads would do without contact, and to an energy,
/// relative to the work of the forces along such displacements. Below, a figure compares with nothing.
const ROUNDING: f64 = 1e-9;
/// A body on which less than this part of the forces on the others acts is measured by that part.
const LEAST_SHARE: f64 = 1e-4;

/// A bound that is this many times the largest force is never reached.
const NEVER_REACHED: f64 = 1e3;

/// What the bodies say: energies and the residual of equilibrium.
#[derive(Debug)]
pub(crate) struct Elastic {
    /// The largest of all bodies of ‖Kv + Bᵀλ − f‖ over the forces that act on it.
    pub residual: f64,
    /// vᵀKv, v the displacement without rigid motions.
    pub strain_work: f64,
    /// fᵀu.
    pub load_work: f64,
    /// Σ |f_i u_i|.
    pub load_work_size: f64,
    /// The largest nodal load.
    pub largest_load: f64,
}

/// The same of one body.
#[derive(Default)]
pub(crate) struct ElasticSums {
    residual: f64,
    strain_work: f64,
    load_work: f64,
    load_work_size: f64,
    /// ‖f‖ and ‖Bᵀλ‖, whichever is larger.
    forces: f64,
    /// ‖Kv‖.
    internal: f64,
    largest_load: f64,
}

/// What a body is measured by, over its free dofs.
pub(crate) struct BodyState<'a> {
    /// u.
    pub displacement: &'a [f64],
    /// v = u without the rigid motion that contact decides about: K v = K u, without the rounding of far motions.
    pub strained: &'a [f64],
    /// f.
    pub load: &'a [f64],
    /// −Bᵀλ.
    pub contact: &'a [f64],
    /// K v.
    pub internal: &'a [f64],
}

impl ElasticSums {
    /// Of one body.
    pub fn new(body: &BodyState) -> Self {
        let BodyState {
            displacement,
            strained,
            load,
            contact,
            internal,
        } = *body;
        let residual: Vec<f64> = internal
            .iter()
            .zip(contact)
            .zip(load)
            .map(|((k, c), f)| k - c - f)
            .collect();
        let works = load.iter().zip(displacement).map(|(f, u)| (f * u).abs());
        Self {
            residual: norm(&residual),
            strain_work: dot(strained, internal),
            load_work: dot(displacement, load),
            load_work_size: works.sum(),
            forces: norm(load).max(norm(contact)),
            internal: norm(internal),
            largest_load: largest(load),
        }
    }

    /// The figures of all bodies.
    pub fn total(bodies: &[Self]) -> Elastic {
        let all = bodies.iter().map(|body| body.forces).fold(0.0, f64::max);
        let relative = |body: &Self| {
            // Where no force acts at all, what moves without strain has rounding alone for a residual.
            let forces = match all {
                0.0 => body.internal,
                all => body.forces.max(LEAST_SHARE * all),
            };
            body.residual / scale(forces)
        };
        let sum = |pick: fn(&Self) -> f64| bodies.iter().map(pick).sum();
        Elastic {
            residual: bodies.iter().map(relative).fold(0.0, f64::max),
            strain_work: sum(|body| body.strain_work),
            load_work: sum(|body| body.load_work),
            load_work_size: sum(|body| body.load_work_size),
            largest_load: bodies.iter().map(|b| b.largest_load).fold(0.0, f64::max),
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
    /// The largest force that acts on the bodies otherwise.
    pub largest_load: f64,
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
    /// Σ of the absolute values, as forces on bodies.
    pub forces: f64,
    pub largest_bound: f64,
    pub largest_normal: f64,
    /// The largest force of all, loads included.
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
            largest_load,
        } = *pairs;
        let mut sum = Self {
            largest_normal: largest(&lambda[..gaps.len()]),
            largest_force: largest(lambda).max(largest_load),
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
            sum.forces += (lambda[i] / normal).abs() + norm(&force) / along;
            let slip = layout.tangential(relative, i);
            let Some(bounds) = slidings[i].bounds(lambda[i]) else {
                sum.penetration = sum.penetration.max(along * norm(&slip));
                sum.contact_work += dot(&force, &slip);
                continue;
            };
            sum.contact_work += dot(&force, &slip);
            sum.cone = sum.cone.max(Ellipse(bounds).excess(force));
            // A bound far above every force that acts ("never slips") is as good as a lower one that is not reached
            // either: a slip of rounding would count by it, and it dissipates nothing.
            let ceiling = NEVER_REACHED * sum.largest_force.max(norm(&force));
            let ellipse = Ellipse(bounds.map(|bound| bound.min(ceiling)));
            let work = ellipse.support(slip);
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

/// What the figures of a certificate are divided by.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scales {
    /// The largest displacement, and rounding in what the problem could have.
    pub length: f64,
    /// The elastic energy or what friction takes, and rounding in the work that the forces could do.
    pub energy: f64,
}

impl Scales {
    /// `moved` is the largest displacement, free or prescribed; `free` the largest one that the loads would cause
    /// without contact, or gap.
    pub fn new(elastic: &Elastic, interface: &Interface, moved: f64, free: f64) -> Self {
        let work = interface.forces * free.max(moved) + elastic.load_work_size;
        let energy = (0.5 * elastic.strain_work).max(interface.friction_work);
        Self {
            length: scale(moved.max(ROUNDING * free)),
            energy: scale(energy.max(ROUNDING * work)),
        }
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
