//! The part of a body's boundary that may come into contact.

use std::collections::BTreeMap;

use tresca_fem::loads;
use tresca_fem::mesh::{Face, Mesh};

use crate::ContactError;
use crate::frame::{dot, unit};
use crate::geometry::Patches;

/// A node of a contact surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceNode {
    /// Node number in the body's mesh.
    pub node: usize,
    /// Position.
    pub point: [f64; 3],
    /// Unit outward normal: the average of the faces around the node, weighted by ∫ φ_i. Where one of the
    /// faces is quadratic, the average of the faces' own normals at the node, weighted by their areas.
    pub normal: [f64; 3],
    /// ∫ φ_i over the surface: for linear faces the area that belongs to the node. At corners of
    /// quadratic faces it is zero or negative.
    pub area: f64,
    /// Distance to the nearest node of the same face.
    pub spacing: f64,
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
        let areas = loads::nodal_areas(mesh, faces);
        let (vectors, weights) = if faces.iter().all(|&f| mesh.face_kind(f).order() == 1) {
            (loads::nodal_area_vectors(mesh, faces), areas.clone())
        } else {
            normals_at_nodes(mesh, faces)?
        };
        let spacings = spacings(mesh, faces);
        let nodes = spacings
            .into_iter()
            .map(|(node, spacing)| {
                let (vector, weight) = (vectors[node], weights[node]);
                let point = mesh.points[node];
                let length = dot(vector, vector).sqrt();
                // A fold leaves rounding, or next to nothing, of the sum of the parts.
                if length.is_nan() || length <= 1e-6 * weight {
                    return Err(ContactError::NoNormal { point });
                }
                Ok(SurfaceNode {
                    node,
                    point,
                    normal: vector.map(|x| x / length),
                    area: areas[node],
                    spacing,
                })
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { nodes })
    }
}

/// For each node of the mesh the sum over faces of their unit normal at the node times their area, and of
/// their areas. (∫ φ_i n would vanish at the corners of quadratic faces.)
fn normals_at_nodes(
    mesh: &Mesh,
    faces: &[Face],
) -> Result<(Vec<[f64; 3]>, Vec<f64>), ContactError> {
    let mut vectors = vec![[0.0; 3]; mesh.node_count()];
    let mut weights = vec![0.0; mesh.node_count()];
    let surface = Patches::of_mesh(mesh, faces)?;
    for (index, patch) in surface.patches.iter().enumerate() {
        let area: f64 = surface
            .facets_of(index)
            .iter()
            .map(|facet| facet.area)
            .sum();
        let places = patch.kind.element().nodes();
        for (&node, &xi) in patch.nodes().iter().zip(places) {
            let normal = unit(patch.area_vector(xi));
            for k in 0..3 {
                vectors[node][k] += area * normal[k];
            }
            weights[node] += area;
        }
    }
    Ok((vectors, weights))
}

/// For each node of some faces the distance to the nearest node of the same face.
fn spacings(mesh: &Mesh, faces: &[Face]) -> BTreeMap<usize, f64> {
    let mut spacings = BTreeMap::new();
    for &face in faces {
        let nodes = mesh.face_nodes(face);
        for &node in &nodes {
            let others = nodes.iter().filter(|&&other| other != node);
            let distances = others.map(|&other| {
                let between: [f64; 3] =
                    std::array::from_fn(|k| mesh.points[other][k] - mesh.points[node][k]);
                dot(between, between).sqrt()
            });
            let least = distances.fold(f64::INFINITY, f64::min);
            let entry = spacings.entry(node).or_insert(f64::INFINITY);
            *entry = f64::min(*entry, least);
        }
    }
    spacings
}
