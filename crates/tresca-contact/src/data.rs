//! The result of the geometry: coupling matrices, gaps, frames, areas, friction data.

use faer::sparse::{SparseRowMat, SymbolicSparseRowMat};
use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{Face, Mesh};

use crate::frame::dot;
use crate::pairing::pair_node_by_node;
use crate::restrained::restrained_frame;
use crate::surface::SurfaceNode;
use crate::{ContactError, ContactSurface, Field, Frame, FrictionLaw, Mobility, Sliding};

/// One side of a contact: a surface of a body.
#[derive(Clone, Copy)]
pub struct Side<'a> {
    /// The body's mesh.
    pub mesh: &'a Mesh,
    /// The faces that may come into contact.
    pub faces: &'a [Face],
    /// The body's dofs: a pair that supports hold completely is left out.
    pub dofs: &'a DofMap,
}

/// What happens between the two sides.
#[derive(Clone, Copy)]
pub struct Interface<'a> {
    /// What resists sliding and opening.
    pub friction: &'a FrictionLaw,
    /// What is added to the gap between the meshes (a length); negative for an interference.
    pub gap: &'a Field,
}

/// A contact pair: a slave node and what faces it.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPair {
    /// Node of the slave mesh.
    pub slave_node: usize,
    /// Node of the master mesh.
    pub master_node: usize,
    /// Position of the slave node.
    pub point: [f64; 3],
    /// Local frame, ν out of the slave body. In the plane τ1 lies in the plane.
    pub frame: Frame,
    /// The directions of the frame in which the supports let the pair move.
    pub mobility: Mobility,
    /// Initial normal gap d; negative where the surfaces overlap.
    pub gap: f64,
    /// The area that belongs to the pair, ∫ φ_i over the slave surface.
    pub area: f64,
    /// What it may do along its tangents.
    pub sliding: Sliding,
}

/// What the dual problem needs to know of one contact between two bodies.
#[derive(Debug, Clone)]
pub struct ContactData {
    /// The m pairs.
    pub pairs: Vec<ContactPair>,
    /// Slave part of B = \[N; T\]: d m × full dofs of the slave body, d the space dimension.
    pub slave_coupling: SparseRowMat<usize, f64>,
    /// Master part of B, d m × full dofs of the master body (its signs included).
    pub master_coupling: SparseRowMat<usize, f64>,
    /// Pairs left out because both nodes are held: no force can act between them.
    pub held_pairs: usize,
}

/// Couples two surfaces whose nodes lie on one another.
///
/// # Errors
/// [`ContactError`] when a slave node has no master node at its place, a surface has no
/// normal somewhere, or the friction law or the gap gives no possible value.
pub fn couple_node_by_node(
    slave: Side<'_>,
    master: Side<'_>,
    interface: Interface<'_>,
) -> Result<ContactData, ContactError> {
    let slave_surface = ContactSurface::new(slave.mesh, slave.faces)?;
    let master_surface = ContactSurface::new(master.mesh, master.faces)?;
    let partners = pair_node_by_node(&slave_surface, &master_surface)?;

    let count = slave_surface.nodes.len();
    let mut pairs = Vec::with_capacity(count);
    let mut held_pairs = 0;
    for (index, (node, &partner)) in slave_surface.nodes.iter().zip(&partners).enumerate() {
        let partner = &master_surface.nodes[partner];
        let free = std::array::from_fn(|component| {
            component < slave.mesh.dimension()
                && (slave.dofs.free(node.node, component).is_some()
                    || master.dofs.free(partner.node, component).is_some())
        });
        if free == [false; 3] {
            held_pairs += 1;
            continue;
        }
        let value = |field: &Field| field.at(index, count, node.point);
        pairs.push(pair(node, partner, free, interface, value)?);
    }
    let slave_coupling = coupling(&pairs, slave.mesh, |pair| pair.slave_node, 1.0);
    let master_coupling = coupling(&pairs, master.mesh, |pair| pair.master_node, -1.0);
    Ok(ContactData {
        pairs,
        slave_coupling,
        master_coupling,
        held_pairs,
    })
}

/// The pair of two nodes that can move against one another along the `free` axes.
fn pair(
    slave: &SurfaceNode,
    master: &SurfaceNode,
    free: [bool; 3],
    interface: Interface<'_>,
    value: impl Fn(&Field) -> Result<f64, ContactError>,
) -> Result<ContactPair, ContactError> {
    let law = interface.friction;
    let sliding = law.sliding(slave.area, slave.point, &value)?;
    let natural = |normal| match law.axis() {
        None => Ok(Frame::from_normal(normal)),
        Some(axis) => Frame::with_axis(normal, axis).ok_or(ContactError::Axis {
            axis,
            point: Some(slave.point),
        }),
    };
    let (frame, mobility, sliding) = match restrained_frame(slave.normal, free) {
        None => (natural(slave.normal)?, Mobility::FULL, sliding),
        Some((frame, mobility)) if mobility.tangents == [true; 2] => {
            (natural(frame.normal)?, mobility, sliding)
        }
        Some((frame, mobility)) => {
            let own = natural(frame.normal)?;
            let sliding = sliding.along(&own, frame.tangents[0]);
            (frame, mobility, sliding)
        }
    };
    let offset = std::array::from_fn(|k| master.point[k] - slave.point[k]);
    let gap = dot(frame.normal, offset) + value(interface.gap)?;
    if !gap.is_finite() {
        return Err(ContactError::Gap {
            gap,
            point: slave.point,
        });
    }
    Ok(ContactPair {
        slave_node: slave.node,
        master_node: master.node,
        point: slave.point,
        frame,
        mobility,
        gap,
        area: slave.area,
        sliding,
    })
}

/// B of one side: row i is sign·ν_i at the pair's node, rows m + (d−1)i … the tangents.
fn coupling(
    pairs: &[ContactPair],
    mesh: &Mesh,
    node: impl Fn(&ContactPair) -> usize,
    sign: f64,
) -> SparseRowMat<usize, f64> {
    let dimension = mesh.dimension();
    let normals = pairs.iter().map(|pair| (pair, pair.frame.normal));
    let tangents = pairs.iter().flat_map(|pair| {
        let tangents = pair.frame.tangents.into_iter().take(dimension - 1);
        tangents.map(move |tangent| (pair, tangent))
    });

    let mut row_ptr = vec![0];
    let mut columns = Vec::new();
    let mut values = Vec::new();
    for (pair, direction) in normals.chain(tangents) {
        for (component, value) in direction.into_iter().take(dimension).enumerate() {
            if value != 0.0 {
                columns.push(dimension * node(pair) + component);
                values.push(sign * value);
            }
        }
        row_ptr.push(columns.len());
    }
    let symbolic = SymbolicSparseRowMat::new_checked(
        dimension * pairs.len(),
        mesh.dof_count(),
        row_ptr,
        None,
        columns,
    );
    SparseRowMat::new(symbolic, values)
}
