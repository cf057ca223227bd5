//! The result of the geometry: coupling matrices, gaps, frames, areas, slip bounds.

use faer::sparse::{SparseRowMat, SymbolicSparseRowMat};
use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{Face, Mesh};

use crate::frame::dot;
use crate::pairing::pair_node_by_node;
use crate::{ContactError, ContactSurface, Frame, FrictionLaw};

/// One side of a contact: a surface of a body.
#[derive(Clone, Copy)]
pub struct Side<'a> {
    /// The body's mesh.
    pub mesh: &'a Mesh,
    /// The faces that may come into contact.
    pub faces: &'a [Face],
    /// The body's dofs; B has one column for each free dof.
    pub dofs: &'a DofMap,
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
    /// Local frame, ν out of the slave body.
    pub frame: Frame,
    /// Initial normal gap d; negative where the surfaces overlap.
    pub gap: f64,
    /// The area that belongs to the pair, ∫ φ_i over the slave surface.
    pub area: f64,
    /// The slip bound g_i ≥ 0 of the pair as a force.
    pub slip_bound: f64,
}

/// What the dual problem needs to know of one contact between two bodies.
#[derive(Debug, Clone)]
pub struct ContactData {
    /// The m pairs.
    pub pairs: Vec<ContactPair>,
    /// Slave part of B = \[N; T\]: 3m × free dofs of the slave body.
    pub slave_coupling: SparseRowMat<usize, f64>,
    /// Master part of B, 3m × free dofs of the master body (its signs included).
    pub master_coupling: SparseRowMat<usize, f64>,
    /// Pairs left out because both nodes are held: no force can act between them.
    pub held_pairs: usize,
}

/// Couples two surfaces whose nodes lie on one another.
///
/// # Errors
/// [`ContactError`] when a slave node has no master node at its place, a surface has no
/// normal somewhere, or the slip bound is not a number ≥ 0.
pub fn couple_node_by_node(
    slave: Side<'_>,
    master: Side<'_>,
    friction: FrictionLaw,
) -> Result<ContactData, ContactError> {
    let slave_surface = ContactSurface::new(slave.mesh, slave.faces)?;
    let master_surface = ContactSurface::new(master.mesh, master.faces)?;
    let partners = pair_node_by_node(&slave_surface, &master_surface)?;

    let mut pairs = Vec::with_capacity(partners.len());
    let mut held_pairs = 0;
    for (node, &partner) in slave_surface.nodes.iter().zip(&partners) {
        let partner = &master_surface.nodes[partner];
        if is_held(slave.dofs, node.node) && is_held(master.dofs, partner.node) {
            held_pairs += 1;
            continue;
        }
        let offset = std::array::from_fn(|k| partner.point[k] - node.point[k]);
        pairs.push(ContactPair {
            slave_node: node.node,
            master_node: partner.node,
            point: node.point,
            frame: Frame::from_normal(node.normal),
            gap: dot(node.normal, offset),
            area: node.area,
            slip_bound: friction.slip_bound(node.area)?,
        });
    }
    let slave_coupling = coupling(&pairs, slave.dofs, |pair| pair.slave_node, 1.0);
    let master_coupling = coupling(&pairs, master.dofs, |pair| pair.master_node, -1.0);
    Ok(ContactData {
        pairs,
        slave_coupling,
        master_coupling,
        held_pairs,
    })
}

fn is_held(dofs: &DofMap, node: usize) -> bool {
    (0..3).all(|component| dofs.free(node, component).is_none())
}

/// B of one side: row i is sign·ν_i at the pair's node, rows m + 2i and m + 2i + 1 the tangents.
fn coupling(
    pairs: &[ContactPair],
    dofs: &DofMap,
    node: impl Fn(&ContactPair) -> usize,
    sign: f64,
) -> SparseRowMat<usize, f64> {
    let normals = pairs.iter().map(|pair| (pair, pair.frame.normal));
    let tangents = pairs
        .iter()
        .flat_map(|pair| pair.frame.tangents.map(|tangent| (pair, tangent)));

    let mut row_ptr = vec![0];
    let mut columns = Vec::new();
    let mut values = Vec::new();
    for (pair, direction) in normals.chain(tangents) {
        for (component, value) in direction.into_iter().enumerate() {
            if value == 0.0 {
                continue;
            }
            if let Some(column) = dofs.free(node(pair), component) {
                columns.push(column);
                values.push(sign * value);
            }
        }
        row_ptr.push(columns.len());
    }
    let symbolic =
        SymbolicSparseRowMat::new_checked(3 * pairs.len(), dofs.free_len(), row_ptr, None, columns);
    SparseRowMat::new(symbolic, values)
}
