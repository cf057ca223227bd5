//! The contact in figures.

use serde::Serialize;

use tresca_fem::vector3::cross;
use tresca_model::Model;

use crate::pair_state::PairState;

/// The contact in figures. What a door does not know is left out.
#[derive(Debug, Clone, Default, Serialize)]
#[non_exhaustive]
pub struct ContactReport {
    /// Contact pairs.
    pub pairs: usize,
    /// Pairs that carry a normal force.
    pub closed: usize,
    /// Pairs that do not.
    pub open: usize,
    /// Open pairs that carry friction all the same: Tresca's bound does not ask for pressure.
    pub open_with_friction: usize,
    /// Closed pairs whose friction force is below the slip bound.
    pub stick: usize,
    /// Closed pairs at the slip bound.
    pub slip: usize,
    /// Pairs left out, or without effect, because nothing lets them move; of cases and matrices.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub held: Option<usize>,
    /// Σ λν.
    pub normal_force_sum: f64,
    /// Largest contact pressure; of cases.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_pressure: Option<f64>,
    /// Largest component, in the pair's frame, of the slip.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_slip_component: Option<f64>,
    /// Largest gap left.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_gap: Option<f64>,
    /// Work that friction dissipates in the step; of cases.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dissipation: Option<f64>,
}

/// The largest of some values and 0.
pub(super) fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

/// Resultant of one contact.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct ContactResultant {
    /// Name of the contact in the case, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The slave surface, as `body.faces`.
    pub slave: String,
    /// The master surface.
    pub master: String,
    /// Σ λν.
    pub normal_force_sum: f64,
    /// Σ (λν ν + λτ) in global components: the force on the master; the slave feels the opposite. In an
    /// axisymmetric model the radial parts of a ring cancel: the first entry is their sum nevertheless.
    pub force: [f64; 3],
    /// Moment of that force about the origin of the coordinates, the slave points being its points of
    /// attack.
    pub moment: [f64; 3],
}

/// The resultants of the contacts, in the order of the model.
pub(super) fn resultants(model: &Model, contacts: &[Vec<PairState>]) -> Vec<ContactResultant> {
    let contacts = model.contacts().iter().zip(contacts);
    contacts
        .map(|(contact, pairs)| {
            let force = |pair: &PairState| -> [f64; 3] {
                let normal = pair.pair.frame.normal;
                std::array::from_fn(|k| pair.normal_force * normal[k] + pair.friction_force[k])
            };
            ContactResultant {
                name: contact.name.clone(),
                slave: model.surface_name(&contact.slave),
                master: model.partner_name(&contact.master),
                normal_force_sum: pairs.iter().map(|pair| pair.normal_force).sum(),
                force: std::array::from_fn(|k| pairs.iter().map(|pair| force(pair)[k]).sum()),
                moment: std::array::from_fn(|k| {
                    let arms = pairs
                        .iter()
                        .map(|pair| cross(pair.pair.point, force(pair))[k]);
                    arms.sum()
                }),
            }
        })
        .collect()
}
