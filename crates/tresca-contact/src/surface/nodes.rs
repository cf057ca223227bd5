//! The part of a body's boundary that may come into contact.

use std::collections::BTreeMap;

use tresca_fem::loads;
use tresca_fem::mesh::{Face, Mesh};

use tresca_fem::vector3::{norm, unit};

use super::patches::SmoothPatches;
use crate::error::ContactError;
use crate::geometry::faces::FaceShapes;
use crate::interface::Side;

/// A node of a contact surface, on one of the smooth patches that meet there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceNode {
    /// Node number in the body's mesh.
    pub node: usize,
    /// Which one it is among the nodes of the surface, whatever their patches.
    pub ordinal: usize,
    /// The smooth patch: faces of others have no part in what follows.
    pub patch: usize,
    /// Position.
    pub point: [f64; 3],
    /// Unit outward normal: the average of the faces around the node, weighted by ∫ φ_i. Where one of the
    /// faces is quadratic, the average of the faces' own normals at the node, weighted by their areas.
    pub normal: [f64; 3],
    /// ∫ φ_i over the patch: for linear faces the area that belongs to the node. At corners of
    /// quadratic faces it is zero or negative.
    pub area: f64,
    /// Distance to the nearest node of the same face.
    pub spacing: f64,
}

/// The nodes of a contact surface with normals and areas: by ascending node number, one for each patch.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactSurface {
    /// The nodes, ascending; those of one node of the mesh by patch.
    pub nodes: Vec<SurfaceNode>,
}

impl ContactSurface {
    /// Collects the nodes of a set of faces that is one patch.
    ///
    /// # Errors
    /// [`ContactError::Empty`] without faces, [`ContactError::NoNormal`] where the faces around a
    /// node fold back on themselves.
    pub fn new(mesh: &Mesh, faces: &[Face]) -> Result<Self, ContactError> {
        if faces.is_empty() {
            return Err(ContactError::Empty);
        }
        let mut nodes = nodes_of_patch(mesh, faces, 0)?;
        number(&mut nodes);
        Ok(Self { nodes })
    }

    /// Collects the nodes of a set of faces in smooth patches, each by itself.
    ///
    /// # Errors
    /// As [`ContactSurface::new`]; [`ContactError::PatchFaces`] for the patches of another surface.
    pub fn in_patches(
        mesh: &Mesh,
        faces: &[Face],
        patches: &SmoothPatches,
    ) -> Result<Self, ContactError> {
        if patches.face_count() != faces.len() {
            return Err(ContactError::PatchFaces {
                expected: faces.len(),
                found: patches.face_count(),
            });
        }
        if faces.is_empty() {
            return Err(ContactError::Empty);
        }
        let of_patches = (0..patches.count())
            .map(|patch| nodes_of_patch(mesh, &patches.faces(patch, faces), patch))
            .collect::<Result<Vec<_>, _>>()?;
        let mut nodes = of_patches.concat();
        nodes.sort_by_key(|node| (node.node, node.patch));
        number(&mut nodes);
        Ok(Self { nodes })
    }

    /// The surface of a slave side.
    pub(crate) fn of_side(side: Side<'_>) -> Result<Self, ContactError> {
        match side.patches {
            None => Self::new(side.mesh, side.faces),
            Some(patches) => Self::in_patches(side.mesh, side.faces, patches),
        }
    }

    /// Number of nodes of the mesh.
    pub fn node_count(&self) -> usize {
        self.nodes.last().map_or(0, |node| node.ordinal + 1)
    }
}

/// Counts the nodes of the mesh.
fn number(nodes: &mut [SurfaceNode]) {
    for (ordinal, same) in nodes.chunk_by_mut(|a, b| a.node == b.node).enumerate() {
        same.iter_mut().for_each(|node| node.ordinal = ordinal);
    }
}

/// The nodes of the faces of a patch, ascending, not yet numbered.
fn nodes_of_patch(
    mesh: &Mesh,
    faces: &[Face],
    patch: usize,
) -> Result<Vec<SurfaceNode>, ContactError> {
    let areas = loads::nodal_areas(mesh, faces);
    let (vectors, weights) = if faces.iter().all(|&f| mesh.face_kind(f).order() == 1) {
        (loads::nodal_area_vectors(mesh, faces), areas.clone())
    } else {
        normals_at_nodes(mesh, faces)?
    };
    let node = |(node, spacing)| {
        let (vector, weight): ([f64; 3], f64) = (vectors[node], weights[node]);
        let point = mesh.points[node];
        let length = norm(vector);
        // A fold leaves rounding, or next to nothing, of the sum of the parts.
        if length.is_nan() || length <= 1e-6 * weight {
            return Err(ContactError::NoNormal { point });
        }
        Ok(SurfaceNode {
            node,
            ordinal: 0,
            patch,
            point,
            normal: vector.map(|x| x / length),
            area: areas[node],
            spacing,
        })
    };
    spacings(mesh, faces).into_iter().map(node).collect()
}

/// For each node of the mesh the sum over faces of their unit normal at the node times their area, and of
/// their areas. (∫ φ_i n would vanish at the corners of quadratic faces.)
fn normals_at_nodes(
    mesh: &Mesh,
    faces: &[Face],
) -> Result<(Vec<[f64; 3]>, Vec<f64>), ContactError> {
    let mut vectors = vec![[0.0; 3]; mesh.node_count()];
    let mut weights = vec![0.0; mesh.node_count()];
    let surface = FaceShapes::of_mesh(mesh, faces)?;
    for (index, shape) in surface.shapes.iter().enumerate() {
        let area: f64 = surface
            .facets_of(index)
            .iter()
            .map(|facet| facet.area)
            .sum();
        let places = shape.kind.element().nodes();
        for (&node, &xi) in shape.nodes().iter().zip(places) {
            let normal = unit(shape.area_vector(xi));
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
                norm(between)
            });
            let least = distances.fold(f64::INFINITY, f64::min);
            let entry = spacings.entry(node).or_insert(f64::INFINITY);
            *entry = f64::min(*entry, least);
        }
    }
    spacings
}
