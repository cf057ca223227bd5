//! A contiguous range of the matrix's columns, and its pattern.

use crate::dofs::DofMap;
use crate::mesh::data::Mesh;
use crate::mesh::topology::Incidence;
use std::ops::Range;

/// The columns of the free dofs of a range of nodes.
///
/// The pattern is kept by node, not by dof: for each node b of the range, the nodes a ≥ b that share
/// a cell with it, ascending, b first. A column of b then has the free dofs of those nodes as its
/// rows, from its own diagonal downwards, because free dofs are numbered by node.
pub(crate) struct ColumnRange {
    nodes: Range<usize>,
    /// Cells that touch the range, ascending.
    cells: Vec<usize>,
    /// Where each node's neighbours start.
    starts: Vec<usize>,
    neighbours: Vec<usize>,
    /// For each neighbour the number of free dofs of the neighbours before it.
    offsets: Vec<u32>,
    /// Number of entries of all columns.
    entries: usize,
}

/// Number of free dofs of a node.
fn free_count(dofs: &DofMap, node: usize) -> usize {
    free_dofs(dofs, node).count()
}

/// Component and free dof of a node's free components.
#[inline]
fn free_dofs(dofs: &DofMap, node: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
    (0..dofs.components()).filter_map(move |i| dofs.free(node, i).map(|free| (i, free)))
}

impl ColumnRange {
    pub fn new(mesh: &Mesh, dofs: &DofMap, incidence: &Incidence, nodes: Range<usize>) -> Self {
        let mut cells: Vec<usize> = nodes
            .clone()
            .flat_map(|node| incidence.cells_at(node))
            .copied()
            .collect();
        cells.sort_unstable();
        cells.dedup();

        let mut starts = Vec::with_capacity(nodes.len() + 1);
        let (mut neighbours, mut offsets) = (Vec::new(), Vec::new());
        let (mut around, mut entries) = (Vec::new(), 0);
        starts.push(0);
        for node in nodes.clone() {
            around.clear();
            for &cell in incidence.cells_at(node) {
                around.extend(mesh.cell(cell).nodes.iter().copied().filter(|&a| a >= node));
            }
            around.sort_unstable();
            around.dedup();
            let mut length = 0;
            for &a in &around {
                neighbours.push(a);
                offsets.push(length as u32);
                length += free_count(dofs, a);
            }
            starts.push(neighbours.len());
            entries += (0..free_count(dofs, node))
                .map(|j| length - j)
                .sum::<usize>();
        }
        Self {
            nodes,
            cells,
            starts,
            neighbours,
            offsets,
            entries,
        }
    }

    /// Number of entries of all columns of the range.
    pub fn entries(&self) -> usize {
        self.entries
    }

    pub fn contains(&self, node: usize) -> bool {
        self.nodes.contains(&node)
    }

    /// The range's cells with numbers in `block`.
    pub fn cells_within(&self, block: Range<usize>) -> &[usize] {
        let start = self.cells.partition_point(|&cell| cell < block.start);
        let end = self.cells.partition_point(|&cell| cell < block.end);
        &self.cells[start..end]
    }

    /// Length of each column.
    pub fn column_lengths<'a>(&'a self, dofs: &'a DofMap) -> impl Iterator<Item = usize> + 'a {
        self.nodes.clone().flat_map(move |node| {
            let length: usize = self
                .around(node)
                .0
                .iter()
                .map(|&a| free_count(dofs, a))
                .sum();
            (0..free_count(dofs, node)).map(move |j| length - j)
        })
    }

    /// Neighbours of a node of the range, and their offsets.
    #[inline]
    fn around(&self, node: usize) -> (&[usize], &[u32]) {
        let local = node - self.nodes.start;
        let range = self.starts[local]..self.starts[local + 1];
        (&self.neighbours[range.clone()], &self.offsets[range])
    }

    /// Writes the row numbers of all columns.
    pub fn write_rows(&self, dofs: &DofMap, rows: &mut [usize]) {
        let mut next = rows.iter_mut();
        for node in self.nodes.clone() {
            for (_, column) in free_dofs(dofs, node) {
                let below = self.around(node).0.iter().flat_map(|&a| free_dofs(dofs, a));
                for (_, row) in below.filter(|&(_, row)| row >= column) {
                    *next.next().expect("as many rows as were counted") = row;
                }
            }
        }
    }
}

/// The values of a range's columns, open for adding.
pub(crate) struct ColumnValues<'a> {
    pub range: &'a ColumnRange,
    pub dofs: &'a DofMap,
    /// Column starts in the whole matrix.
    pub starts: &'a [usize],
    /// Where the range starts in the whole matrix.
    pub first_entry: usize,
    /// The range's entries.
    pub values: &'a mut [f64],
}

impl ColumnValues<'_> {
    /// Adds one cell's part to the columns of `node`: `block(a)` is the block (by components) between
    /// the cell's a-th node (row) and `node` (column).
    #[inline]
    pub fn add<const D: usize>(
        &mut self,
        node: usize,
        cell: &[usize],
        block: impl Fn(usize) -> [[f64; D]; D],
    ) {
        let (neighbours, offsets) = self.range.around(node);
        let Some((_, first)) = free_dofs(self.dofs, node).next() else {
            return;
        };
        for (a, &row_node) in cell.iter().enumerate() {
            if row_node < node {
                continue;
            }
            let at = neighbours.partition_point(|&neighbour| neighbour < row_node);
            let offset = offsets[at] as usize;
            let entries = block(a);
            for (j, column) in free_dofs(self.dofs, node) {
                // The k-th column of a node lacks the k rows above its diagonal.
                let start = self.starts[column] - self.first_entry + offset - (column - first);
                let rows = free_dofs(self.dofs, row_node).enumerate();
                for (k, (i, _)) in rows.filter(|&(_, (_, row))| row >= column) {
                    self.values[start + k] += entries[i][j];
                }
            }
        }
    }
}
