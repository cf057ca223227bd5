//! Where the parts of a model stand in a case file.

use std::collections::BTreeMap;

use tresca_io::located::Span;
use tresca_io::mesh::MeshFileError;
use tresca_model::{Quantity, Subject};

use crate::text::at::At;

/// Where the parts of a model stand in the text, for reports of later checks.
#[derive(Debug, Default)]
pub(crate) struct Origins {
    /// The place of each part; of a body its name, of everything else its table.
    pub places: BTreeMap<Subject, Span>,
    /// In the order of the model.
    pub bodies: Vec<BodyOrigin>,
    /// What load steps may name, in the order of the documentation.
    pub names: Vec<NamedTable>,
    /// Names of the obstacles, in the order of the model.
    pub obstacles: Vec<At<String>>,
}

/// What the report of a fault says about a body.
#[derive(Debug)]
pub(crate) struct BodyOrigin {
    pub name: At<String>,
    /// Where its material stands.
    pub material: Span,
    /// What its mesh is called, with an article.
    pub mesh: String,
    /// Names of its faces, and of its sets of nodes, those of the faces among them.
    pub faces: Vec<String>,
    pub node_sets: Vec<String>,
    /// Names that its file has for surfaces that cannot be used, with the reason.
    pub unusable: BTreeMap<String, MeshFileError>,
    /// What may be a mistake in its mesh.
    pub notes: Vec<String>,
}

/// A table that load steps may name.
#[derive(Debug)]
pub(crate) struct NamedTable {
    pub name: At<String>,
    /// What the table made; several contacts where surfaces are paired by distance.
    pub made: Vec<Quantity>,
}

impl Origins {
    /// Notes where a table stands, and how steps call what it made.
    pub fn note(&mut self, span: &Span, name: Option<At<String>>, made: Vec<Quantity>) {
        for &quantity in &made {
            self.places.insert(quantity.into(), span.clone());
        }
        self.names
            .extend(name.map(|name| NamedTable { name, made }));
    }

    pub fn place(&self, subject: impl Into<Subject>) -> Span {
        let place = self.places.get(&subject.into());
        place.cloned().unwrap_or(0..0)
    }

    pub fn body_names(&self) -> Vec<&str> {
        self.bodies.iter().map(|body| body.name.as_str()).collect()
    }
}
