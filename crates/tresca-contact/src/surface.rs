//! The part of a body's boundary that may come into contact.

use std::collections::BTreeSet;

use tresca_fem::loads;
use tresca_fem::mesh::{Face, Mesh};

use crate::ContactError;
use crate::frame::dot;

/// A node of a contact surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceNode {
    /// Node number in the body's mesh.
    pub node: usize,
    /// Position.
    pub point: [f64; 3],
    /// Unit outward normal: the average of the faces around the node, weighted by ∫ φ_i.
    pub normal: [f64; 3],
    /// The area that belongs to the node, ∫ φ_i over the surface.
    pub area: f64,
}

/// The nodes of a contact surface, by ascending node number, with normals and areas.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactSurface {
    /// The nodes, ascending.
    pub nodes: Vec<SurfaceNode>,
}

impl ContactSurface {
    /// Collects the nodes of a set of faces.
    ///
    /// # Errors
    /// [`ContactError::Empty`] without faces, [`ContactError::NoNormal`] where the faces around a
    /// node fold back on themselves.
    pub fn new(mesh: &Mesh, faces: &[Face]) -> Result<Self, ContactError> {
        if faces.is_empty() {
            return Err(ContactError::Empty);
        }
        let vectors = loads::nodal_area_vectors(mesh, faces);
        let areas = loads::nodal_areas(mesh, faces);
        let nodes: BTreeSet<usize> = faces
            .iter()
            .flat_map(|&face| mesh.face_nodes(face))
            .collect();
        let nodes = nodes
            .into_iter()
            .map(|node| {
                let (vector, area) = (vectors[node], areas[node]);
                let point = mesh.points[node];
                let length = dot(vector, vector).sqrt();
                // A fold leaves rounding, or next to nothing, of the sum of the parts.
                if length.is_nan() || length <= 1e-6 * area {
                    return Err(ContactError::NoNormal { point });
                }
                Ok(SurfaceNode {
                    node,
                    point,
                    normal: vector.map(|x| x / length),
                    area,
                })
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { nodes })
    }
}
