//! A mesh of some of the cells.

use super::data::{CellBlock, Face, Mesh};

/// Marks a node or a cell that is left out.
const LEFT_OUT: usize = usize::MAX;

impl Mesh {
    /// The mesh of some cells, and for each of its nodes the node of this mesh: one body out of several.
    ///
    /// Cells and nodes keep their order, blocks without cells are left out. Face and node sets keep
    /// those members that remain; a set without any is left out.
    ///
    /// # Panics
    /// When there is no such cell.
    pub fn submesh(&self, cells: &[usize]) -> (Mesh, Vec<usize>) {
        let mut new_cell = vec![LEFT_OUT; self.cell_count()];
        let mut new_node = vec![LEFT_OUT; self.node_count()];
        for &cell in cells {
            new_cell[cell] = 0;
            for &node in self.cell(cell).nodes {
                new_node[node] = 0;
            }
        }
        let number = |flags: &mut Vec<usize>| -> Vec<usize> {
            let kept: Vec<usize> = (0..flags.len()).filter(|&i| flags[i] != LEFT_OUT).collect();
            for (new, &old) in kept.iter().enumerate() {
                flags[old] = new;
            }
            kept
        };
        number(&mut new_cell);
        let old_node = number(&mut new_node);

        let mut first = 0;
        let mut blocks = Vec::new();
        for block in &self.cells {
            let kept = block.cells().enumerate();
            let kept = kept.filter(|(local, _)| new_cell[first + local] != LEFT_OUT);
            let connectivity: Vec<usize> = kept
                .flat_map(|(_, nodes)| nodes.iter().map(|&node| new_node[node]))
                .collect();
            if !connectivity.is_empty() {
                blocks.push(CellBlock {
                    kind: block.kind,
                    connectivity,
                });
            }
            first += block.len();
        }
        let kept = |new: usize| (new != LEFT_OUT).then_some(new);
        let face = |face: &Face| {
            kept(new_cell[face.cell]).map(|cell| Face {
                cell,
                local: face.local,
            })
        };
        let face_sets = self.face_sets.iter().map(|(name, faces)| {
            let faces: Vec<Face> = faces.iter().filter_map(face).collect();
            (name.clone(), faces)
        });
        let node_sets = self.node_sets.iter().map(|(name, nodes)| {
            let nodes = nodes.iter().filter_map(|&node| kept(new_node[node]));
            (name.clone(), nodes.collect::<Vec<usize>>())
        });
        let mesh = Mesh {
            space: self.space,
            points: old_node.iter().map(|&node| self.points[node]).collect(),
            cells: blocks,
            face_sets: face_sets.filter(|(_, faces)| !faces.is_empty()).collect(),
            node_sets: node_sets.filter(|(_, nodes)| !nodes.is_empty()).collect(),
        };
        (mesh, old_node)
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::brick::{BrickSpec, brick};
    use crate::mesh::data::{CellBlock, Face};
    use crate::mesh::kind::CellKind;

    #[test]
    fn a_part_keeps_its_sets() {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [4.0, 1.0, 1.0],
            nodes: [5, 2, 2],
        };
        let mut mesh = brick(&spec).unwrap();
        // Two blocks; the sets count through both.
        let connectivity = mesh.cells[0].connectivity.split_off(3 * 8);
        let kind = CellKind::Hex8;
        mesh.cells.push(CellBlock { kind, connectivity });
        mesh.node_sets.insert("tip".into(), vec![4, 2]);
        mesh.node_sets.insert("root".into(), vec![0]);

        let (part, nodes) = mesh.submesh(&[3, 2]);
        part.validate().unwrap();
        assert_eq!(nodes, [2, 3, 4, 7, 8, 9, 12, 13, 14, 17, 18, 19]);
        assert_eq!((part.cells.len(), part.cell_count()), (2, 2));
        assert!((part.volume() - 2.0).abs() < 1e-14);
        assert_eq!(part.node_sets.len(), 1);
        assert_eq!(part.node_sets["tip"], [2, 0]);
        assert!(!part.face_sets.contains_key("x-"));
        assert_eq!(part.face_sets["x+"], [Face { cell: 1, local: 1 }]);
        assert_eq!(part.face_sets["z-"].len(), 2);
        assert!((part.area_vector(&part.face_sets["x+"])[0] - 1.0).abs() < 1e-14);

        let (all, _) = mesh.submesh(&[0, 1, 2, 3]);
        assert_eq!(all, mesh);
    }
}
