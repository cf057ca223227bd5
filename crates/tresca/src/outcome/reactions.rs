//! What supports put on the nodes of a body.

use tresca_fem::FemError;
use tresca_fem::assembly::internal_forces;

use crate::assemble::Assembled;
use crate::load_step::Acting;
use crate::model::Model;

/// The reactions at a body's nodes, over its full dofs; zero at free ones. A held dof hands on what the
/// elements put on it, less the load and the contact there.
pub(crate) fn nodal_reactions(
    model: &Model,
    assembled: &Assembled,
    acting: &Acting,
    displacements: &[Vec<f64>],
    lambda: &[f64],
    index: usize,
) -> Result<Vec<f64>, FemError> {
    let body = &model.bodies()[index];
    let contact = assembled.contact_forces(index, lambda);
    let load = &acting.loads[index];
    let internal = internal_forces(
        &body.mesh,
        &body.material,
        body.formulation,
        &displacements[index],
    )?;
    let mut reaction = vec![0.0; internal.len()];
    for dof in assembled.bodies[index].dofs.prescribed() {
        reaction[dof] = internal[dof] - load[dof] - contact[dof];
    }
    Ok(reaction)
}
