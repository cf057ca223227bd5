//! What a mesh file says.

use std::path::PathBuf;

use tresca_fem::mesh::CellKind;

use super::cells::FileCells;
use crate::mesh::error::{MeshFault, MeshFileError};
use crate::names::listed;

/// A mesh file: points, cells of all kinds and dimensions, groups by name.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// Where it was read.
    pub path: PathBuf,
    /// Format, version and encoding in words.
    pub format: String,
    /// Coordinates (length).
    pub points: Vec<[f64; 3]>,
    /// The numbers that the file gives its nodes, by point. Of a deck with several instances, numbers
    /// repeat.
    pub point_numbers: Vec<u64>,
    /// The cells, in the order of the file.
    pub cells: FileCells,
    /// Named parts, ordered by dimension, the highest first, then by name.
    pub groups: Vec<Group>,
    /// What the file holds that is of no use for a mesh, each sort of thing once.
    pub skipped: Vec<String>,
    /// By [`FileCells::entity`]: the names of the instances of a deck, if there are several. Empty
    /// for other files.
    pub(super) instances: Vec<String>,
}

/// A named part of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Its name. A physical group of Gmsh without a name has its number for one.
    pub name: String,
    /// Of its members: 3 for a volume, 2 for a surface, 1 for a curve, 0 for points.
    pub dimension: usize,
    /// Cells of this dimension, ascending, each once.
    pub cells: Vec<usize>,
    /// Sides of cells of one dimension more, as cell and number of the face in the cell: surfaces of
    /// decks consist of them. Ascending, each once.
    pub faces: Vec<[usize; 2]>,
    /// Points that are members by themselves, ascending, each once. Empty for dimensions above 0.
    pub nodes: Vec<usize>,
}

impl MeshFile {
    /// Dimension of the cells of highest dimension; 0 without cells.
    pub fn dimension(&self) -> usize {
        let kinds = (0..self.cells.len()).map(|cell| self.cells.kind(cell).dimension());
        kinds.max().unwrap_or(0)
    }

    /// The names of the groups of a dimension.
    pub fn group_names(&self, dimension: usize) -> Vec<&str> {
        let of_dimension = self.groups.iter().filter(|g| g.dimension == dimension);
        of_dimension.map(|group| group.name.as_str()).collect()
    }

    /// The group of a name and dimension.
    ///
    /// # Errors
    /// [`MeshFault::GroupDimension`] where only groups of other dimensions have the name,
    /// [`MeshFault::UnknownGroup`] where none has.
    pub fn group(&self, name: &str, dimension: usize) -> Result<&Group, MeshFileError> {
        let named = || self.groups.iter().filter(|group| group.name == name);
        if let Some(group) = named().find(|group| group.dimension == dimension) {
            return Ok(group);
        }
        Err(match named().next() {
            Some(other) => MeshFault::GroupDimension {
                name: name.to_owned(),
                expected: dimension,
                found: other.dimension,
            }
            .at(self.path.clone()),
            None => MeshFault::UnknownGroup {
                name: name.to_owned(),
                dimension,
                known: self
                    .group_names(dimension)
                    .into_iter()
                    .map(str::to_owned)
                    .collect(),
            }
            .at(self.path.clone()),
        })
    }

    /// The file in one line: format, numbers of points and cells, groups.
    pub fn describe(&self) -> String {
        let mut kinds: Vec<(CellKind, usize)> = Vec::new();
        for cell in 0..self.cells.len() {
            let kind = self.cells.kind(cell);
            match kinds.iter_mut().find(|(known, _)| *known == kind) {
                Some((_, count)) => *count += 1,
                None => kinds.push((kind, 1)),
            }
        }
        kinds.sort_unstable();
        let kinds = kinds
            .iter()
            .map(|(kind, count)| format!(", {count} {kind}"));
        let names: Vec<&str> = self
            .groups
            .iter()
            .map(|group| group.name.as_str())
            .collect();
        format!(
            "{}: {} points{}; groups: {}",
            self.format,
            self.points.len(),
            kinds.collect::<String>(),
            listed(&names)
        )
    }

    /// An element in words, by the numbers of the file.
    pub(super) fn element(&self, cell: usize) -> String {
        let number = self.cells.number(cell);
        match self.instances.get(self.cells.entity(cell) as usize) {
            None => format!("element {number}"),
            Some(instance) => format!("element {number} ({instance})"),
        }
    }

    /// The mean of the points of a cell (length).
    pub(super) fn centre(&self, cell: usize) -> [f64; 3] {
        let nodes = self.cells.nodes(cell);
        let share = 1.0 / nodes.len() as f64;
        std::array::from_fn(|i| nodes.iter().map(|&node| self.points[node][i]).sum::<f64>() * share)
    }
}

/// Groups while a file is read: by name and dimension, in any order.
#[derive(Debug, Default)]
pub(super) struct Groups(std::collections::BTreeMap<(std::cmp::Reverse<usize>, String), Group>);

impl Groups {
    /// The group of a name and dimension, new where there was none.
    pub fn of(&mut self, name: &str, dimension: usize) -> &mut Group {
        let key = (std::cmp::Reverse(dimension), name.to_owned());
        self.0.entry(key).or_insert_with(|| Group {
            name: name.to_owned(),
            dimension,
            cells: Vec::new(),
            faces: Vec::new(),
            nodes: Vec::new(),
        })
    }

    /// The groups that have members, in order, their members too.
    pub fn finish(self) -> Vec<Group> {
        let mut groups: Vec<Group> = self.0.into_values().collect();
        for group in &mut groups {
            group.cells.sort_unstable();
            group.cells.dedup();
            group.faces.sort_unstable();
            group.faces.dedup();
            group.nodes.sort_unstable();
            group.nodes.dedup();
        }
        groups.retain(|g| !(g.cells.is_empty() && g.faces.is_empty() && g.nodes.is_empty()));
        groups
    }
}

/// Keeps each sort of skipped thing once.
pub(super) fn note_skipped(skipped: &mut Vec<String>, what: impl Into<String>) {
    let what = what.into();
    if !skipped.contains(&what) {
        skipped.push(what);
    }
}
