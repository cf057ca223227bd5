//! Nodes and elements of a deck.

use std::collections::HashMap;
use std::ops::Range;

use super::super::cells::FileCells;
use super::super::error::{MeshFault, MeshFileError};
use super::super::file::{Group, Groups};
use super::super::numbering::Numbering;
use super::super::order::{from_abaqus, reorder};
use super::super::placement::Placement;
use super::deck::Keyword;
use super::kinds::kind;

/// The mesh of a deck while it is read.
#[derive(Debug, Default)]
pub(super) struct Model {
    pub points: Vec<[f64; 3]>,
    pub point_numbers: Vec<u64>,
    pub cells: FileCells,
    pub groups: Groups,
    pub spaces: Vec<Space>,
    /// The space that each entity, an `*ELEMENT` line, belongs to.
    pub space_of_entity: Vec<usize>,
    pub skipped: Vec<String>,
    /// Names of sets and surfaces as they stand where they come first, by the name in capitals.
    spelled: HashMap<String, String>,
}

/// A space of numbers and names: an instance of a part, the assembly, or a deck without parts.
#[derive(Debug)]
pub(super) struct Space {
    /// Of the instance; empty for a deck without parts and for the assembly.
    pub name: String,
    nodes: Numbering,
    /// Its points among all.
    pub points: Range<usize>,
    elements: Numbering,
    /// Its cells among all.
    pub cells: Range<usize>,
    /// Points by name of the set, in capitals.
    pub node_sets: HashMap<String, Vec<usize>>,
    /// Cells by name of the set, in capitals.
    pub element_sets: HashMap<String, Vec<usize>>,
}

impl Space {
    /// The point of a node.
    pub fn node(&self, number: u64) -> Option<usize> {
        self.nodes.find(number).map(|i| self.points.start + i)
    }

    /// The cell of an element.
    pub fn element(&self, number: u64) -> Option<usize> {
        self.elements.find(number).map(|i| self.cells.start + i)
    }
}

impl Model {
    /// Reads nodes and elements of a space, and the sets that are given along with them.
    pub fn add_space(
        &mut self,
        name: &str,
        keywords: &[&Keyword<'_>],
        placement: &Placement,
    ) -> Result<(), MeshFileError> {
        let (first_node, first_cell) = (self.points.len(), self.cells.len());
        let mut node_sets: HashMap<String, Vec<usize>> = HashMap::new();
        for keyword in keywords.iter().filter(|keyword| keyword.name == "NODE") {
            let first = self.points.len();
            self.read_nodes(keyword, placement)?;
            if let Some(set) = keyword.parameter("NSET") {
                let all = first..self.points.len();
                self.group(set, 0).nodes.extend(all.clone());
                node_sets.entry(set.to_uppercase()).or_default().extend(all);
            }
        }
        let nodes = numbering(&self.point_numbers[first_node..], "node", keywords)?;
        let mut space = Space {
            name: name.to_owned(),
            nodes,
            points: first_node..self.points.len(),
            elements: Numbering::default(),
            cells: first_cell..first_cell,
            node_sets,
            element_sets: HashMap::new(),
        };
        for keyword in keywords.iter().filter(|keyword| keyword.name == "ELEMENT") {
            let first = self.cells.len();
            self.read_elements(keyword, &space)?;
            if let Some(set) = keyword.parameter("ELSET") {
                let all: Vec<usize> = (first..self.cells.len()).collect();
                self.group_of_cells(set, &all);
                let known = space.element_sets.entry(set.to_uppercase()).or_default();
                known.extend(all);
            }
        }
        space.cells.end = self.cells.len();
        let numbers: Vec<u64> = space
            .cells
            .clone()
            .map(|cell| self.cells.number(cell))
            .collect();
        space.elements = numbering(&numbers, "element", keywords)?;
        self.spaces.push(space);
        Ok(())
    }

    /// The group of a name, whatever the case of its letters, and dimension.
    pub fn group(&mut self, name: &str, dimension: usize) -> &mut Group {
        let spelled = self.spelled.entry(name.to_uppercase());
        let name = spelled.or_insert_with(|| name.to_owned());
        self.groups.of(name, dimension)
    }

    /// Files cells under a name, by their dimension.
    pub fn group_of_cells(&mut self, name: &str, cells: &[usize]) {
        for &cell in cells {
            let dimension = self.cells.kind(cell).dimension();
            self.group(name, dimension).cells.push(cell);
        }
    }

    /// Number, x, y, z; coordinates that are left out are 0, and what follows are normals.
    fn read_nodes(
        &mut self,
        keyword: &Keyword<'_>,
        placement: &Placement,
    ) -> Result<(), MeshFileError> {
        for &(line, text) in &keyword.data {
            let mut entries = text.split(',').map(str::trim);
            let number = entries.next().unwrap_or_default();
            let number = keyword.number(line, number, "the number of a node")?;
            let mut point = [0.0; 3];
            for (x, entry) in point.iter_mut().zip(entries) {
                if !entry.is_empty() {
                    *x = keyword.real(line, entry, "a coordinate")?;
                }
            }
            if !point.iter().all(|x| x.is_finite()) {
                return Err(MeshFault::NotFinite {
                    node: number,
                    point,
                }
                .at(keyword.place(line)));
            }
            self.points.push(placement.apply(point));
            self.point_numbers.push(number);
        }
        Ok(())
    }

    /// Number, then the nodes, on as many lines as they need.
    fn read_elements(&mut self, keyword: &Keyword<'_>, space: &Space) -> Result<(), MeshFileError> {
        let name = keyword.required("TYPE")?;
        let entity = self.space_of_entity.len() as u32;
        self.space_of_entity.push(self.spaces.len());
        let (mut nodes, mut scratch) = (Vec::new(), Vec::new());
        let mut entries = keyword.entries();
        while let Some((line, entry)) = entries.next() {
            let number = keyword.number(line, entry, "the number of an element")?;
            let place = || keyword.place(line);
            let Some(kind) = kind(name) else {
                return Err(MeshFault::ElementType {
                    element: number,
                    name: name.to_owned(),
                }
                .at(place()));
            };
            nodes.clear();
            for _ in 0..kind.node_count() {
                let Some((line, entry)) = entries.next() else {
                    return Err(MeshFault::syntax(
                        place(),
                        format!("{} nodes of element {number} ({name})", kind.node_count()),
                        nodes.len().to_string(),
                    ));
                };
                let node = keyword.number(line, entry, "a node of an element")?;
                let Some(index) = space.node(node) else {
                    return Err(MeshFault::UnknownNode {
                        element: number,
                        node,
                    }
                    .at(keyword.place(line)));
                };
                nodes.push(index);
            }
            reorder(from_abaqus(kind), &mut nodes, &mut scratch);
            self.cells.push(kind, &nodes, number, entity);
        }
        Ok(())
    }
}

fn numbering(
    numbers: &[u64],
    what: &'static str,
    keywords: &[&Keyword<'_>],
) -> Result<Numbering, MeshFileError> {
    Numbering::new(numbers).map_err(|i| {
        let number = numbers[i];
        let keyword_name = what.to_uppercase();
        let of_kind = keywords.iter().filter(|k| k.name == keyword_name);
        let starts =
            |text: &str| text.split(',').next().map(str::trim) == Some(&number.to_string());
        // The last line that begins with the number; of an element with several lines perhaps the
        // wrong one, but one that shows the number.
        let place = of_kind
            .flat_map(|k| k.data.iter().map(move |&(line, text)| (k, line, text)))
            .rfind(|(_, _, text)| starts(text))
            .map(|(keyword, line, _)| keyword.place(line));
        match place.or_else(|| keywords.first().map(|k| k.place(k.line))) {
            Some(place) => MeshFault::DuplicateNumber { what, number }.at(place),
            None => unreachable!("numbers come from keywords"),
        }
    })
}
