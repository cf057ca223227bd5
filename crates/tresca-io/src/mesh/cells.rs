//! The cells of a file, of all kinds and dimensions, in the order of the file.

use tresca_fem::mesh::CellKind;

/// Cells of a file, in its order. Cells are counted from 0 through all kinds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FileCells {
    kinds: Vec<CellKind>,
    /// Where the nodes of each cell start; one more entry for the end.
    starts: Vec<usize>,
    nodes: Vec<usize>,
    numbers: Vec<u64>,
    entities: Vec<u32>,
}

impl FileCells {
    /// Appends a cell with the nodes of its kind (indices of points, VTK's order).
    pub(super) fn push(&mut self, kind: CellKind, nodes: &[usize], number: u64, entity: u32) {
        debug_assert_eq!(nodes.len(), kind.node_count());
        if self.starts.is_empty() {
            self.starts.push(0);
        }
        self.kinds.push(kind);
        self.nodes.extend_from_slice(nodes);
        self.starts.push(self.nodes.len());
        self.numbers.push(number);
        self.entities.push(entity);
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.kinds.len()
    }

    /// No cells at all?
    pub fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    /// The kind of a cell.
    ///
    /// # Panics
    /// When there is no such cell, as all accessors here.
    pub fn kind(&self, cell: usize) -> CellKind {
        self.kinds[cell]
    }

    /// The points of a cell, in VTK's order.
    pub fn nodes(&self, cell: usize) -> &[usize] {
        &self.nodes[self.starts[cell]..self.starts[cell + 1]]
    }

    /// The number that the file gives a cell.
    pub fn number(&self, cell: usize) -> u64 {
        self.numbers[cell]
    }

    /// What the cell was made with: in Gmsh the number of the elementary entity, in a deck that of the
    /// `*ELEMENT` line, from 0.
    pub fn entity(&self, cell: usize) -> u32 {
        self.entities[cell]
    }

    /// All cells of a dimension, ascending.
    pub fn of_dimension(&self, dimension: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.len()).filter(move |&cell| self.kinds[cell].dimension() == dimension)
    }
}
