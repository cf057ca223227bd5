//! What a case says before it is solved.

use std::io::Write;

use tresca_fem::mesh::Mesh;

use super::names;
use crate::error::WriteError;
use crate::vtu::{CellShape, Cells, Fact, Field, Grid, Values};

/// What holds a body and what pulls at it, on its nodes.
#[derive(Clone, Debug)]
pub struct CheckedBody<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Components that supports hold, as bits: 1 x, 2 y, 4 z.
    pub held_components: &'a [u8],
    /// The load.
    pub load: &'a [[f64; 3]],
    /// Facts about the case.
    pub facts: Vec<(String, Fact)>,
}

impl CheckedBody<'_> {
    /// Writes the body's `.vtu`.
    ///
    /// # Errors
    /// As [`Grid::write`].
    pub fn write(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        let mut grid = Grid::of_mesh(self.mesh);
        grid.point_fields = vec![
            Field::new(names::HELD_COMPONENTS, Values::States(self.held_components)),
            Field::new(names::LOAD, Values::Vectors(self.load)),
        ];
        grid.facts = self.facts.clone();
        grid.write(out)
    }
}

/// The contact points of a case, one value per point.
#[derive(Clone, Copy, Debug)]
pub struct CheckedContact<'a> {
    /// Positions of the slave points.
    pub points: &'a [[f64; 3]],
    /// Number of the contact in the case, from 0.
    pub pair: &'a [i32],
    /// Unit normal, from the slave outwards.
    pub normal: &'a [[f64; 3]],
    /// Gap along the normal.
    pub gap: &'a [f64],
    /// Area that belongs to the point.
    pub area: &'a [f64],
}

impl CheckedContact<'_> {
    /// Writes `contact.vtu`, every point a vertex.
    ///
    /// # Errors
    /// As [`Grid::write`].
    pub fn write(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        let vertices: Vec<usize> = (0..self.points.len()).collect();
        let mut grid = Grid::new(self.points);
        grid.cells.push(Cells {
            shape: CellShape::Vertex,
            connectivity: &vertices,
        });
        grid.point_fields = vec![
            Field::new(names::PAIR, Values::Integers(self.pair)),
            Field::new(names::NORMAL, Values::Vectors(self.normal)),
            Field::new(names::GAP, Values::Scalars(self.gap)),
            Field::new(names::AREA, Values::Scalars(self.area)),
        ];
        grid.write(out)
    }
}
