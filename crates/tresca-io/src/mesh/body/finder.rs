//! From surface groups of a file to faces of a body.

use std::cell::OnceCell;

use tresca_fem::mesh::{CellKind, Face, FaceLookup, Mesh};

use super::super::error::{MeshFault, MeshFileError};
use super::super::faces::{FaceMap, side};
use super::super::file::{Group, MeshFile};
use super::members::Members;

/// Finds the faces of a body that a group means.
pub(super) struct Finder<'a> {
    file: &'a MeshFile,
    members: &'a Members,
    mesh: &'a Mesh,
    of_body: FaceLookup,
    /// The faces of all cells, made when it must be known whether another body has a face.
    of_file: OnceCell<FaceMap>,
}

impl<'a> Finder<'a> {
    pub fn new(file: &'a MeshFile, members: &'a Members, mesh: &'a Mesh) -> Self {
        Self {
            file,
            members,
            mesh,
            of_body: FaceLookup::new(mesh),
            of_file: OnceCell::new(),
        }
    }

    pub fn faces(&self, group: &Group) -> Result<Vec<Face>, MeshFileError> {
        let cells = &self.file.cells;
        let mut faces = Vec::new();
        for &element in &group.cells {
            let (kind, nodes) = (cells.kind(element), cells.nodes(element));
            faces.extend(self.face(group, element, (kind, nodes))?);
        }
        for &[cell, local] in &group.faces {
            if self.members.cell(cell).is_some() {
                let (kind, nodes) = side(cells, [cell, local]);
                faces.extend(self.face(group, cell, (kind, &nodes))?);
            }
        }
        faces.sort_unstable();
        faces.dedup();
        Ok(faces)
    }

    /// The face of the body that a surface element is, or the side of a cell; `None` if it belongs
    /// to other bodies or none. `element` is what an error names.
    fn face(
        &self,
        group: &Group,
        element: usize,
        (kind, points): (CellKind, &[usize]),
    ) -> Result<Option<Face>, MeshFileError> {
        let nodes: Option<Vec<usize>> = points.iter().map(|&p| self.members.node(p)).collect();
        let Some(mut nodes) = nodes else {
            return Ok(None);
        };
        let missing = || {
            MeshFault::MissingFace {
                group: group.name.clone(),
                element: self.file.element(element),
            }
            .at(self.file.path.clone())
        };
        match self.of_body.sides(&nodes[..kind.corner_count()]) {
            &[face] => {
                // A linear element on a quadratic cell, or the reverse.
                let mut own = self.mesh.face_nodes(face);
                own.sort_unstable();
                nodes.sort_unstable();
                if own == nodes {
                    Ok(Some(face))
                } else {
                    Err(missing())
                }
            }
            [first, second, ..] => Err(MeshFault::InteriorFace {
                group: group.name.clone(),
                element: self.file.element(element),
                sides: [first, second].map(|face| {
                    let cell = self.members.cells[face.cell];
                    self.file.element(cell)
                }),
            }
            .at(self.file.path.clone())),
            // A body that touches this one along the nodes of the element may have the face.
            [] => {
                let map = || FaceMap::new(&self.file.cells, group.dimension + 1);
                let corners = &points[..kind.corner_count()];
                match self.of_file.get_or_init(map).contains(corners) {
                    true => Ok(None),
                    false => Err(missing()),
                }
            }
        }
    }
}
