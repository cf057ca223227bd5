//! Smooth patches of a contact surface: where a node has one normal, and where it has several.
//!
//! A pair belongs to a slave node *and* a smooth patch. On a surface of one patch a node has one normal, the
//! mean over all faces around it; on a surface that is cut at its edges a node on an edge has a pair for each of
//! the patches that meet there, with the patch's normal, frame, area and rows.
//!
//! Rows of two pairs of one node see the same dofs of the slave. They are independent as long as the
//! directions in which the node can be pressed are, and the friction forces of the second pair find dofs of
//! the master of their own; a rigid obstacle has none. So the surfaces of a model are one patch each,
//! unless someone says otherwise.

use std::collections::BTreeMap;

use tresca_fem::mesh::{DisjointSets, Face, Mesh};
use tresca_fem::vector3::{dot, unit};

use crate::error::ContactError;
use crate::geometry::faces::FaceShapes;

/// Which smooth patch each face of a surface belongs to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SmoothPatches {
    of_face: Vec<usize>,
    count: usize,
}

impl SmoothPatches {
    /// A surface of `faces` faces that is one patch.
    pub fn one(faces: usize) -> Self {
        Self {
            of_face: vec![0; faces],
            count: faces.min(1),
        }
    }

    /// Number of patches.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Number of faces.
    pub fn face_count(&self) -> usize {
        self.of_face.len()
    }

    /// The patch of a face, by its position in the surface's list of faces.
    pub fn of_face(&self, face: usize) -> usize {
        self.of_face[face]
    }

    /// The faces of a patch among the faces of the surface, in their order.
    pub fn faces(&self, patch: usize, of: &[Face]) -> Vec<Face> {
        let faces = of.iter().zip(&self.of_face);
        let own = faces.filter(|&(_, &number)| number == patch);
        own.map(|(&face, _)| face).collect()
    }
}

/// Cuts a surface at its edges (in the plane: corners) where the normals of the two faces next to it are more
/// than `angle` (radians) apart; patches are numbered by their first faces. Normals are taken in the middle of
/// the edge, on curved faces as they are there.
///
/// Faces that are smoothly connected some other way around stay together: an edge that ends within a
/// surface cuts nothing.
///
/// # Errors
/// [`ContactError::Empty`] without faces, [`ContactError::DegenerateFace`] for one without a normal.
pub fn patches(mesh: &Mesh, faces: &[Face], angle: f64) -> Result<SmoothPatches, ContactError> {
    let shapes = FaceShapes::of_mesh(mesh, faces)?.shapes;
    // The faces at each edge, by its corners, with their normals in the middle of it.
    let mut edges: BTreeMap<Vec<usize>, Vec<(usize, [f64; 3])>> = BTreeMap::new();
    for (index, shape) in shapes.iter().enumerate() {
        let corners = shape.kind.corner_count();
        let places = shape.kind.element().nodes();
        for a in 0..corners {
            let (key, middle) = if shape.kind.dimension() == 1 {
                (vec![shape.nodes()[a]], places[a])
            } else {
                let b = (a + 1) % corners;
                let mut key = vec![shape.nodes()[a], shape.nodes()[b]];
                key.sort_unstable();
                let middle = std::array::from_fn(|k| 0.5 * (places[a][k] + places[b][k]));
                (key, middle)
            };
            let normal = unit(shape.area_vector(middle));
            edges.entry(key).or_default().push((index, normal));
        }
    }
    let least = angle.cos();
    let mut sets = DisjointSets::new(faces.len());
    for around in edges.values() {
        for (k, (first, normal)) in around.iter().enumerate() {
            for (second, other) in &around[k + 1..] {
                if dot(*normal, *other) >= least {
                    sets.join(*first, *second);
                }
            }
        }
    }
    let mut number = vec![usize::MAX; faces.len()];
    let mut count = 0;
    let of_face = (0..faces.len())
        .map(|face| {
            let root = sets.root(face);
            if number[root] == usize::MAX {
                number[root] = count;
                count += 1;
            }
            number[root]
        })
        .collect();
    Ok(SmoothPatches { of_face, count })
}
