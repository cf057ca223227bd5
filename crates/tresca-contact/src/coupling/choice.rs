//! The choice between the ways to couple two surfaces.

use tresca_fem::mesh::{Face, Mesh};

use super::mortar::couple::couple_mortar;
use super::node_by_node::couple_node_by_node;
use crate::data::ContactData;
use crate::error::ContactError;
use crate::interface::{Interface, Side};

/// How two surfaces are coupled.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum CouplingMethod {
    /// Node by node where the nodes of two surfaces of linear faces lie on one another, else mortar.
    #[default]
    Auto,
    /// Node by node: the nodes must lie on one another, and the faces be linear.
    NodeByNode,
    /// Mortar with dual multipliers: any two surfaces that face each other.
    Mortar,
}

/// Couples two surfaces.
///
/// `search` is how far in front of the slave surface, or behind it where the bodies overlap, the
/// mortar method looks for the master (a length). By default it is the largest of the slave face's size,
/// the master face's size and a tenth of the slave surface's diagonal: a pair whose surfaces come
/// closer by more than that should get a value of its own. Master faces that look away (angle between
/// the normals below 107°) are no partners.
///
/// # Errors
/// [`ContactError`] when the surfaces do not match (node by node), nothing of the master lies in
/// front of the slave (mortar), a surface has no normal somewhere, or the friction law or the gap gives
/// no possible value.
pub fn couple(
    slave: Side<'_>,
    master: Side<'_>,
    interface: Interface<'_>,
    method: CouplingMethod,
    search: Option<f64>,
) -> Result<ContactData, ContactError> {
    let linear = |mesh: &Mesh, faces: &[Face]| {
        let mut kinds = faces.iter().map(|&face| mesh.face_kind(face));
        kinds.all(|kind| kind.order() == 1)
    };
    match method {
        CouplingMethod::NodeByNode => couple_node_by_node(slave, master, interface),
        CouplingMethod::Mortar => couple_mortar(slave, master, interface, search),
        CouplingMethod::Auto => {
            if linear(slave.mesh, slave.faces) && linear(master.mesh, master.faces) {
                match couple_node_by_node(slave, master, interface) {
                    Err(
                        ContactError::NodeCounts { .. }
                        | ContactError::NoPartner { .. }
                        | ContactError::SharedPartner { .. },
                    ) => {}
                    result => return result,
                }
            }
            couple_mortar(slave, master, interface, search)
        }
    }
}
