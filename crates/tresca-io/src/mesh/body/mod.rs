//! From a file to the mesh of a body.

mod finder;
mod members;
pub(crate) mod note;

use std::collections::BTreeMap;

use tresca_fem::FemError;
use tresca_fem::mesh::{Mesh, Space};

use super::error::{MeshFault, MeshFileError};
use super::faces::side;
use super::file::MeshFile;
use super::placement::Placement;
use finder::Finder;
use members::Members;
use note::MeshNote;

/// Nodes nearer than this part of a body's size count as one place.
const SAME_PLACE: f64 = 1e-9;

/// The mesh of a body with what was noticed on the way.
#[derive(Debug)]
#[non_exhaustive]
pub struct BodyMesh {
    /// Nodes are numbered without gaps, in the order of the file; cells block by block, in each in
    /// the order of the file. Surface groups that have faces on this body are face sets; point,
    /// curve and surface groups that have nodes of it are node sets. Where groups of different
    /// dimensions share a name, the node sets of the lower ones are called by dimension and name,
    /// as in `0:rim`.
    pub mesh: Mesh,
    /// What may be a mistake, or was put right.
    pub notes: Vec<MeshNote>,
    /// Surface groups of this body that cannot be face sets, with the reason.
    pub unusable: BTreeMap<String, MeshFileError>,
    /// The cell of the file that each cell of the mesh is.
    pub cells: Vec<usize>,
    /// The point of the file that each node of the mesh is.
    pub nodes: Vec<usize>,
}

impl MeshFile {
    /// The mesh of a body: the cells of the volume group `part` (in the plane: of the surface
    /// group), all cells of the dimension of the space without one.
    ///
    /// # Errors
    /// Whatever keeps the cells from being a body: [`MeshFault::NoCells`],
    /// [`MeshFault::NotPlane`], [`MeshFault::UnknownGroup`],
    /// [`MeshFault::GroupDimension`], [`MeshFault::OffPlane`],
    /// [`MeshFault::NegativeRadius`], [`MeshFault::Inverted`],
    /// [`MeshFault::Folded`], [`MeshFault::Degenerate`], [`MeshFault::Refused`]. What is wrong with a surface group
    /// is kept in [`BodyMesh::unusable`], for whoever wants to use it.
    pub fn body(
        &self,
        space: Space,
        part: Option<&str>,
        placement: &Placement,
    ) -> Result<BodyMesh, MeshFileError> {
        let mut members = Members::new(self, self.cells_of(space, part)?);
        let mut notes = Vec::new();
        let points = self.points_of(space, &members.nodes, placement)?;
        let blocks = members.blocks(self, space, &points, &mut notes);
        let mut mesh = Mesh::new(space, points, blocks, BTreeMap::new()).map_err(|source| {
            let path = self.path.clone();
            MeshFault::Refused { source }.at(path)
        })?;
        self.check_shapes(&mesh, &members)?;
        let mut unusable = BTreeMap::new();
        self.face_sets(&mut mesh, &members, &mut unusable);
        self.node_sets(&mut mesh, &members);
        notes.extend(self.duplicate_nodes(&mesh, &members));
        Ok(BodyMesh {
            mesh,
            notes,
            unusable,
            cells: members.cells,
            nodes: members.nodes,
        })
    }

    fn cells_of(&self, space: Space, part: Option<&str>) -> Result<Vec<usize>, MeshFileError> {
        let dimension = space.dimension();
        let count = |dimension| self.cells.of_dimension(dimension).count();
        if dimension == 2 && count(3) > 0 {
            return Err(MeshFault::NotPlane { space }.at(self.path.clone()));
        }
        let all: Vec<usize> = self.cells.of_dimension(dimension).collect();
        if all.is_empty() {
            return Err(MeshFault::NoCells {
                dimension,
                found: [count(1), count(2), count(3)],
            }
            .at(self.path.clone()));
        }
        match part {
            Some(name) => Ok(self.group(name, dimension)?.cells.clone()),
            None => Ok(all),
        }
    }

    /// Placed points, with rounding removed where a coordinate has a meaning.
    fn points_of(
        &self,
        space: Space,
        nodes: &[usize],
        placement: &Placement,
    ) -> Result<Vec<[f64; 3]>, MeshFileError> {
        let mut points: Vec<[f64; 3]> = nodes
            .iter()
            .map(|&node| placement.apply(self.points[node]))
            .collect();
        if space.dimension() == 3 {
            return Ok(points);
        }
        let small = self.flatten(&mut points, nodes)?;
        if space != Space::Axisymmetric {
            return Ok(points);
        }
        for (point, &node) in points.iter_mut().zip(nodes) {
            if point[0] < -small {
                return Err(MeshFault::NegativeRadius {
                    node: self.point_numbers[node],
                    radius: point[0],
                }
                .at(self.path.clone()));
            }
            if point[0].abs() <= small {
                point[0] = 0.0;
            }
        }
        Ok(points)
    }

    fn check_shapes(&self, mesh: &Mesh, members: &Members) -> Result<(), MeshFileError> {
        let Err(source) = mesh.check_cells() else {
            return Ok(());
        };
        let path = self.path.clone();
        let names = |cell: usize| {
            let cell = members.cells[cell];
            (self.element(cell), self.centre(cell))
        };
        Err(match source {
            FemError::InvertedCell { cell, .. } => {
                let (element, centre) = names(cell);
                MeshFault::Inverted { element, centre }.at(path)
            }
            FemError::FoldedCell { cell, .. } => {
                let (element, centre) = names(cell);
                MeshFault::Folded { element, centre }.at(path)
            }
            FemError::DegenerateCell { cell, .. } => {
                let (element, centre) = names(cell);
                MeshFault::Degenerate { element, centre }.at(path)
            }
            source => MeshFault::Refused { source }.at(path),
        })
    }

    fn duplicate_nodes(&self, mesh: &Mesh, members: &Members) -> Option<MeshNote> {
        let pairs = mesh.duplicate_nodes(SAME_PLACE);
        let &[first, second] = pairs.first()?;
        Some(MeshNote::DuplicateNodes {
            pairs: pairs.len(),
            first: [first, second].map(|node| self.point_numbers[members.nodes[node]]),
            at: mesh.points[first],
        })
    }

    fn face_sets(
        &self,
        mesh: &mut Mesh,
        members: &Members,
        unusable: &mut BTreeMap<String, MeshFileError>,
    ) {
        let dimension = mesh.dimension();
        let mut face_sets = BTreeMap::new();
        let finder = Finder::new(self, members, mesh);
        for group in self.groups.iter().filter(|g| g.dimension + 1 == dimension) {
            match finder.faces(group) {
                Ok(faces) if faces.is_empty() => {}
                Ok(faces) => {
                    face_sets.insert(group.name.clone(), faces);
                }
                Err(error) => {
                    unusable.insert(group.name.clone(), error);
                }
            }
        }
        mesh.face_sets = face_sets;
    }

    fn node_sets(&self, mesh: &mut Mesh, members: &Members) {
        let dimension = mesh.dimension();
        // The groups come with the highest dimension first.
        for group in self.groups.iter().filter(|g| g.dimension < dimension) {
            let of_cells = group.cells.iter().flat_map(|&cell| self.cells.nodes(cell));
            let of_sides = group.faces.iter().flat_map(|&of| side(&self.cells, of).1);
            let mut nodes: Vec<usize> = of_cells
                .chain(&group.nodes)
                .copied()
                .chain(of_sides)
                .filter_map(|point| members.node(point))
                .collect();
            nodes.sort_unstable();
            nodes.dedup();
            if nodes.is_empty() {
                continue;
            }
            let name = match mesh.node_sets.contains_key(&group.name) {
                true => format!("{}:{}", group.dimension, group.name),
                false => group.name.clone(),
            };
            mesh.node_sets.insert(name, nodes);
        }
    }
}
