//! Sets of nodes and elements.

use super::super::error::{MeshFault, MeshFileError};
use super::deck::{Keyword, same_name, unquoted};
use super::part::{Model, Space};
use crate::names::{listed, nearest};

/// What a set is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    Nodes,
    Elements,
}

impl Sort {
    fn word(self) -> &'static str {
        match self {
            Sort::Nodes => "node",
            Sort::Elements => "element",
        }
    }

    fn find(self, space: &Space, number: u64) -> Option<usize> {
        match self {
            Sort::Nodes => space.node(number),
            Sort::Elements => space.element(number),
        }
    }

    fn sets(self, space: &Space) -> &std::collections::HashMap<String, Vec<usize>> {
        match self {
            Sort::Nodes => &space.node_sets,
            Sort::Elements => &space.element_sets,
        }
    }
}

impl Model {
    /// Reads `*NSET` and `*ELSET` among the keywords of a space.
    pub fn read_sets(
        &mut self,
        space: usize,
        keywords: &[&Keyword<'_>],
    ) -> Result<(), MeshFileError> {
        for keyword in keywords {
            let sort = match keyword.name.as_str() {
                "NSET" => Sort::Nodes,
                "ELSET" => Sort::Elements,
                _ => continue,
            };
            let name = keyword.required(&keyword.name)?;
            let members = self.members(space, keyword, sort)?;
            match sort {
                Sort::Nodes => self.group(name, 0).nodes.extend(&members),
                Sort::Elements => self.group_of_cells(name, &members),
            }
            let sets = match sort {
                Sort::Nodes => &mut self.spaces[space].node_sets,
                Sort::Elements => &mut self.spaces[space].element_sets,
            };
            // A set that is given again grows.
            sets.entry(name.to_uppercase()).or_default().extend(members);
        }
        Ok(())
    }

    fn members(
        &self,
        space: usize,
        keyword: &Keyword<'_>,
        sort: Sort,
    ) -> Result<Vec<usize>, MeshFileError> {
        let space = match keyword.parameter("INSTANCE") {
            Some(name) => self.instance(keyword, keyword.line, name)?,
            None => space,
        };
        if keyword.parameter("GENERATE").is_some() {
            return self.generated(space, keyword, sort);
        }
        let mut members = Vec::new();
        if sort == Sort::Nodes
            && let Some(elements) = keyword.parameter("ELSET")
        {
            let cells = self.resolve(space, keyword, keyword.line, elements, Sort::Elements)?;
            members.extend(cells.iter().flat_map(|&cell| self.cells.nodes(cell)));
        }
        for (line, entry) in keyword.entries() {
            members.extend(self.resolve(space, keyword, line, entry, sort)?);
        }
        Ok(members)
    }

    /// The numbers of a space, with their points or cells.
    fn numbers(&self, space: usize, sort: Sort) -> Box<dyn Iterator<Item = (u64, usize)> + '_> {
        let of = &self.spaces[space];
        match sort {
            Sort::Nodes => Box::new(of.points.clone().map(|i| (self.point_numbers[i], i))),
            Sort::Elements => Box::new(of.cells.clone().map(|i| (self.cells.number(i), i))),
        }
    }

    /// First, last and increment on each line. Numbers in between that do not exist are no fault: the
    /// range is not walked through, it may be all numbers there are.
    fn generated(
        &self,
        space: usize,
        keyword: &Keyword<'_>,
        sort: Sort,
    ) -> Result<Vec<usize>, MeshFileError> {
        let mut members = Vec::new();
        for &(line, text) in &keyword.data {
            let numbers = text
                .split(',')
                .map(str::trim)
                .filter(|entry| !entry.is_empty())
                .map(|entry| keyword.number(line, entry, "first, last and increment"))
                .collect::<Result<Vec<_>, _>>()?;
            let (first, last, increment) = match numbers[..] {
                [first, last] => (first, last, 1),
                [first, last, increment] if increment > 0 => (first, last, increment),
                _ => {
                    return Err(MeshFault::syntax(
                        keyword.place(line),
                        "first, last and increment (1 or more)",
                        format!("`{text}`"),
                    ));
                }
            };
            let wanted = |number: u64| {
                (first..=last).contains(&number) && (number - first).is_multiple_of(increment)
            };
            members.extend(
                self.numbers(space, sort)
                    .filter(|(n, _)| wanted(*n))
                    .map(|(_, i)| i),
            );
        }
        Ok(members)
    }

    /// The members that an entry stands for: a number, the name of a set, or either of an instance,
    /// as in `Part-1-1.Top`.
    pub(super) fn resolve(
        &self,
        space: usize,
        keyword: &Keyword<'_>,
        line: usize,
        entry: &str,
        sort: Sort,
    ) -> Result<Vec<usize>, MeshFileError> {
        let (space, entry) = match entry.split_once('.') {
            Some((instance, rest)) if self.find_instance(unquoted(instance)).is_some() => {
                (self.instance(keyword, line, unquoted(instance))?, rest)
            }
            _ => (space, entry),
        };
        let of = &self.spaces[space];
        let word = sort.word();
        if let Ok(number) = entry.parse::<u64>() {
            return match sort.find(of, number) {
                Some(member) => Ok(vec![member]),
                None => Err(MeshFault::syntax(
                    keyword.place(line),
                    format!("the number of a {word}"),
                    format!("{number}, which no {word} has"),
                )),
            };
        }
        let name = unquoted(entry);
        let sets = sort.sets(of);
        if let Some(members) = sets.get(&name.to_uppercase()) {
            return Ok(members.clone());
        }
        let mut known: Vec<&str> = sets.keys().map(String::as_str).collect();
        known.sort_unstable();
        let error = MeshFault::syntax(
            keyword.place(line),
            format!("a number or the name of a set of {word}s"),
            format!("`{name}`, which is not the name of such a set"),
        );
        Err(match nearest(&name.to_uppercase(), known.iter().copied()) {
            Some(near) => error.with_help(format!("did you mean `{near}`?")),
            None => error.with_help(format!("the sets of {word}s so far are {}", listed(&known))),
        })
    }

    fn find_instance(&self, name: &str) -> Option<usize> {
        self.spaces
            .iter()
            .position(|space| !space.name.is_empty() && same_name(&space.name, name))
    }

    fn instance(
        &self,
        keyword: &Keyword<'_>,
        line: usize,
        name: &str,
    ) -> Result<usize, MeshFileError> {
        self.find_instance(name).ok_or_else(|| {
            let known: Vec<&str> = self.spaces.iter().map(|s| s.name.as_str()).collect();
            MeshFault::syntax(
                keyword.place(line),
                "the name of an instance",
                format!("`{name}`"),
            )
            .with_help(format!("the instances are {}", listed(&known)))
        })
    }
}
