//! The same body in cells of another kind.

use super::data::Mesh;
use super::kind::CellKind;
use crate::error::FemError;

impl Mesh {
    /// The same body in cells of another kind, so that a structured mesh serves every element:
    ///
    /// - hexahedra and wedges are cut into tetrahedra (six of a hexahedron, three of a wedge),
    ///   hexahedra into two wedges, quadrilaterals into two triangles;
    /// - linear cells become quadratic ones by nodes amid the corners. Edges and faces stay straight:
    ///   curve them afterwards by [`Mesh::mapped`].
    ///
    /// Nodes keep their numbers, new ones come after them; the cells that a cell was cut into stand in
    /// its place. Face sets keep their surfaces; a new node belongs to a node set when all the corners
    /// that it lies amid do, so that a held line stays a held line.
    ///
    /// # Errors
    /// [`FemError::CellConversion`] where there is no way from a kind to the other (quadratic cells are
    /// not converted); [`FemError::CutsDoNotMatch`] for wedges out of hexahedra that are not stacked
    /// along their ζ directions.
    pub fn with_cells(mut self, kind: CellKind) -> Result<Mesh, FemError> {
        for block in &self.cells {
            let from = block.kind;
            let cut = matches!(
                (from, kind.linear()),
                (CellKind::Hex8 | CellKind::Wedge6, CellKind::Tet4)
                    | (CellKind::Hex8, CellKind::Wedge6)
                    | (CellKind::Quad4, CellKind::Tri3)
            );
            if from != kind && !cut && from != kind.linear() {
                return Err(FemError::CellConversion { from, to: kind });
            }
        }
        if self
            .cells
            .iter()
            .any(|block| block.kind.linear() != kind.linear())
        {
            self = self.cut(kind.linear())?;
        }
        if self.cells.iter().any(|block| block.kind != kind) {
            self.elevate(kind);
        }
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::brick::{BrickSpec, brick};
    use crate::mesh::data::Face;
    use crate::mesh::rectangle::{RectangleSpec, rectangle};
    use crate::mesh::space::Space;

    fn block() -> Mesh {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [2.0, 1.0, 3.0],
            nodes: [4, 3, 4],
        };
        let mut mesh = brick(&spec).unwrap();
        mesh.node_sets.insert("edge".into(), vec![0, 1, 2, 3]);
        mesh
    }

    fn plate() -> Mesh {
        let mut mesh = rectangle(&RectangleSpec {
            space: Space::Plane,
            min: [0.0, 0.0],
            max: [2.0, 1.0],
            nodes: [4, 3],
            cells: CellKind::Quad4,
        })
        .unwrap();
        mesh.node_sets.insert("edge".into(), vec![0, 1, 2, 3]);
        mesh
    }

    /// Volume, surface and sets are what they were, and the surface is closed.
    fn check(before: &Mesh, kind: CellKind) -> Mesh {
        let mesh = before.clone().with_cells(kind).unwrap();
        mesh.validate().unwrap();
        mesh.check_cells().unwrap();
        assert!(mesh.cells.iter().all(|block| block.kind == kind));
        assert!((mesh.volume() - before.volume()).abs() < 1e-13);
        assert_eq!(mesh.points[..before.node_count()], before.points);
        assert!(mesh.duplicate_nodes(1e-9).is_empty());
        let mut of_sets = Vec::new();
        for (name, faces) in &mesh.face_sets {
            let (old, new) = (&before.face_sets[name], mesh.area_vector(faces));
            let area = before.area_vector(old);
            assert!(
                (0..3).all(|i| (new[i] - area[i]).abs() < 1e-13),
                "{kind}: {name}"
            );
            of_sets.extend_from_slice(faces);
        }
        of_sets.sort_unstable();
        assert_eq!(mesh.boundary_faces(), of_sets, "{kind}: cells do not match");
        mesh
    }

    #[test]
    fn a_brick_in_every_kind() {
        // 3 × 2 × 3 cells, 48 corners, 3·3·4 + 4·2·4 + 4·3·3 = 104 edges, 75 faces.
        for (kind, cells, nodes) in [
            (CellKind::Hex8, 18, 48),
            (CellKind::Hex20, 18, 48 + 104),
            (CellKind::Hex27, 18, 7 * 5 * 7),
            (CellKind::Wedge6, 36, 48),
            (CellKind::Tet4, 108, 48),
            (CellKind::Tet10, 108, 7 * 5 * 7),
        ] {
            let mesh = check(&block(), kind);
            assert_eq!(
                (mesh.cell_count(), mesh.node_count()),
                (cells, nodes),
                "{kind}"
            );
            let along_edge = if kind.order() == 2 { 7 } else { 4 };
            let edge = &mesh.node_sets["edge"];
            assert_eq!(edge.len(), along_edge, "{kind}");
            assert!(edge.iter().all(|&a| mesh.points[a][1..] == [0.0, 0.0]));
        }
        let wedges = check(&block(), CellKind::Wedge6);
        assert_eq!(check(&wedges, CellKind::Tet10).cell_count(), 108);
        let tets = check(&block(), CellKind::Tet4);
        assert_eq!(
            check(&tets, CellKind::Tet10),
            check(&block(), CellKind::Tet10)
        );
    }

    #[test]
    fn a_rectangle_in_every_kind() {
        for (kind, cells, nodes) in [
            (CellKind::Tri3, 12, 12),
            (CellKind::Tri6, 12, 35),
            (CellKind::Quad8, 6, 29),
            (CellKind::Quad9, 6, 35),
        ] {
            let mesh = check(&plate(), kind);
            assert_eq!((mesh.cell_count(), mesh.node_count()), (cells, nodes));
            assert_eq!(
                mesh.node_sets["edge"].len(),
                if kind.order() == 2 { 7 } else { 4 }
            );
        }
    }

    /// Hexahedra that start at any of their corners, as in an unstructured mesh: tetrahedra match,
    /// whatever the numbering; wedges do not, and that is said.
    #[test]
    fn cuts_match_whatever_the_numbering() {
        // Turns about ζ and about the diagonal 0–6.
        let turns = [[1, 2, 3, 0, 5, 6, 7, 4], [0, 3, 7, 4, 1, 2, 6, 5]];
        let mut mesh = block();
        mesh.face_sets.clear();
        for (cell, nodes) in mesh.cells[0].connectivity.chunks_exact_mut(8).enumerate() {
            for (turn, times) in turns.into_iter().zip([cell % 4, cell % 3]) {
                for _ in 0..times {
                    let before = nodes.to_vec();
                    for (node, a) in nodes.iter_mut().zip(turn) {
                        *node = before[a];
                    }
                }
            }
        }
        mesh.check_cells().unwrap();
        let faces = mesh.boundary_faces();
        mesh.face_sets.insert("all".into(), faces);
        check(&mesh, CellKind::Tet10);
        assert_eq!(
            mesh.with_cells(CellKind::Wedge6),
            Err(FemError::CutsDoNotMatch {
                to: CellKind::Wedge6
            })
        );
    }

    #[test]
    fn there_is_no_way_back() {
        let (from, to) = (CellKind::Tet10, CellKind::Hex8);
        let tets = block().with_cells(from).unwrap();
        assert_eq!(
            tets.clone().with_cells(to),
            Err(FemError::CellConversion { from, to })
        );
        assert_eq!(tets.clone().with_cells(from), Ok(tets));
        let refused = plate().with_cells(CellKind::Hex8);
        assert!(matches!(refused, Err(FemError::CellConversion { .. })));
    }

    #[test]
    fn a_face_of_a_set_stays_with_its_cell() {
        let mut mesh = block();
        let one = Face { cell: 7, local: 3 };
        mesh.face_sets = [("inside".to_owned(), vec![one])].into();
        let cut = mesh.with_cells(CellKind::Tet4).unwrap();
        let faces = &cut.face_sets["inside"];
        assert_eq!(faces.len(), 2);
        assert!(faces.iter().all(|face| (42..48).contains(&face.cell)));
    }
}
