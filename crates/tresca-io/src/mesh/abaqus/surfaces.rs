//! Surfaces made of sides of elements, of shell-like elements, or of nodes.

use super::super::error::{MeshFault, MeshFileError};
use super::super::faces::FaceMap;
use super::super::file::note_skipped;
use super::deck::Keyword;
use super::kinds::{faces, local_face};
use super::part::Model;
use super::sets::Sort;

impl Model {
    /// Reads `*SURFACE` among the keywords of a space.
    pub fn read_surfaces(
        &mut self,
        space: usize,
        keywords: &[&Keyword<'_>],
    ) -> Result<(), MeshFileError> {
        for keyword in keywords.iter().filter(|keyword| keyword.name == "SURFACE") {
            let name = keyword.required("NAME")?;
            let sort = keyword
                .parameter("TYPE")
                .unwrap_or("ELEMENT")
                .to_uppercase();
            match sort.as_str() {
                "ELEMENT" => self.surface_of_elements(space, keyword, name)?,
                "NODE" => self.surface_of_nodes(space, keyword, name)?,
                _ => note_skipped(&mut self.skipped, format!("*SURFACE, TYPE={sort}")),
            }
        }
        Ok(())
    }

    /// Each line: a node or a set of nodes, perhaps with an area.
    fn surface_of_nodes(
        &mut self,
        space: usize,
        keyword: &Keyword<'_>,
        name: &str,
    ) -> Result<(), MeshFileError> {
        for &(line, text) in &keyword.data {
            let entry = text.split(',').next().unwrap_or_default().trim();
            let nodes = self.resolve(space, keyword, line, entry, Sort::Nodes)?;
            self.group(name, 0).nodes.extend(nodes);
        }
        Ok(())
    }

    /// Each line: an element or a set of elements, and which of their sides.
    fn surface_of_elements(
        &mut self,
        space: usize,
        keyword: &Keyword<'_>,
        name: &str,
    ) -> Result<(), MeshFileError> {
        for &(line, text) in &keyword.data {
            let mut entries = text.split(',').map(str::trim);
            let entry = entries.next().unwrap_or_default();
            let side = entries.next().unwrap_or_default().to_uppercase();
            let cells = self.resolve(space, keyword, line, entry, Sort::Elements)?;
            match side.as_str() {
                // The two sides of shells, membranes and rigid elements.
                "SPOS" | "SNEG" => self.group_of_cells(name, &cells),
                "" => self.free_surface(name, &cells),
                _ => {
                    for cell in cells {
                        self.side_of_element(keyword, line, name, (cell, &side))?;
                    }
                }
            }
        }
        Ok(())
    }

    fn side_of_element(
        &mut self,
        keyword: &Keyword<'_>,
        line: usize,
        name: &str,
        (cell, side): (usize, &str),
    ) -> Result<(), MeshFileError> {
        let kind = self.cells.kind(cell);
        let number = side.strip_prefix('S').and_then(|n| n.parse().ok());
        let Some(local) = number.and_then(|number| local_face(kind, number)) else {
            return Err(MeshFault::syntax(
                keyword.place(line),
                format!("a side of a {kind}, S1 to S{}", faces(kind).len()),
                format!("`{side}`"),
            ));
        };
        let group = self.group(name, kind.dimension() - 1);
        group.faces.push([cell, local]);
        Ok(())
    }

    /// Without a side: of solids the sides on the outside of the mesh, of others themselves.
    fn free_surface(&mut self, name: &str, cells: &[usize]) {
        let highest = cells.iter().map(|&c| self.cells.kind(c).dimension()).max();
        // Plane elements are solids where there are no others.
        let solid = (0..self.cells.len())
            .map(|c| self.cells.kind(c).dimension())
            .max();
        let Some(dimension) = highest.filter(|_| highest == solid) else {
            return self.group_of_cells(name, cells);
        };
        let mut wanted = vec![false; self.cells.len()];
        for &cell in cells {
            wanted[cell] = true;
        }
        let map = FaceMap::new(&self.cells, dimension);
        let exterior = map.exterior().into_iter().filter(|side| wanted[side[0]]);
        self.group(name, dimension - 1).faces.extend(exterior);
    }
}
