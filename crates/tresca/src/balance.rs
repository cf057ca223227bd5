//! Force and moment balance of a body, for the certificate.

use tresca_fem::loads::{Resultant, resultant};
use tresca_la::vector::norm;
use tresca_model::Body;
use tresca_system::certificate::{BodyBalance, scale};

/// A body on which less than this part of the forces on the others acts is measured by that part.
const LEAST_SHARE: f64 = 1e-4;

/// Σ of the magnitudes of nodal forces.
pub(crate) fn magnitude(body: &Body, forces: &[f64]) -> f64 {
    let nodes = forces.chunks_exact(body.mesh.dimension());
    nodes.map(norm).sum()
}

/// The balance of a body: `[load, contact, reaction]` over its full dofs, relative to what acts on it. `largest` is
/// what acts on the body on which most does.
pub(crate) fn balance(body: &Body, parts: [&[f64]; 3], largest: f64) -> BodyBalance {
    let bounds = body.mesh.bounding_box();
    let centre = std::array::from_fn(|k| 0.5 * (bounds.min[k] + bounds.max[k]));
    let resultants = parts.map(|part| resultant(&body.mesh, part, centre));
    let total = |pick: fn(&Resultant) -> [f64; 3]| {
        let sum: [f64; 3] =
            std::array::from_fn(|k| resultants.iter().map(|part| pick(part)[k]).sum());
        norm(&sum)
    };
    let forces: f64 = parts.iter().map(|part| magnitude(body, part)).sum();
    let magnitude = scale(forces.max(LEAST_SHARE * largest));
    BodyBalance::new(
        body.name.clone(),
        resultants.map(|part| part.force),
        total(|part| part.force) / magnitude,
        total(|part| part.moment) / (magnitude * bounds.diagonal()),
    )
}
