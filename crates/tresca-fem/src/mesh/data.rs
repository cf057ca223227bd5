//! What a mesh consists of.

use super::kind::CellKind;
use super::space::Space;
use crate::error::FemError;
use std::collections::BTreeMap;

/// Cells of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct CellBlock {
    /// The kind of every cell in the block.
    pub kind: CellKind,
    /// Node numbers, `kind.node_count()` per cell, cell after cell.
    pub connectivity: Vec<usize>,
}

impl CellBlock {
    /// Number of cells.
    pub fn len(&self) -> usize {
        self.connectivity.len() / self.kind.node_count()
    }

    /// No cells at all?
    pub fn is_empty(&self) -> bool {
        self.connectivity.is_empty()
    }

    /// Node numbers of the cells, one slice per cell.
    pub fn cells(&self) -> std::slice::ChunksExact<'_, usize> {
        self.connectivity.chunks_exact(self.kind.node_count())
    }
}

/// A face of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Face {
    /// Global cell number: cells are counted through all blocks.
    pub cell: usize,
    /// Number of the face in the cell, in the order of [`crate::element::Element::faces`].
    pub local: usize,
}

/// One cell, as seen through [`Mesh::cell`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell<'a> {
    /// Its kind.
    pub kind: CellKind,
    /// Its node numbers.
    pub nodes: &'a [usize],
}

/// The mesh of one body.
///
/// The fields are public data; [`Mesh::new`] checks what the rest of the crate relies on,
/// and [`Mesh::validate`] checks it again after a change by hand. Functions that take a mesh
/// may panic when it would not pass.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// What kind of body the mesh describes, and with it the meaning of its measures.
    pub space: Space,
    /// Coordinates of the nodes; the third is zero in the plane. In an axisymmetric space the first
    /// is the radius, the second runs along the axis.
    pub points: Vec<[f64; 3]>,
    /// Cells that fill the body. A cell's global number counts through the blocks.
    pub cells: Vec<CellBlock>,
    /// Named parts of the surface.
    pub face_sets: BTreeMap<String, Vec<Face>>,
    /// Named sets of nodes.
    pub node_sets: BTreeMap<String, Vec<usize>>,
}

impl Mesh {
    /// A checked mesh without node sets: see [`Mesh::validate`].
    pub fn new(
        space: Space,
        points: Vec<[f64; 3]>,
        cells: Vec<CellBlock>,
        face_sets: BTreeMap<String, Vec<Face>>,
    ) -> Result<Self, FemError> {
        let mesh = Self {
            space,
            points,
            cells,
            face_sets,
            node_sets: BTreeMap::new(),
        };
        mesh.validate()?;
        Ok(mesh)
    }

    /// Checks that coordinates are finite, in the plane where there is one, and radii not negative;
    /// that cells have the dimension of the space; that cells, face sets and node sets refer to nodes
    /// and faces that exist; and that every node belongs to a cell. The shape of cells is judged by
    /// [`Mesh::check_cells`].
    pub fn validate(&self) -> Result<(), FemError> {
        for (node, &point) in self.points.iter().enumerate() {
            if !point.iter().all(|x| x.is_finite()) {
                return Err(FemError::PointNotFinite { node, point });
            }
            if self.dimension() == 2 && point[2] != 0.0 {
                return Err(FemError::PointOffPlane { node, z: point[2] });
            }
            if self.space == Space::Axisymmetric && point[0] < 0.0 {
                return Err(FemError::NegativeRadius {
                    node,
                    radius: point[0],
                });
            }
        }
        self.validate_cells()?;
        for (set, faces) in &self.face_sets {
            for &Face { cell, local } in faces {
                if cell >= self.cell_count() || local >= self.cell(cell).kind.faces().len() {
                    return Err(FemError::FaceOutOfRange {
                        set: set.clone(),
                        cell,
                        local,
                    });
                }
            }
        }
        for (set, nodes) in &self.node_sets {
            if let Some(&node) = nodes.iter().find(|&&node| node >= self.node_count()) {
                return Err(FemError::NodeOfSetOutOfRange {
                    set: set.clone(),
                    node,
                    count: self.node_count(),
                });
            }
        }
        Ok(())
    }

    fn validate_cells(&self) -> Result<(), FemError> {
        let mut used = vec![false; self.points.len()];
        let mut first_cell = 0;
        for (block, cells) in self.cells.iter().enumerate() {
            let (kind, nodes, found) = (
                cells.kind,
                cells.kind.node_count(),
                cells.connectivity.len(),
            );
            if kind.dimension() != self.dimension() {
                return Err(FemError::CellDimension {
                    block,
                    kind,
                    space: self.space,
                });
            }
            if found % nodes != 0 {
                return Err(FemError::RaggedConnectivity {
                    block,
                    kind,
                    nodes,
                    found,
                });
            }
            for (i, &node) in cells.connectivity.iter().enumerate() {
                match used.get_mut(node) {
                    Some(used) => *used = true,
                    None => {
                        let cell = first_cell + i / nodes;
                        return Err(FemError::NodeOutOfRange {
                            cell,
                            node,
                            count: self.points.len(),
                        });
                    }
                }
            }
            first_cell += cells.len();
        }
        match used.iter().position(|used| !used) {
            Some(node) => Err(FemError::UnusedNode { node }),
            None => Ok(()),
        }
    }

    /// Moves every point of the mesh, keeping cells and sets: curved and graded meshes are made
    /// of structured ones this way. See [`Mesh::check_cells`] for whether the map turned cells over.
    ///
    /// # Errors
    /// [`FemError::PointNotFinite`], [`FemError::PointOffPlane`], [`FemError::NegativeRadius`].
    pub fn mapped(mut self, mut map: impl FnMut([f64; 3]) -> [f64; 3]) -> Result<Self, FemError> {
        for point in &mut self.points {
            *point = map(*point);
        }
        self.validate()?;
        Ok(self)
    }

    /// Dimension of the space, 2 or 3: the number of displacement components.
    pub fn dimension(&self) -> usize {
        self.space.dimension()
    }

    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.points.len()
    }

    /// Number of full dofs, `dimension * node_count`.
    pub fn dof_count(&self) -> usize {
        self.dimension() * self.points.len()
    }

    /// Number of cells in all blocks.
    pub fn cell_count(&self) -> usize {
        self.cells.iter().map(CellBlock::len).sum()
    }

    /// A cell by its global number.
    ///
    /// # Panics
    /// When there is no such cell.
    pub fn cell(&self, cell: usize) -> Cell<'_> {
        let mut local = cell;
        for block in &self.cells {
            if local < block.len() {
                let n = block.kind.node_count();
                return Cell {
                    kind: block.kind,
                    nodes: &block.connectivity[local * n..(local + 1) * n],
                };
            }
            local -= block.len();
        }
        panic!("cell {cell} of {}", self.cell_count());
    }

    /// All cells in the order of their global numbers.
    pub fn iter_cells(&self) -> impl Iterator<Item = Cell<'_>> {
        self.cells.iter().flat_map(|block| {
            block.cells().map(|nodes| Cell {
                kind: block.kind,
                nodes,
            })
        })
    }

    /// The faces of a set.
    pub fn faces_of_set(&self, name: &str) -> Result<&[Face], FemError> {
        self.face_sets
            .get(name)
            .map(Vec::as_slice)
            .ok_or_else(|| FemError::UnknownFaceSet {
                name: name.to_owned(),
                known: self.face_sets.keys().cloned().collect(),
            })
    }

    /// The element kind of a face.
    pub fn face_kind(&self, face: Face) -> CellKind {
        self.cell(face.cell).kind.faces()[face.local].kind
    }

    /// The nodes of a face in the order of its face element: seen from outside, counter-clockwise.
    pub fn face_nodes(&self, face: Face) -> Vec<usize> {
        let cell = self.cell(face.cell);
        cell.kind.faces()[face.local]
            .nodes
            .iter()
            .map(|&a| cell.nodes[a])
            .collect()
    }

    /// The nodes of some faces, ascending, each once.
    pub fn nodes_of_faces(&self, faces: &[Face]) -> Vec<usize> {
        let mut nodes: Vec<usize> = faces
            .iter()
            .flat_map(|&face| self.face_nodes(face))
            .collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }

    /// The nodes of a face set, ascending, each once.
    pub fn nodes_of_set(&self, name: &str) -> Result<Vec<usize>, FemError> {
        Ok(self.nodes_of_faces(self.faces_of_set(name)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::brick::{BrickSpec, brick};
    use crate::mesh::rectangle::{RectangleSpec, rectangle};

    fn two_cells() -> Mesh {
        brick(&BrickSpec {
            min: [0.0; 3],
            max: [2.0, 1.0, 1.0],
            nodes: [3, 2, 2],
        })
        .unwrap()
    }

    #[test]
    fn a_mesh_that_refers_to_nothing_is_named() {
        let mut mesh = two_cells();
        mesh.cells[0].connectivity[9] = 12;
        assert_eq!(
            mesh.validate(),
            Err(FemError::NodeOutOfRange {
                cell: 1,
                node: 12,
                count: 12
            })
        );

        let mut mesh = two_cells();
        mesh.cells[0].connectivity.pop();
        assert!(matches!(
            mesh.validate(),
            Err(FemError::RaggedConnectivity { found: 15, .. })
        ));

        let mut mesh = two_cells();
        mesh.points.push([0.0; 3]);
        assert_eq!(mesh.validate(), Err(FemError::UnusedNode { node: 12 }));

        let mut mesh = two_cells();
        mesh.points[3][1] = f64::NAN;
        assert!(matches!(
            mesh.validate(),
            Err(FemError::PointNotFinite { node: 3, .. })
        ));

        let mut mesh = two_cells();
        mesh.face_sets
            .insert("loose".into(), vec![Face { cell: 1, local: 6 }]);
        assert_eq!(
            mesh.validate(),
            Err(FemError::FaceOutOfRange {
                set: "loose".into(),
                cell: 1,
                local: 6
            })
        );

        let mut mesh = two_cells();
        mesh.node_sets.insert("tip".into(), vec![3, 12]);
        assert_eq!(
            mesh.validate(),
            Err(FemError::NodeOfSetOutOfRange {
                set: "tip".into(),
                node: 12,
                count: 12
            })
        );

        let mut mesh = two_cells();
        mesh.space = Space::Plane;
        mesh.points.iter_mut().for_each(|p| p[2] = 0.0);
        assert!(matches!(
            mesh.validate(),
            Err(FemError::CellDimension { block: 0, .. })
        ));
        mesh.points[7][2] = 0.5;
        assert_eq!(
            mesh.validate(),
            Err(FemError::PointOffPlane { node: 7, z: 0.5 })
        );
    }

    #[test]
    fn an_unknown_face_set_lists_the_known_ones() {
        let error = two_cells().nodes_of_set("top").unwrap_err();
        assert_eq!(
            error.to_string(),
            "there is no face set \"top\"; the mesh has: x+, x-, y+, y-, z+, z-"
        );
    }

    #[test]
    fn a_map_moves_points_and_is_checked() {
        let square = || {
            rectangle(&RectangleSpec {
                space: Space::Axisymmetric,
                min: [1.0, 0.0],
                max: [2.0, 1.0],
                nodes: [3, 3],
                cells: CellKind::Quad4,
            })
            .unwrap()
        };
        let moved = square().mapped(|[x, y, _]| [x * x, 2.0 * y, 0.0]).unwrap();
        assert_eq!(moved.points[8], [4.0, 2.0, 0.0]);
        moved.check_cells().unwrap();
        assert_eq!(
            square().mapped(|[x, y, _]| [1.5 - x, y, 0.0]),
            Err(FemError::NegativeRadius {
                node: 2,
                radius: -0.5
            })
        );
        let off = square().mapped(|[x, y, _]| [x, y, 1.0]);
        assert!(matches!(off, Err(FemError::PointOffPlane { node: 0, .. })));
        let infinite = square().mapped(|[x, y, _]| [1.0 / (x - 1.0), y, 0.0]);
        assert!(matches!(
            infinite,
            Err(FemError::PointNotFinite { node: 0, .. })
        ));
        // A mirrored mesh is valid data, but its cells are turned over.
        let mirrored = square().mapped(|[x, y, _]| [3.0 - x, y, 0.0]).unwrap();
        assert!(matches!(
            mirrored.check_cells(),
            Err(FemError::InvertedCell { cell: 0, .. })
        ));
    }

    #[test]
    fn cells_are_counted_through_blocks() {
        let mut mesh = two_cells();
        let second = mesh.cells[0].connectivity.split_off(8);
        mesh.cells.push(CellBlock {
            kind: CellKind::Hex8,
            connectivity: second.clone(),
        });
        mesh.validate().unwrap();
        assert_eq!(mesh.cell_count(), 2);
        assert_eq!(mesh.cell(1).nodes, &second[..]);
        assert_eq!(mesh.iter_cells().count(), 2);
    }
}
