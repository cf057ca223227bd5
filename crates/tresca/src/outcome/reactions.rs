//! What supports put on the nodes of a body.

use tresca_fem::FemError;
use tresca_fem::assembly::internal_forces;
use tresca_fem::dofs::DofMap;
use tresca_model::Body;

/// The reactions at a body's nodes, over its full dofs; zero at free ones. A held dof hands on what the
/// elements put on it, less the load and the contact there.
pub(crate) fn nodal_reactions(
    body: &Body,
    dofs: &DofMap,
    displacement: &[f64],
    load: &[f64],
    contact: &[f64],
) -> Result<Vec<f64>, FemError> {
    let internal = internal_forces(
        &body.mesh,
        &body.material,
        body.formulation,
        displacement,
        None,
    )?;
    let acting = load.iter().zip(contact);
    let left: Vec<f64> = internal
        .iter()
        .zip(acting)
        .map(|(internal, (load, contact))| internal - load - contact)
        .collect();
    Ok(dofs.support_forces(&left))
}
