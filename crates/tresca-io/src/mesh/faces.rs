//! Which cells a face belongs to.

use tresca_fem::mesh::CellKind;

use super::cells::FileCells;

/// The corners of a face, ascending; a face of fewer than four is filled up.
type Key = [usize; 4];

/// A side of a cell: the cell, and the number of the face in it.
pub(super) type Side = [usize; 2];

/// The sides of the cells of a file, by their corners: a face that two cells share has two sides.
/// (The faces of a body have [`tresca_fem::mesh::FaceLookup`].)
#[derive(Debug)]
pub(super) struct FaceMap {
    /// Sorted.
    sides: Vec<(Key, Side)>,
}

impl FaceMap {
    /// Of all cells of a dimension.
    pub fn new(cells: &FileCells, dimension: usize) -> Self {
        let mut sides = Vec::new();
        for cell in cells.of_dimension(dimension) {
            let nodes = cells.nodes(cell);
            for (local, face) in cells.kind(cell).faces().iter().enumerate() {
                let corners = &face.nodes[..face.kind.corner_count()];
                sides.push((key(corners.iter().map(|&a| nodes[a])), [cell, local]));
            }
        }
        sides.sort_unstable();
        Self { sides }
    }

    /// Whether a cell has a face with these corners, in any order.
    pub fn contains(&self, corners: &[usize]) -> bool {
        let wanted = key(corners.iter().copied());
        self.sides
            .binary_search_by_key(&wanted, |(key, _)| *key)
            .is_ok()
    }

    /// The sides that no other cell shares, ordered by cell and face.
    pub fn exterior(&self) -> Vec<Side> {
        let groups = self.sides.chunk_by(|a, b| a.0 == b.0);
        let mut sides: Vec<Side> = groups
            .filter(|same| same.len() == 1)
            .map(|same| same[0].1)
            .collect();
        sides.sort_unstable();
        sides
    }
}

fn key(corners: impl Iterator<Item = usize>) -> Key {
    let mut key = [usize::MAX; 4];
    for (slot, corner) in key.iter_mut().zip(corners) {
        *slot = corner;
    }
    key.sort_unstable();
    key
}

/// The kind and the nodes of a side, in the order of the face's element: seen from outside of the
/// cell, counter-clockwise.
pub(super) fn side(cells: &FileCells, [cell, local]: Side) -> (CellKind, Vec<usize>) {
    let face = &cells.kind(cell).faces()[local];
    let nodes = cells.nodes(cell);
    (face.kind, face.nodes.iter().map(|&a| nodes[a]).collect())
}
