//! The mesh of a file while it is read.

use std::path::{Path, PathBuf};

use tresca_fem::mesh::CellKind;

use std::collections::HashMap;

use super::super::cells::FileCells;
use super::super::error::{MeshFault, MeshFileError};
use super::super::file::{Groups, MeshFile};
use super::super::numbering::Numbering;
use super::super::order::{from_gmsh, reorder};
use super::input::Input;
use super::kinds::{Kind, kind};
use crate::located::FilePlace;

/// Names of physical groups, by dimension and number.
pub(super) type Names = HashMap<(usize, i32), String>;

/// What was read so far.
#[derive(Debug)]
pub(super) struct Draft {
    path: PathBuf,
    format: String,
    pub points: Vec<[f64; 3]>,
    pub point_numbers: Vec<u64>,
    numbering: Option<Numbering>,
    cells: FileCells,
    groups: Groups,
    pub skipped: Vec<String>,
    /// Work memory: the nodes of an element.
    nodes: Vec<usize>,
    scratch: Vec<usize>,
}

/// What an element belongs to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Membership<'a> {
    /// Number of the elementary entity.
    pub entity: i32,
    /// Numbers of the physical groups; in version 2 one, 0 for none.
    pub physical: &'a [i32],
    pub names: &'a Names,
}

impl Draft {
    pub fn new(path: &Path, format: String) -> Self {
        Self {
            path: path.to_owned(),
            format,
            points: Vec::new(),
            point_numbers: Vec::new(),
            numbering: None,
            cells: FileCells::default(),
            groups: Groups::default(),
            skipped: Vec::new(),
            nodes: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// Appends a node.
    pub fn push_node(
        &mut self,
        place: impl FnOnce() -> FilePlace,
        number: u64,
        point: [f64; 3],
    ) -> Result<(), MeshFileError> {
        if !point.iter().all(|x| x.is_finite()) {
            return Err(MeshFault::NotFinite {
                node: number,
                point,
            }
            .at(place()));
        }
        self.points.push(point);
        self.point_numbers.push(number);
        Ok(())
    }

    /// All nodes are there.
    pub fn end_nodes(&mut self, place: FilePlace) -> Result<(), MeshFileError> {
        let numbering = Numbering::new(&self.point_numbers).map_err(|i| {
            MeshFault::DuplicateNumber {
                what: "node",
                number: self.point_numbers[i],
            }
            .at(place)
        })?;
        self.numbering = Some(numbering);
        Ok(())
    }

    /// Reads the nodes of an element with `read`, and files the element.
    pub fn element(
        &mut self,
        input: &mut Input<'_>,
        (element_type, number): (i32, u64),
        membership: Membership<'_>,
        read: impl Fn(&mut Input<'_>) -> Result<u64, MeshFileError>,
    ) -> Result<(), MeshFileError> {
        let Some(numbering) = &self.numbering else {
            return Err(MeshFault::syntax(
                input.place(),
                "the section `$Nodes` ahead of the elements",
                "none",
            ));
        };
        let mark = input.mark();
        let (count, cell_kind) = match kind(element_type) {
            Kind::Point => (1, None),
            Kind::Cell(kind) => (kind.node_count(), Some(kind)),
            Kind::Unsupported(name) => {
                return Err(MeshFault::ElementType {
                    element: number,
                    name: format!("{element_type} ({name})"),
                }
                .at(input.place_of(mark)));
            }
        };
        self.nodes.clear();
        for _ in 0..count {
            let node = read(input)?;
            let Some(index) = numbering.find(node) else {
                return Err(MeshFault::UnknownNode {
                    element: number,
                    node,
                }
                .at(input.place_of(mark)));
            };
            self.nodes.push(index);
        }
        match cell_kind {
            None => self.file_point(membership),
            Some(kind) => self.file_cell(kind, number, membership),
        }
        Ok(())
    }

    fn file_point(&mut self, membership: Membership<'_>) {
        for name in group_names(membership, 0) {
            self.groups.of(&name, 0).nodes.push(self.nodes[0]);
        }
    }

    fn file_cell(&mut self, kind: CellKind, number: u64, membership: Membership<'_>) {
        reorder(from_gmsh(kind), &mut self.nodes, &mut self.scratch);
        let entity = membership.entity.unsigned_abs();
        if !self.repeats_last(kind, entity) {
            self.cells.push(kind, &self.nodes, number, entity);
        }
        let cell = self.cells.len() - 1;
        for name in group_names(membership, kind.dimension()) {
            self.groups.of(&name, kind.dimension()).cells.push(cell);
        }
    }

    /// Version 2 writes an element of several groups once for each of them, one after the other,
    /// turned over where the group has the entity reversed.
    fn repeats_last(&mut self, kind: CellKind, entity: u32) -> bool {
        let Some(last) = self.cells.len().checked_sub(1) else {
            return false;
        };
        if self.cells.kind(last) != kind || self.cells.entity(last) != entity {
            return false;
        }
        let sorted = |nodes: &[usize]| {
            let mut nodes = nodes.to_vec();
            nodes.sort_unstable();
            nodes
        };
        // Cheap first: neighbours in the file rarely share their lowest node and their sum.
        let (old, new) = (self.cells.nodes(last), self.nodes.as_slice());
        old.iter().sum::<usize>() == new.iter().sum::<usize>() && sorted(old) == sorted(new)
    }

    pub fn finish(self, input: &Input<'_>) -> Result<MeshFile, MeshFileError> {
        if self.numbering.is_none() {
            return Err(MeshFault::Truncated {
                expected: "the section `$Nodes`".to_owned(),
            }
            .at(input.place()));
        }
        Ok(MeshFile {
            path: self.path,
            format: self.format,
            points: self.points,
            point_numbers: self.point_numbers,
            cells: self.cells,
            groups: self.groups.finish(),
            skipped: self.skipped,
            instances: Vec::new(),
        })
    }
}

/// Names of the physical groups; a negative number is a group that has the entity reversed.
fn group_names(membership: Membership<'_>, dimension: usize) -> impl Iterator<Item = String> {
    let physical = membership.physical.iter().map(|number| number.abs());
    physical.filter(|&number| number != 0).map(move |number| {
        let name = membership.names.get(&(dimension, number));
        name.cloned().unwrap_or_else(|| number.to_string())
    })
}
