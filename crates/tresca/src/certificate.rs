//! The certificate: is this a solution? Computed from u and λ alone, afterwards, with the
//! assembled K and the element forces, by a way that knows nothing of the solver's residuals.
//!
//! Every figure is dimensionless, and zero for an exact solution.

use serde::Serialize;
use tresca_fem::loads::{Resultant, resultant};
use tresca_la::vector::norm;

use crate::assemble::Assembled;
use crate::load_step::Acting;
use crate::measures::{
    ElasticSums, Interface, Pairs, ROUNDING_OF_FORCES, certificate, largest, scale,
};
use crate::model::Model;

/// How far a pair (u, λ) is from solving the contact problem (docs/theory.md, "The contact problem").
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Certificate {
    /// ‖Ku + Bᵀλ − f‖ over the largest of ‖f‖, ‖Bᵀλ‖ and ‖Ku‖, over the free dofs of all bodies.
    pub equilibrium: f64,
    /// Largest penetration max(Nu − d, 0), over the largest displacement component or gap. Of pairs that
    /// never open, |Nu − d|; of glued ones, also |Tu|.
    pub penetration: f64,
    /// Largest adhesive normal force max(−λν, 0) of pairs that may open, over the largest normal force.
    pub normal_force_sign: f64,
    /// Σ |λν,i (Nu − d)_i| over the elastic energy ½uᵀKu.
    pub complementarity: f64,
    /// Largest excess of a friction force over its slip bound (with Coulomb's law, over F λν), over the
    /// largest slip bound.
    pub cone_violation: f64,
    /// Σ |h_i(s_i) − λτ,i·s_i| over the elastic energy, s the slip of the step and h the work that
    /// friction at its bound dissipates along it, g‖s‖ for isotropic friction: zero exactly when every pair
    /// that slips does so at its bound in the direction that its law asks for.
    pub slip_law: f64,
    /// Σ max(−λτ,i·s_i, 0) over the elastic energy: friction only ever takes work out.
    pub negative_dissipation: f64,
    /// (primal energy − dual energy) over the elastic energy, with the primal energy
    /// ½uᵀKu − fᵀu + Σ h_i(s_i) and the dual energy −q(λ) − ½fᵀK⁺f. With Coulomb's law that of the
    /// problem whose bounds are F λν.
    pub duality_gap: f64,
    /// Force and moment balance body by body.
    pub bodies: Vec<BodyBalance>,
}

/// Loads, contact forces and support reactions of one body must cancel. The reactions
/// come from the stresses of the elements at the supports.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BodyBalance {
    /// Name of the body.
    pub name: String,
    /// ‖Σ forces‖ over the sum of their magnitudes.
    pub force: f64,
    /// ‖Σ moments‖ about the body's centre, over that sum times the body's diameter.
    pub moment: f64,
    /// Resultant of the loads.
    pub load: [f64; 3],
    /// Resultant of the contact forces.
    pub contact: [f64; 3],
    /// Resultant of the support reactions.
    pub reaction: [f64; 3],
}

impl Certificate {
    /// The worst of all figures.
    pub fn worst(&self) -> f64 {
        let balances = self
            .bodies
            .iter()
            .flat_map(|body| [body.force, body.moment]);
        self.items()
            .into_iter()
            .map(|(_, value)| value.abs())
            .chain(balances)
            .fold(0.0, f64::max)
    }

    /// The figures that concern the whole model, with their names.
    pub fn items(&self) -> [(&'static str, f64); 8] {
        [
            ("equilibrium", self.equilibrium),
            ("penetration", self.penetration),
            ("normal force sign", self.normal_force_sign),
            ("complementarity", self.complementarity),
            ("cone violation", self.cone_violation),
            ("slip law", self.slip_law),
            ("negative dissipation", self.negative_dissipation),
            ("duality gap", self.duality_gap),
        ]
    }
}

/// What is to be certified.
pub struct Candidate<'a> {
    /// λ = \[λν; λτ\], the contact forces, length d m.
    pub lambda: &'a [f64],
    /// Displacement of each body over its full dofs.
    pub displacements: &'a [Vec<f64>],
    /// B u of the step before.
    pub previous: &'a [f64],
    /// Loads, prescribed displacements and laws of the step.
    pub acting: &'a Acting,
    /// Reactions of the supports on each body, over its full dofs.
    pub reactions: &'a [Vec<f64>],
    /// q(λ) as the solver reported it.
    pub dual_objective: f64,
    /// fᵀK⁺f: twice the energy of the bodies without contact.
    pub load_energy: f64,
}

/// Certifies a candidate solution.
pub fn certify(model: &Model, assembled: &Assembled, candidate: &Candidate<'_>) -> Certificate {
    let layout = &assembled.layout;
    let mut elastic = ElasticSums::default();
    for (index, system) in assembled.bodies.iter().enumerate() {
        let u = system.dofs.free_part(&candidate.displacements[index]);
        let f = &candidate.acting.free_loads[index];
        let contact = system
            .dofs
            .restrict(&assembled.contact_forces(index, candidate.lambda));
        let mut internal = vec![0.0; u.len()];
        system.stiffness.mul(&u, &mut internal);
        elastic.add(&u, f, &contact, &internal, &system.stiffness.diagonal());
    }
    let gaps: Vec<f64> = assembled.pairs().map(|pair| pair.gap).collect();
    let interface = Interface::new(&Pairs {
        layout,
        gaps: &gaps,
        slidings: &candidate.acting.slidings,
        lambda: candidate.lambda,
        relative: &candidate
            .acting
            .relative(assembled, candidate.displacements),
        previous: candidate.previous,
    });
    let displacements = candidate.displacements.iter().map(|u| largest(u));
    let length = displacements.chain([largest(&gaps)]).fold(0.0, f64::max);
    let dual = -candidate.dual_objective - 0.5 * candidate.load_energy;
    let bodies = 0..model.bodies().len();
    Certificate {
        bodies: bodies
            .map(|index| balance(model, assembled, candidate, index))
            .collect(),
        ..certificate(&elastic.total(), &interface, length, dual)
    }
}

fn balance(
    model: &Model,
    assembled: &Assembled,
    candidate: &Candidate<'_>,
    index: usize,
) -> BodyBalance {
    let body = &model.bodies()[index];
    let system = &assembled.bodies[index];
    let contact = assembled.contact_forces(index, candidate.lambda);
    let load = &candidate.acting.loads[index];
    let reaction = &candidate.reactions[index];

    let bounds = body.mesh.bounding_box();
    let centre = std::array::from_fn(|k| 0.5 * (bounds.min[k] + bounds.max[k]));
    let parts = [load, &contact, reaction];
    let resultants = parts.map(|part| resultant(&body.mesh, part, centre));
    let total = |pick: fn(&Resultant) -> [f64; 3]| {
        let sum: [f64; 3] =
            std::array::from_fn(|k| resultants.iter().map(|part| pick(part)[k]).sum());
        norm(&sum)
    };
    let nodes = |part: &[f64]| {
        part.chunks_exact(body.mesh.dimension())
            .map(norm)
            .sum::<f64>()
    };
    let forces: f64 = parts.iter().map(|part| nodes(part)).sum();
    let mut rigid = system.stiffness.diagonal();
    let u = system.dofs.free_part(&candidate.displacements[index]);
    rigid.iter_mut().zip(&u).for_each(|(k, u)| *k *= u);
    let rounding = ROUNDING_OF_FORCES * nodes(&system.dofs.expand(&rigid));
    let magnitude = scale(forces.max(rounding));
    BodyBalance {
        name: body.name.clone(),
        force: total(|part| part.force) / magnitude,
        moment: total(|part| part.moment) / (magnitude * bounds.diagonal()),
        load: resultants[0].force,
        contact: resultants[1].force,
        reaction: resultants[2].force,
    }
}
