//! The shape of cells: which of them cannot be integrated, and why.

use super::data::Mesh;
use super::geometry::gather_points;
use super::kind::CellKind;
use crate::element::mapping::{Orientation, orientation};
use crate::element::table::ShapeTable;
use crate::error::FemError;

/// Both rules of a kind: whatever is integrated, it is at these points.
fn tables(kind: CellKind) -> [ShapeTable; 2] {
    [ShapeTable::stiffness(kind), ShapeTable::mass(kind)]
}

impl Mesh {
    /// Checks that the Jacobian of every cell is positive at all points of its stiffness and mass
    /// rules.
    ///
    /// # Errors
    /// For the lowest cell that fails: [`FemError::InvertedCell`] when it is turned inside out as a
    /// whole, [`FemError::FoldedCell`] when a part of it is, [`FemError::DegenerateCell`] when it has no
    /// volume somewhere.
    pub fn check_cells(&self) -> Result<(), FemError> {
        let mut cell = 0;
        for block in &self.cells {
            let tables = tables(block.kind);
            for nodes in block.cells() {
                match self.judge(&tables, cell, nodes) {
                    Some(fault) => return Err(fault),
                    None => cell += 1,
                }
            }
        }
        Ok(())
    }

    /// What is wrong with a cell that could not be integrated.
    pub(crate) fn cell_fault(&self, cell: usize) -> FemError {
        let of = self.cell(cell);
        let fault = self.judge(&tables(of.kind), cell, of.nodes);
        fault.unwrap_or_else(|| FemError::DegenerateCell {
            cell,
            position: self.centre(of.nodes),
        })
    }

    fn judge(&self, tables: &[ShapeTable; 2], cell: usize, nodes: &[usize]) -> Option<FemError> {
        let mut points = vec![[0.0; 3]; nodes.len()];
        gather_points(self, nodes, &mut points);
        let [mut positive, mut negative, mut total] = [0; 3];
        let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
        for table in tables {
            for q in 0..table.len() {
                let (determinant, side) =
                    orientation(self.dimension(), table.gradients(q), &points);
                (lowest, highest) = (lowest.min(determinant), highest.max(determinant));
                total += 1;
                match side {
                    Orientation::Positive => positive += 1,
                    Orientation::Negative => negative += 1,
                    Orientation::Flat => {}
                }
            }
        }
        let position = self.centre(nodes);
        match (positive, negative) {
            _ if positive == total => None,
            (0, n) if n == total => Some(FemError::InvertedCell {
                cell,
                position,
                determinant: highest,
            }),
            (p, n) if p > 0 && n > 0 => Some(FemError::FoldedCell {
                cell,
                position,
                determinant: lowest,
            }),
            _ => Some(FemError::DegenerateCell { cell, position }),
        }
    }

    /// The mean of some nodes' positions.
    fn centre(&self, nodes: &[usize]) -> [f64; 3] {
        let count = nodes.len() as f64;
        std::array::from_fn(|i| nodes.iter().map(|&a| self.points[a][i]).sum::<f64>() / count)
    }
}

#[cfg(test)]
mod tests {
    use crate::error::FemError;
    use crate::mesh::brick::{BrickSpec, brick};
    use crate::mesh::data::Mesh;
    use crate::mesh::kind::CellKind;

    fn bar(kind: CellKind) -> Mesh {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [3.0, 1.0, 1.0],
            nodes: [4, 2, 2],
        };
        brick(&spec).unwrap().with_cells(kind).unwrap()
    }

    #[test]
    fn inverted_folded_and_degenerate_cells_are_told_apart() {
        let mut mesh = bar(CellKind::Hex8);
        mesh.cells[0].connectivity[8..16].rotate_left(4);
        match mesh.check_cells().unwrap_err() {
            FemError::InvertedCell {
                cell: 1,
                position,
                determinant,
            } => {
                assert_eq!(position, [1.5, 0.5, 0.5]);
                assert!((determinant + 0.125).abs() < 1e-15);
            }
            other => panic!("{other}"),
        }
        assert_eq!(
            mesh.check_cells().unwrap_err().to_string(),
            "cell 1, around (1.5, 0.5, 0.5), is turned inside out: det J = -1.250e-1 at most \
             (expected > 0); are its nodes numbered the other way round?"
        );

        // One corner pushed through the opposite one.
        let mut mesh = bar(CellKind::Hex8);
        let corner = mesh.cells[0].connectivity[2 * 8 + 6];
        mesh.points[corner] = [1.8, -0.2, -0.2];
        let folded = mesh.check_cells().unwrap_err();
        assert!(
            matches!(folded, FemError::FoldedCell { cell: 2, .. }),
            "{folded}"
        );

        // Two layers of nodes in one place.
        let mut mesh = bar(CellKind::Wedge6);
        for point in &mut mesh.points {
            point[0] = point[0].min(2.0);
        }
        let flat = mesh.check_cells().unwrap_err();
        match flat {
            FemError::DegenerateCell { cell: 4, position } => assert_eq!(position[0], 2.0),
            other => panic!("{other}"),
        }
    }

    #[test]
    fn a_mid_node_far_from_its_edge_folds_a_cell() {
        for kind in [CellKind::Tet10, CellKind::Hex20, CellKind::Hex27] {
            let mut mesh = bar(kind);
            mesh.check_cells().unwrap();
            let mid = mesh.cells[0].connectivity[kind.corner_count()];
            let [a, b] = [0, 1].map(|corner| mesh.points[mesh.cell(0).nodes[corner]]);
            mesh.points[mid] = std::array::from_fn(|i| a[i] + 2.5 * (b[i] - a[i]));
            let folded = mesh.check_cells().unwrap_err();
            assert!(
                matches!(folded, FemError::FoldedCell { cell: 0, .. }),
                "{folded}"
            );
        }
    }
}
