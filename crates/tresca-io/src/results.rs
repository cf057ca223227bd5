//! The fields of a solved case and the names they get in the `.vtu` files: the one place for both.

use std::io::Write;

use tresca_fem::mesh::Mesh;

use crate::WriteError;
use crate::vtu::{CellShape, Cells, Fact, Field, Grid, Values};

/// The result of one body, on its nodes.
#[derive(Clone, Debug)]
pub struct BodyFields<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Displacement, interleaved by node, clamped nodes included: xyz, or xy in the plane.
    pub displacement: &'a [f64],
    /// Stress averaged to the nodes: xx, yy, zz, xy, yz, xz.
    pub stress: &'a [[f64; 6]],
    /// Von Mises stress of the same.
    pub von_mises: &'a [f64],
    /// Further fields on the nodes, written behind the others.
    pub extra: Vec<Field<'a>>,
    /// Facts about the run.
    pub facts: Vec<(String, Fact)>,
}

impl BodyFields<'_> {
    /// Writes the body's `.vtu`.
    ///
    /// # Errors
    /// As [`Grid::write`].
    pub fn write(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        let mut grid = Grid::of_mesh(self.mesh);
        // VTK knows vectors of three components only, also in the plane.
        let plane = self.displacement.len() == 2 * grid.points.len();
        let padded: Vec<[f64; 3]> = match plane {
            true => self
                .displacement
                .chunks_exact(2)
                .map(|u| [u[0], u[1], 0.0])
                .collect(),
            false => Vec::new(),
        };
        let displacement = match plane {
            true => Values::Vectors(&padded),
            false => Values::Interleaved(self.displacement),
        };
        grid.point_fields = vec![
            Field::new("displacement", displacement),
            Field::new("stress", Values::Tensors(self.stress)),
            Field::new("von_mises_stress", Values::Scalars(self.von_mises)),
        ];
        grid.point_fields.extend(&self.extra);
        grid.facts = self.facts.clone();
        grid.write(out)
    }
}

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
    /// Whether the point carries a normal force.
    pub closed: &'a [bool],
    /// Whether the tangential force is below the slip bound. With Tresca's law an open point may
    /// stick or slip, too.
    pub sticking: &'a [bool],
    /// Numbers of the friction laws, positions in `law_names`; the field
    /// `friction_law`, with a fact that says what the numbers mean. `None` leaves both out.
    pub friction_law: Option<&'a [u8]>,
    /// What the numbers of the friction laws mean.
    pub law_names: &'a [&'a str],
    /// Further fields on the points, written behind the others.
    pub extra: Vec<Field<'a>>,
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
            Field::new("pair", Values::Integers(self.pair)),
            Field::new("normal", Values::Vectors(self.normal)),
            Field::new("normal_force", Values::Scalars(self.normal_force)),
            Field::new("contact_pressure", Values::Scalars(self.contact_pressure)),
            Field::new("tangential_force", Values::Vectors(self.tangential_force)),
            Field::new(
                "tangential_traction",
                Values::Vectors(self.tangential_traction),
            ),
            Field::new("slip_bound", Values::Scalars(self.slip_bound)),
            Field::new("gap", Values::Scalars(self.gap)),
            Field::new("slip", Values::Vectors(self.slip)),
            Field::new("closed", Values::States(&closed)),
            Field::new("sticking", Values::States(&sticking)),
            Field::new("status", Values::States(&status)),
        ];
        grid.facts = self.facts.clone();
        if let Some(laws) = self.friction_law {
            grid.point_fields
                .push(Field::new("friction_law", Values::States(laws)));
            let numbered = self
                .law_names
                .iter()
                .enumerate()
                .map(|(i, law)| format!("{i} {law}"));
            let meaning = numbered.collect::<Vec<_>>().join(", ");
            grid.facts
                .push(("friction_law".to_owned(), Fact::Text(meaning)));
        }
        grid.point_fields.extend(&self.extra);
        grid.write(out)
    }
}
