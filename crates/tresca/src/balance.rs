//! Force and moment balance of a body, for the certificate.

use tresca_fem::dofs::DofMap;
use tresca_fem::loads::{Resultant, resultant};
use tresca_la::vector::norm;
use tresca_model::Body;
use tresca_system::body::SystemBody;
use tresca_system::certificate::{BodyBalance, ROUNDING_OF_FORCES, scale};

/// The balance of a body: `[load, contact, reaction]` over its full dofs, u over its free ones.
pub(crate) fn balance(
    body: &Body,
    dofs: &DofMap,
    elastic: &SystemBody,
    parts: [&[f64]; 3],
    u: &[f64],
) -> BodyBalance {
    let bounds = body.mesh.bounding_box();
    let centre = std::array::from_fn(|k| 0.5 * (bounds.min[k] + bounds.max[k]));
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
    let mut rigid = elastic.stiffness.diagonal();
    rigid.iter_mut().zip(u).for_each(|(k, u)| *k *= u);
    let rounding = ROUNDING_OF_FORCES * nodes(&dofs.expand(&rigid));
    let magnitude = scale(forces.max(rounding));
    BodyBalance::new(
        body.name.clone(),
        resultants.map(|part| part.force),
        total(|part| part.force) / magnitude,
        total(|part| part.moment) / (magnitude * bounds.diagonal()),
    )
}
