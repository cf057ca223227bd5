//! What of a file belongs to a body, and how it is numbered there.

use std::collections::BTreeMap;

use tresca_fem::mesh::{CellBlock, Space};

use super::super::file::MeshFile;
use super::super::order::{reorder, turned_over};
use super::note::MeshNote;

/// What of a file belongs to a body.
#[derive(Debug)]
pub(super) struct Members {
    /// By cell of the mesh.
    pub cells: Vec<usize>,
    /// By cell of the file; `usize::MAX` for none.
    cell_numbers: Vec<usize>,
    /// By node of the mesh, ascending.
    pub nodes: Vec<usize>,
    /// By point of the file; `usize::MAX` for none.
    node_numbers: Vec<usize>,
}

impl Members {
    pub fn new(file: &MeshFile, mut cells: Vec<usize>) -> Self {
        // Cells of one kind stand together; a stable sort keeps the order of the file among them.
        cells.sort_by_key(|&cell| file.cells.kind(cell));
        let mut cell_numbers = vec![usize::MAX; file.cells.len()];
        let mut used = vec![false; file.points.len()];
        for (number, &cell) in cells.iter().enumerate() {
            cell_numbers[cell] = number;
            for &node in file.cells.nodes(cell) {
                used[node] = true;
            }
        }
        let nodes: Vec<usize> = (0..used.len()).filter(|&node| used[node]).collect();
        let mut node_numbers = vec![usize::MAX; used.len()];
        for (number, &node) in nodes.iter().enumerate() {
            node_numbers[node] = number;
        }
        Self {
            cells,
            cell_numbers,
            nodes,
            node_numbers,
        }
    }

    pub fn node(&self, point: usize) -> Option<usize> {
        Some(self.node_numbers[point]).filter(|&number| number != usize::MAX)
    }

    pub fn cell(&self, cell: usize) -> Option<usize> {
        Some(self.cell_numbers[cell]).filter(|&number| number != usize::MAX)
    }

    /// The blocks of cells. In the plane, surfaces that run clockwise throughout are turned over:
    /// which way a surface runs is an accident of its drawing, not a defect of its mesh.
    pub fn blocks(
        &mut self,
        file: &MeshFile,
        space: Space,
        points: &[[f64; 3]],
        notes: &mut Vec<MeshNote>,
    ) -> Vec<CellBlock> {
        let clockwise = match space.dimension() {
            2 => self.clockwise_entities(file, points),
            _ => BTreeMap::new(),
        };
        let mut turned = 0;
        let mut blocks: Vec<CellBlock> = Vec::new();
        let (mut nodes, mut scratch) = (Vec::new(), Vec::new());
        for &cell in &self.cells {
            let kind = file.cells.kind(cell);
            nodes.clear();
            nodes.extend(file.cells.nodes(cell).iter().map(|&p| self.node_numbers[p]));
            if clockwise.get(&file.cells.entity(cell)) == Some(&true) {
                reorder(turned_over(kind), &mut nodes, &mut scratch);
                turned += 1;
            }
            match blocks.last_mut().filter(|block| block.kind == kind) {
                Some(block) => block.connectivity.extend(&nodes),
                None => blocks.push(CellBlock {
                    kind,
                    connectivity: nodes.clone(),
                }),
            }
        }
        if turned > 0 {
            notes.push(MeshNote::Clockwise { cells: turned });
        }
        blocks
    }

    /// By entity, whether all its cells in the body run clockwise.
    fn clockwise_entities(&self, file: &MeshFile, points: &[[f64; 3]]) -> BTreeMap<u32, bool> {
        let mut clockwise = BTreeMap::new();
        for &cell in &self.cells {
            let corners = &file.cells.nodes(cell)[..file.cells.kind(cell).corner_count()];
            let place = |point: usize| points[self.node_numbers[point]];
            // Twice the area, by the corners.
            let area: f64 = (0..corners.len())
                .map(|i| {
                    let [ax, ay, _] = place(corners[i]);
                    let [bx, by, _] = place(corners[(i + 1) % corners.len()]);
                    ax * by - bx * ay
                })
                .sum();
            let all = clockwise.entry(file.cells.entity(cell)).or_insert(true);
            *all &= area < 0.0;
        }
        clockwise
    }
}
