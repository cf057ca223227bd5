//! From a case file to a model; errors of the model point back into the file.

mod build;

use std::path::Path;

use tresca_contact::ContactError;
use tresca_io::case::{self, CaseError, CaseFile};
use tresca_qcqp::{QcqpError, Settings};

use crate::ModelError;
use crate::model::Model;
use build::build;

/// A case file, read and checked, with the model it describes.
#[derive(Debug)]
pub struct Case {
    file: CaseFile<Settings>,
    /// The `[[contact]]` table of each contact of the model.
    tables: Vec<usize>,
    /// The model.
    pub model: Model,
}

impl Case {
    /// Reads a case file.
    ///
    /// # Errors
    /// Everything that is wrong with the file, at its line and column.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, CaseError> {
        Self::from_file(case::read(path)?)
    }

    /// Reads a case from its text; `name` is what error messages call it.
    ///
    /// # Errors
    /// As [`Case::load`].
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::from_file(case::parse(name, text)?)
    }

    /// The solver settings of the case file.
    pub fn settings(&self) -> &Settings {
        &self.file.solver
    }

    /// What reading the meshes of the case found that may be a mistake, body by body.
    pub fn notes(&self) -> Vec<String> {
        let bodies = self.file.bodies.iter();
        bodies
            .filter_map(|body| match body.mesh.get_ref() {
                case::Mesh::File(file) => Some((body, file)),
                case::Mesh::Brick(_) | case::Mesh::Rectangle(_) => None,
            })
            .flat_map(|(body, file)| {
                let name = body.name.get_ref();
                let notes = file.body.notes.iter();
                notes.map(move |note| format!("body `{name}`: {note}"))
            })
            .collect()
    }

    fn from_file(file: CaseFile<Settings>) -> Result<Self, CaseError> {
        if let Err(error) = file.solver.validate() {
            return Err(setting_error(&file, &error));
        }
        let (model, tables) = build(&file)?;
        Ok(Self {
            file,
            tables,
            model,
        })
    }

    /// Points an error of the model at the place in the case file that it speaks of.
    pub fn locate(&self, error: &ModelError) -> CaseError {
        locate(&self.file, &self.tables, error)
    }
}

fn setting_error(file: &CaseFile<Settings>, error: &QcqpError) -> CaseError {
    let (name, allowed) = match error {
        QcqpError::Setting { name, allowed, .. } => (*name, allowed.as_str()),
        _ => ("", ""),
    };
    let span = file
        .source
        .locate(&format!("solver.{name}"))
        .unwrap_or(0..0);
    CaseError::semantic(
        &file.source,
        span,
        error.to_string(),
        format!("expected {allowed}"),
        "`tresca options` lists every setting with its default and its range",
    )
}

fn locate(file: &CaseFile<Settings>, tables: &[usize], error: &ModelError) -> CaseError {
    let body_name = |name: &str| {
        file.bodies
            .iter()
            .find(|body| body.name.get_ref() == name)
            .map_or(0..0, |body| body.name.span())
    };
    let (span, label, help) = match error {
        ModelError::Floating { body, .. } => (
            body_name(body),
            "nothing holds this body".to_owned(),
            format!(
                "clamp a surface of it, for example `on = [\"{body}.x-\"]` in a [[clamp]] table, or let it \
                 touch another body in a [[contact]]"
            ),
        ),
        ModelError::Coupling {
            contact, source, ..
        } => {
            let (label, help) = coupling_hints(source);
            (
                file.contacts[tables[*contact]].span.clone(),
                label.to_owned(),
                help.to_owned(),
            )
        }
        ModelError::NonFiniteLoad { load, .. } => (
            load_span(file, *load),
            "its value is not a number everywhere".to_owned(),
            "an expression such as sqrt(x) or 1/x has no value at some points of the surface"
                .to_owned(),
        ),
        ModelError::NoContact => (
            0..0,
            "no [[contact]] table in this file".to_owned(),
            "add a [[contact]] with `pair` and `friction`".to_owned(),
        ),
        ModelError::Body { body, .. }
        | ModelError::Factorization { body, .. }
        | ModelError::DuplicateBody { name: body } => {
            (body_name(body), "this body".to_owned(), String::new())
        }
        _ => (0..0, "in this file".to_owned(), String::new()),
    };
    CaseError::semantic(&file.source, span, error.to_string(), label, help)
}

/// What to say beside the error of a contact's geometry or law.
fn coupling_hints(source: &ContactError) -> (&'static str, &'static str) {
    match source {
        ContactError::NodeCounts { .. }
        | ContactError::NoPartner { .. }
        | ContactError::SharedPartner { .. } => (
            "the nodes of the two surfaces must lie on one another",
            "give both surfaces the same nodes, or leave `coupling` out: surfaces that are meshed apart are \
             coupled by mortar",
        ),
        ContactError::SlipBound { .. } => (
            "its slip bound is impossible somewhere on the slave surface",
            "a bound is a number ≥ 0; an expression can be kept from going below by max(0, …)",
        ),
        ContactError::Axis { .. } => (
            "its axis is along the contact normal somewhere",
            "the axis of an orthotropic law is projected on the tangent plane of every contact point",
        ),
        _ => ("this contact", ""),
    }
}

/// Where a load of the model stands in the file: the order is that of `build`.
fn load_span(file: &CaseFile<Settings>, load: usize) -> case::Span {
    let tractions = file.tractions.iter().map(|item| &item.span);
    let pressures = file.pressures.iter().map(|item| &item.span);
    let body_forces = file.body_forces.iter().map(|item| &item.span);
    let gravities = file.gravities.iter().map(|item| &item.span);
    let mut all = tractions
        .chain(pressures)
        .chain(body_forces)
        .chain(gravities);
    all.nth(load).cloned().unwrap_or(0..0)
}
