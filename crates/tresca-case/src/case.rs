//! From a case file to a model; errors of the model point back into the file.

use std::path::Path;

use tresca_model::{Model, Subject};
use tresca_qcqp::{QcqpError, Settings};

use crate::build::build;
use crate::error::CaseError;
use crate::source::Span;
use crate::{CaseFile, Mesh};

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
        Self::from_file(crate::read(path)?)
    }

    /// Reads a case from its text; `name` is what error messages call it.
    ///
    /// # Errors
    /// As [`Case::load`].
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::from_file(crate::parse(name, text)?)
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
                Mesh::File(file) => Some((body, file)),
                Mesh::Brick(_) | Mesh::Rectangle(_) => None,
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

    /// A report of a fault that was found after reading, at the place that `subject` comes from.
    pub fn fault(
        &self,
        subject: Subject,
        fact: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> CaseError {
        let span = match subject {
            Subject::Body(body) => self.file.bodies[body].name.span(),
            Subject::Contact(contact) => self.file.contacts[self.tables[contact.0]].span.clone(),
            Subject::Load(load) => load_span(&self.file, load.0),
            _ => 0..0,
        };
        CaseError::semantic(&self.file.source, span, fact.into(), label, help)
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

/// Where a load of the model stands in the file: the order is that of `build`.
fn load_span(file: &CaseFile<Settings>, load: usize) -> Span {
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
