//! What goes into a coupling: two sides, and what happens between them.

use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{Face, Mesh};

use crate::friction::FrictionLaw;
use crate::scalar_field::ScalarField;
use crate::surface::patches::SmoothPatches;

/// One side of a contact: a surface of a body.
#[derive(Clone, Copy)]
pub struct Side<'a> {
    /// The body's mesh.
    pub mesh: &'a Mesh,
    /// The faces that may come into contact.
    pub faces: &'a [Face],
    /// The smooth patches of a slave surface (see [`crate::patches`]): a node has a pair for each that meets
    /// there. `None` for a surface that is one patch. Not looked at on the master side.
    pub patches: Option<&'a SmoothPatches>,
    /// The body's dofs: a pair that supports hold completely is left out.
    pub dofs: &'a DofMap,
    /// Nodes of a slave surface that have a pair in another contact already, along an edge that the two
    /// contacts share. A second set of rows there could depend on the first, so mortar coupling and
    /// obstacles leave these nodes to it and give their share to the neighbours. Coupling node by node
    /// leaves out those pairs of which both nodes are taken; of the master side it is told the nodes that
    /// have pairs with the same slave body.
    pub taken: &'a [usize],
}

/// What happens between the two sides.
#[derive(Clone, Copy)]
pub struct Interface<'a> {
    /// What resists sliding and opening.
    pub friction: &'a FrictionLaw,
    /// What is added to the gap between the meshes (a length); negative for an interference.
    pub gap: &'a ScalarField,
}
