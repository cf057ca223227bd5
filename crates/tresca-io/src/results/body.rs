//! The result of one body, on its nodes.

use std::io::Write;

use tresca_fem::mesh::Mesh;

use super::names;
use crate::error::WriteError;
use crate::vtu::{Fact, Field, Grid, Values};

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
    /// What the supports put on the nodes.
    pub reaction: Option<&'a [[f64; 3]]>,
    /// What contacts do at the nodes; of bodies that one reaches.
    pub surface: Option<NodeContactFields<'a>>,
    /// A motion that nothing resists.
    pub unresisted_motion: Option<&'a [[f64; 3]]>,
    /// Facts about the run.
    pub facts: Vec<(String, Fact)>,
}

/// What contacts do at the nodes of a body, one value per node.
#[derive(Clone, Copy, Debug)]
pub struct NodeContactFields<'a> {
    /// Contact force on the body, all contacts together.
    pub force: &'a [[f64; 3]],
    /// Contact pressure, positive in compression.
    pub pressure: &'a [f64],
    /// Tangential traction on the body.
    pub traction: &'a [[f64; 3]],
    /// Gap left.
    pub gap: &'a [f64],
    /// 0 no contact point, 1 open, 2 sticking, 3 slipping.
    pub status: &'a [u8],
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
            Field::new(names::DISPLACEMENT, displacement),
            Field::new(names::STRESS, Values::Tensors(self.stress)),
            Field::new(names::VON_MISES_STRESS, Values::Scalars(self.von_mises)),
        ];
        if let Some(reaction) = self.reaction {
            grid.point_fields
                .push(Field::new(names::REACTION, Values::Vectors(reaction)));
        }
        if let Some(surface) = &self.surface {
            grid.point_fields.extend([
                Field::new(names::CONTACT_FORCE, Values::Vectors(surface.force)),
                Field::new(names::CONTACT_PRESSURE, Values::Scalars(surface.pressure)),
                Field::new(names::CONTACT_TRACTION, Values::Vectors(surface.traction)),
                Field::new(names::CONTACT_GAP, Values::Scalars(surface.gap)),
                Field::new(names::CONTACT_STATUS, Values::States(surface.status)),
            ]);
        }
        if let Some(motion) = self.unresisted_motion {
            grid.point_fields.push(Field::new(
                names::UNRESISTED_MOTION,
                Values::Vectors(motion),
            ));
        }
        grid.facts = self.facts.clone();
        grid.write(out)
    }
}
