//! The certificate: is this a solution? Computed from u and λ alone, afterwards, with the
//! assembled K and the element forces, by a way that knows nothing of the solver's residuals.
//!
//! Every figure is dimensionless, and zero for an exact solution.

use serde::Serialize;
use tresca_fem::FemError;
use tresca_fem::assembly::internal_forces;
use tresca_fem::loads::{Resultant, resultant};
use tresca_la::vector::{dot, norm};

use crate::ModelError;
use crate::assemble::{Assembled, BodySystem};
use crate::model::Model;

/// How far a pair (u, λ) is from solving the contact problem (docs/theory.md, "The contact problem").
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Certificate {
    /// ‖Ku + Bᵀλ − f‖ / ‖f‖ over the free dofs of all bodies.
    pub equilibrium: f64,
    /// Largest penetration max(Nu − d, 0), over the largest displacement component.
    pub penetration: f64,
    /// Largest adhesive normal force max(−λν, 0), over the largest normal force.
    pub normal_force_sign: f64,
    /// Σ |λν,i (Nu − d)_i| over the elastic energy ½uᵀKu.
    pub complementarity: f64,
    /// Largest excess of a friction force over its slip bound, over the largest slip bound.
    pub cone_violation: f64,
    /// Σ |g_i ‖(Tu)_i‖ − λτ,i·(Tu)_i| over the elastic energy: zero exactly when every pair
    /// that slips does so along its friction force, at its bound.
    pub slip_law: f64,
    /// (primal energy − dual energy) over the elastic energy, with the primal energy
    /// ½uᵀKu − fᵀu + Σ g_i‖(Tu)_i‖ and the dual energy −q(λ) − ½fᵀK⁻¹f.
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
    pub fn items(&self) -> [(&'static str, f64); 7] {
        [
            ("equilibrium", self.equilibrium),
            ("penetration", self.penetration),
            ("normal force sign", self.normal_force_sign),
            ("complementarity", self.complementarity),
            ("cone violation", self.cone_violation),
            ("slip law", self.slip_law),
            ("duality gap", self.duality_gap),
        ]
    }
}

/// What is to be certified.
pub struct Candidate<'a> {
    /// λ = \[λν; λτ\], length 3m.
    pub lambda: &'a [f64],
    /// Displacement of each body over its full dofs.
    pub displacements: &'a [Vec<f64>],
    /// q(λ) as the solver reported it.
    pub dual_objective: f64,
    /// fᵀK⁻¹f: twice the energy of the bodies without contact.
    pub load_energy: f64,
}

/// Certifies a candidate solution.
///
/// # Errors
/// When an element is degenerate (never after a successful assembly).
pub fn certify(
    model: &Model,
    assembled: &Assembled,
    candidate: &Candidate<'_>,
) -> Result<Certificate, ModelError> {
    let lambda = candidate.lambda;
    let m = assembled.pair_count();
    let (normal, tangential) = lambda.split_at(m);

    let mut residual_squared = 0.0;
    let mut load_squared = 0.0;
    let mut strain_work = 0.0; // uᵀKu
    let mut load_work = 0.0; // fᵀu
    let mut relative = vec![0.0; 3 * m]; // B u
    for (system, full) in assembled.bodies.iter().zip(candidate.displacements) {
        let u = system.dofs.restrict(full);
        let f = system.free_load();
        let mut forces = vec![0.0; u.len()];
        system.stiffness.mul(&u, &mut forces);
        strain_work += dot(&u, &forces);
        load_work += dot(&u, &f);
        system.coupling.add_transposed_product(lambda, &mut forces);
        let difference: Vec<f64> = forces.iter().zip(&f).map(|(a, b)| a - b).collect();
        residual_squared += dot(&difference, &difference);
        load_squared += dot(&f, &f);
        system.coupling.add_product(&u, &mut relative);
    }
    let elastic = scale(0.5 * strain_work);
    let largest = |values: &[f64]| values.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
    let largest_displacement = candidate
        .displacements
        .iter()
        .map(|u| largest(u))
        .fold(0.0, f64::max);

    let mut penetration: f64 = 0.0;
    let mut complementarity = 0.0;
    let mut cone: f64 = 0.0;
    let mut slip_law = 0.0;
    let mut friction_work = 0.0;
    let mut largest_bound: f64 = 0.0;
    let (approach, slips) = relative.split_at(m);
    for (i, pair) in assembled.pairs().enumerate() {
        let overlap = approach[i] - pair.gap;
        penetration = penetration.max(overlap);
        complementarity += (normal[i] * overlap).abs();
        let force = &tangential[2 * i..2 * i + 2];
        let slip = &slips[2 * i..2 * i + 2];
        let bound = pair.slip_bound;
        cone = cone.max(norm(force) - bound);
        slip_law += (bound * norm(slip) - dot(force, slip)).abs();
        friction_work += bound * norm(slip);
        largest_bound = largest_bound.max(bound);
    }
    let primal = 0.5 * strain_work - load_work + friction_work;
    let dual = -candidate.dual_objective - 0.5 * candidate.load_energy;
    let cone_scale = if largest_bound > 0.0 {
        largest_bound
    } else {
        largest(lambda)
    };
    Ok(Certificate {
        equilibrium: residual_squared.sqrt() / scale(load_squared.sqrt()),
        penetration: penetration.max(0.0) / scale(largest_displacement),
        normal_force_sign: normal.iter().fold(0.0, |a: f64, x| a.max(-x)) / scale(largest(normal)),
        complementarity: complementarity / elastic,
        cone_violation: cone.max(0.0) / scale(cone_scale),
        slip_law: slip_law / elastic,
        duality_gap: (primal - dual) / elastic,
        bodies: model
            .bodies()
            .iter()
            .enumerate()
            .map(|(index, body)| {
                balance(model, assembled, candidate, index).map_err(|source| ModelError::Body {
                    body: body.name.clone(),
                    source,
                })
            })
            .collect::<Result<_, _>>()?,
    })
}

/// A scale that a figure may be divided by: 1 for a problem in which nothing happens.
fn scale(value: f64) -> f64 {
    if value > 0.0 { value } else { 1.0 }
}

fn balance(
    model: &Model,
    assembled: &Assembled,
    candidate: &Candidate<'_>,
    index: usize,
) -> Result<BodyBalance, FemError> {
    let body = &model.bodies()[index];
    let system: &BodySystem = &assembled.bodies[index];
    let contact = contact_forces(model, assembled, candidate.lambda, index);
    let internal = internal_forces(&body.mesh, &body.material, &candidate.displacements[index])?;
    // A held dof hands on what the elements put on it, less the load and the contact there.
    let mut reaction = vec![0.0; internal.len()];
    for dof in system.dofs.prescribed() {
        reaction[dof] = internal[dof] - system.load[dof] - contact[dof];
    }

    let bounds = body.mesh.bounding_box();
    let centre = std::array::from_fn(|k| 0.5 * (bounds.min[k] + bounds.max[k]));
    let parts = [&system.load, &contact, &reaction];
    let resultants = parts.map(|part| resultant(&body.mesh, part, centre));
    let total = |pick: fn(&Resultant) -> [f64; 3]| {
        let sum: [f64; 3] =
            std::array::from_fn(|k| resultants.iter().map(|part| pick(part)[k]).sum());
        norm(&sum)
    };
    let magnitude = scale(
        parts
            .iter()
            .flat_map(|part| part.chunks_exact(3))
            .map(norm)
            .sum(),
    );
    Ok(BodyBalance {
        name: body.name.clone(),
        force: total(|part| part.force) / magnitude,
        moment: total(|part| part.moment) / (magnitude * bounds.diagonal()),
        load: resultants[0].force,
        contact: resultants[1].force,
        reaction: resultants[2].force,
    })
}

/// Contact forces on a body over its full dofs, from the pairs and their frames: the slave
/// feels −(λν ν + λτ τ), the master the opposite.
fn contact_forces(model: &Model, assembled: &Assembled, lambda: &[f64], body: usize) -> Vec<f64> {
    let m = assembled.pair_count();
    let mut forces = vec![0.0; assembled.bodies[body].dofs.full_len()];
    let mut first = 0;
    for (contact, data) in model.contacts().iter().zip(&assembled.contacts) {
        for (offset, pair) in data.pairs.iter().enumerate() {
            let i = first + offset;
            let force = pair
                .frame
                .to_global([lambda[i], lambda[m + 2 * i], lambda[m + 2 * i + 1]]);
            let sides = [
                (contact.slave.body, pair.slave_node, -1.0),
                (contact.master.body, pair.master_node, 1.0),
            ];
            for (owner, node, sign) in sides {
                if owner == body {
                    for k in 0..3 {
                        forces[3 * node + k] += sign * force[k];
                    }
                }
            }
        }
        first += data.pairs.len();
    }
    forces
}
