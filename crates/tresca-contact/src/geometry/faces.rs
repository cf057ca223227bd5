//! The faces of a surface, divided into facets.

use tresca_fem::mesh::{Face, Mesh, Space};
use tresca_fem::vector3::norm;

use super::face::{FaceElement, FaceShape};
use super::facet::Facet;
use crate::error::ContactError;

/// A surface as a list of faces, each divided into flat facets.
#[derive(Debug, Clone)]
pub(crate) struct FaceShapes {
    /// What areas on the surface are multiplied by.
    pub space: Space,
    /// The faces.
    pub shapes: Vec<FaceShape>,
    /// The facets of all faces, face by face.
    pub facets: Vec<Facet>,
    starts: Vec<usize>,
}

impl FaceShapes {
    /// The faces of a body.
    pub fn of_mesh(mesh: &Mesh, faces: &[Face]) -> Result<Self, ContactError> {
        if faces.is_empty() {
            return Err(ContactError::Empty);
        }
        let shapes = faces.iter().map(|&face| {
            FaceShape::new(mesh.face_kind(face), &mesh.face_nodes(face), &mesh.points)
        });
        Self::new(mesh.space, shapes.collect::<Result<_, _>>()?)
    }

    /// A surface of given faces.
    pub fn new(space: Space, shapes: Vec<FaceShape>) -> Result<Self, ContactError> {
        let mut facets = Vec::with_capacity(shapes.len());
        let mut starts = vec![0];
        for (index, shape) in shapes.iter().enumerate() {
            if shape.kind.dimension() + 1 != space.dimension() {
                return Err(ContactError::FaceKind {
                    kind: shape.kind,
                    nodes: shape.nodes().len(),
                });
            }
            for corners in shape.kind.facets() {
                facets.push(Facet::new(shape, index, corners)?);
            }
            starts.push(facets.len());
        }
        Ok(Self {
            space,
            shapes,
            facets,
            starts,
        })
    }

    /// The facets of a face.
    pub fn facets_of(&self, shape: usize) -> &[Facet] {
        &self.facets[self.starts[shape]..self.starts[shape + 1]]
    }

    /// Diagonal of the box around all nodes.
    pub fn diagonal(&self) -> f64 {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for point in self.shapes.iter().flat_map(FaceShape::points) {
            for k in 0..3 {
                low[k] = low[k].min(point[k]);
                high[k] = high[k].max(point[k]);
            }
        }
        let size: [f64; 3] = std::array::from_fn(|k| high[k] - low[k]);
        norm(size)
    }
}
