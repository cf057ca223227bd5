//! The result on the slave points of all contacts.

use std::io::Write;

use super::names;
use crate::error::WriteError;
use crate::vtu::{CellShape, Cells, Fact, Field, Grid, Values};

/// What a contact point does, in one word; written as the field `status`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum ContactState {
    /// No normal force.
    Open = 0,
    /// The tangential force is below the bound; no slip.
    Stick = 1,
    /// The tangential force is at the bound.
    Slip = 2,
}

impl ContactState {
    /// Of an open point nothing more is said than that.
    pub fn new(closed: bool, sticking: bool) -> Self {
        match (closed, sticking) {
            (false, _) => ContactState::Open,
            (true, true) => ContactState::Stick,
            (true, false) => ContactState::Slip,
        }
    }
}

/// The result on the slave points of all contact pairs of a case, one value per point.
#[derive(Clone, Debug)]
pub struct ContactFields<'a> {
    /// Undeformed positions of the slave points.
    pub points: &'a [[f64; 3]],
    /// Faces between the points, in the plane lines; where there are none, every point becomes a
    /// vertex.
    pub faces: Vec<Cells<'a>>,
    /// Number of the contact pair in the case file, from 0.
    pub pair: &'a [i32],
    /// Unit normal, from the slave outwards.
    pub normal: &'a [[f64; 3]],
    /// Force along the normal, positive in compression.
    pub normal_force: &'a [f64],
    /// The same per area.
    pub contact_pressure: &'a [f64],
    /// Force in the tangential plane, in the directions of the axes.
    pub tangential_force: &'a [[f64; 3]],
    /// The same per area.
    pub tangential_traction: &'a [[f64; 3]],
    /// Largest tangential force that the law allows.
    pub slip_bound: &'a [f64],
    /// Distance along the normal after deformation; 0 when closed.
    pub gap: &'a [f64],
    /// Relative tangential displacement, slave minus master, in the directions of the axes.
    pub slip: &'a [[f64; 3]],
    /// The same since the step before: what friction acts on.
    pub slip_increment: &'a [[f64; 3]],
    /// Whether the point carries a normal force.
    pub closed: &'a [bool],
    /// Whether the tangential force is below the slip bound. With Tresca's law an open point may
    /// stick or slip, too.
    pub sticking: &'a [bool],
    /// Numbers of the friction laws: positions in `law_names`.
    pub friction_law: &'a [u8],
    /// What the numbers of the friction laws mean; a fact of the file says so.
    pub law_names: &'a [&'a str],
    /// Facts about the run.
    pub facts: Vec<(String, Fact)>,
}

impl ContactFields<'_> {
    /// Writes `contact.vtu`.
    ///
    /// # Errors
    /// As [`Grid::write`].
    pub fn write(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        let closed: Vec<u8> = self.closed.iter().copied().map(u8::from).collect();
        let sticking: Vec<u8> = self.sticking.iter().copied().map(u8::from).collect();
        let states = self.closed.iter().zip(self.sticking);
        let status: Vec<u8> = states
            .map(|(&closed, &sticking)| ContactState::new(closed, sticking) as u8)
            .collect();
        let vertices: Vec<usize> = (0..self.points.len()).collect();
        let mut grid = Grid::new(self.points);
        grid.cells = self.faces.clone();
        if grid.cells.is_empty() {
            grid.cells.push(Cells {
                shape: CellShape::Vertex,
                connectivity: &vertices,
            });
        }
        grid.point_fields = vec![
            Field::new(names::PAIR, Values::Integers(self.pair)),
            Field::new(names::NORMAL, Values::Vectors(self.normal)),
            Field::new(names::NORMAL_FORCE, Values::Scalars(self.normal_force)),
            Field::new(
                names::CONTACT_PRESSURE,
                Values::Scalars(self.contact_pressure),
            ),
            Field::new(
                names::TANGENTIAL_FORCE,
                Values::Vectors(self.tangential_force),
            ),
            Field::new(
                names::TANGENTIAL_TRACTION,
                Values::Vectors(self.tangential_traction),
            ),
            Field::new(names::SLIP_BOUND, Values::Scalars(self.slip_bound)),
            Field::new(names::GAP, Values::Scalars(self.gap)),
            Field::new(names::SLIP, Values::Vectors(self.slip)),
            Field::new(names::SLIP_INCREMENT, Values::Vectors(self.slip_increment)),
            Field::new(names::CLOSED, Values::States(&closed)),
            Field::new(names::STICKING, Values::States(&sticking)),
            Field::new(names::STATUS, Values::States(&status)),
            Field::new(names::FRICTION_LAW, Values::States(self.friction_law)),
        ];
        let numbered = self.law_names.iter().enumerate();
        let meaning: Vec<_> = numbered.map(|(i, law)| format!("{i} {law}")).collect();
        grid.facts = self.facts.clone();
        grid.facts.push((
            names::FRICTION_LAW.to_owned(),
            Fact::Text(meaning.join(", ")),
        ));
        grid.write(out)
    }
}
