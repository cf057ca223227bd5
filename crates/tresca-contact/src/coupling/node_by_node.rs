//! Coupling of surfaces whose nodes lie on one another.

use std::collections::BTreeSet;

use tresca_fem::vector3::dot;

use super::matching::match_nodes;
use crate::data::{ContactData, Discretization, SharedNode};
use crate::error::ContactError;
use crate::interface::{Interface, Side};
use crate::pair::rows::{Location, coupling, pair};
use crate::scalar_field::ScalarField;
use crate::surface::nodes::ContactSurface;

/// Couples two surfaces whose nodes lie on one another: a pair for each two nodes, with B = ±1 in its
/// frame.
///
/// Nodes that are [taken](Side::taken) on both sides get no second pair.
///
/// For linear faces only: on quadratic ones the areas ∫ φ_i of corner nodes are zero or negative.
///
/// # Errors
/// [`ContactError`] when a slave node has no master node at its place, a face is quadratic, a surface has
/// no normal somewhere, or the friction law or the gap gives no possible value.
pub fn couple_node_by_node(
    slave: Side<'_>,
    master: Side<'_>,
    interface: Interface<'_>,
) -> Result<ContactData, ContactError> {
    for &face in slave.faces {
        let kind = slave.mesh.face_kind(face);
        if kind.order() > 1 {
            return Err(ContactError::QuadraticFaces { kind });
        }
    }
    let slave_surface = ContactSurface::of_side(slave)?;
    let master_surface = ContactSurface::new(master.mesh, master.faces)?;
    let partners = match_nodes(&slave_surface, &master_surface)?;

    let count = slave_surface.node_count();
    let mut pairs = Vec::with_capacity(count);
    let mut nodes = [Vec::with_capacity(count), Vec::with_capacity(count)];
    let (mut held_pairs, mut shared) = (0, Vec::new());
    let taken = [slave, master].map(|side| side.taken.iter().copied().collect::<BTreeSet<_>>());
    for node in &slave_surface.nodes {
        let partner = &master_surface.nodes[partners[node.ordinal]];
        // Another contact of these two bodies couples these two nodes already: its rows span all of ours.
        if taken[0].contains(&node.node) && taken[1].contains(&partner.node) {
            shared.push(SharedNode {
                node: node.node,
                area: node.area,
                normal: node.normal,
            });
            continue;
        }
        let free = std::array::from_fn(|component| {
            component < slave.mesh.dimension()
                && (slave.dofs.moves(node.node, component)
                    || master.dofs.moves(partner.node, component))
        });
        if free == [false; 3] {
            held_pairs += 1;
            continue;
        }
        let value = |field: &ScalarField| field.at(node.ordinal, count, node.point);
        let offset = std::array::from_fn(|k| partner.point[k] - node.point[k]);
        let location = Location {
            slave_node: node.node,
            patch: node.patch,
            master_node: Some(partner.node),
            point: node.point,
            normal: node.normal,
            area: node.area,
        };
        let gap = |normal| dot(normal, offset);
        pairs.push(pair(location, free, interface, value, gap)?);
        nodes[0].push([(node.node, 1.0)]);
        nodes[1].push([(partner.node, 1.0)]);
    }
    let slave_coupling = coupling(&pairs, slave.mesh, 1.0, |i| nodes[0][i].as_slice());
    let master_coupling = coupling(&pairs, master.mesh, -1.0, |i| nodes[1][i].as_slice());
    Ok(ContactData {
        overlap_area: slave_surface.nodes.iter().map(|node| node.area).sum(),
        pairs,
        slave_coupling,
        master_coupling: Some(master_coupling),
        discretization: Discretization::NodeByNode,
        uncoupled: Vec::new(),
        shared,
        held_pairs,
    })
}
