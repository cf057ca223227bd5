//! Contact pairs and their rows of B, however they were found.

use faer::sparse::{SparseRowMat, SymbolicSparseRowMat};
use tresca_fem::mesh::Mesh;

use super::contact_pair::ContactPair;
use super::mobility::{Mobility, restrained_frame};
use crate::error::ContactError;
use crate::frame::Frame;
use crate::interface::Interface;
use crate::scalar_field::ScalarField;

/// Where a pair stands.
pub(crate) struct Location {
    pub slave_node: usize,
    pub patch: usize,
    pub master_node: Option<usize>,
    pub point: [f64; 3],
    /// Unit normal out of the slave.
    pub normal: [f64; 3],
    pub area: f64,
}

/// The pair at a place that can move along the `free` axes. `gap` is the distance of the surfaces for a
/// normal ν, to which the interface adds its own.
pub(crate) fn pair(
    at: Location,
    free: [bool; 3],
    interface: Interface<'_>,
    value: impl Fn(&ScalarField) -> Result<f64, ContactError>,
    gap: impl Fn([f64; 3]) -> f64,
) -> Result<ContactPair, ContactError> {
    let law = interface.friction;
    let sliding = law.sliding(at.area, at.point, &value)?;
    let natural = |normal| match law.axis() {
        None => Ok(Frame::from_normal(normal)),
        Some(axis) => Frame::with_axis(normal, axis).ok_or(ContactError::Axis {
            axis,
            point: Some(at.point),
        }),
    };
    let (frame, mobility, sliding) = match restrained_frame(at.normal, free) {
        None => (natural(at.normal)?, Mobility::FULL, sliding),
        Some((frame, mobility)) if mobility.tangents == [true; 2] => {
            (natural(frame.normal)?, mobility, sliding)
        }
        Some((frame, mobility)) => {
            let own = natural(frame.normal)?;
            let sliding = sliding.along(&own, frame.tangents[0]);
            (frame, mobility, sliding)
        }
    };
    let gap = gap(frame.normal) + value(interface.gap)?;
    if !gap.is_finite() {
        return Err(ContactError::Gap {
            gap,
            point: at.point,
        });
    }
    Ok(ContactPair {
        slave_node: at.slave_node,
        patch: at.patch,
        master_node: at.master_node,
        point: at.point,
        frame,
        mobility,
        gap,
        area: at.area,
        sliding,
    })
}

/// B of one side: row i is Σ_k sign·c_k ν_i at the nodes k of pair i, rows m + (d−1)i … the tangents.
/// `nodes` gives the c_k of a pair by ascending node.
pub(crate) fn coupling<'a>(
    pairs: &[ContactPair],
    mesh: &Mesh,
    sign: f64,
    nodes: impl Fn(usize) -> &'a [(usize, f64)],
) -> SparseRowMat<usize, f64> {
    let dimension = mesh.dimension();
    let frames = || pairs.iter().map(|pair| &pair.frame).enumerate();
    let normals = frames().map(|(i, frame)| (i, frame.normal));
    let tangents = frames().flat_map(|(i, frame)| {
        let tangents = frame.tangents.into_iter().take(dimension - 1);
        tangents.map(move |tangent| (i, tangent))
    });

    let mut row_ptr = vec![0];
    let mut columns = Vec::new();
    let mut values = Vec::new();
    for (pair, direction) in normals.chain(tangents) {
        for &(node, coefficient) in nodes(pair) {
            for (component, value) in direction.into_iter().take(dimension).enumerate() {
                if value != 0.0 {
                    columns.push(dimension * node + component);
                    values.push(sign * (coefficient * value));
                }
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
