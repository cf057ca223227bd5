//! A case: the model of a text, the solver's settings, and the text itself for reports.

use std::io;
use std::path::Path;

use serde::de::DeserializeOwned;
use tresca_model::{Model, Subject};
use tresca_qcqp::{QcqpError, Settings};

use crate::error::CaseError;
use crate::file;
use crate::origins::Origins;
use crate::source::CaseSource;

/// A case file, read and checked. `S` holds the solver's settings: with a type other than [`Settings`] it should refuse
/// unknown keys (`#[serde(deny_unknown_fields)]`), which are then reported like all others.
#[derive(Debug)]
#[non_exhaustive]
pub struct Case<S = Settings> {
    /// The model.
    pub model: Model,
    /// The `[solver]` table; `S::default()` without one.
    pub solver: S,
    /// Name and text, for reports of later checks.
    pub source: CaseSource,
    origins: Origins,
}

impl Case {
    /// Reads a case file.
    ///
    /// # Errors
    /// Everything that is wrong with the file, at its line and column.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, CaseError> {
        Self::load_with(path)?.with_possible_settings()
    }

    /// Reads a case from its text; `name` is what error messages call it. Files that the text refers to are read, and
    /// count from the directory of `name`.
    ///
    /// # Errors
    /// As [`Case::load`], without those of reading the case file itself.
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::parse_with(name, text)?.with_possible_settings()
    }

    /// The solver settings of the case file.
    pub fn settings(&self) -> &Settings {
        &self.solver
    }

    fn with_possible_settings(self) -> Result<Self, CaseError> {
        match self.solver.validate() {
            Ok(()) => Ok(self),
            Err(error) => Err(self.setting_fault(&error)),
        }
    }

    fn setting_fault(&self, error: &QcqpError) -> CaseError {
        let (name, allowed) = match error {
            QcqpError::Setting { name, allowed, .. } => (*name, allowed.as_str()),
            _ => ("", ""),
        };
        let span = self.source.locate(&format!("solver.{name}"));
        CaseError::semantic(
            &self.source,
            span.unwrap_or(0..0),
            error.to_string(),
            format!("expected {allowed}"),
            "`tresca options` lists every setting with its default and its range",
        )
    }
}

impl<S: DeserializeOwned + Default> Case<S> {
    /// As [`Case::load`], with settings of any type, of which the shape alone is checked.
    ///
    /// # Errors
    /// As [`Case::load`].
    pub fn load_with(path: impl AsRef<Path>) -> Result<Self, CaseError> {
        let path = path.as_ref();
        let bytes = std::fs::read(path).map_err(|error| unreadable(path, error))?;
        let text = String::from_utf8(bytes).map_err(|error| not_text(path, &error))?;
        Self::parse_with(&path.display().to_string(), &text)
    }

    /// As [`Case::parse`], with settings of any type, of which the shape alone is checked.
    ///
    /// # Errors
    /// As [`Case::parse`].
    pub fn parse_with(name: &str, text: &str) -> Result<Self, CaseError> {
        let source = CaseSource::new(name, text);
        let (model, origins, solver) = file::read(&source)?;
        Ok(Self {
            model,
            solver,
            source,
            origins,
        })
    }
}

impl<S> Case<S> {
    /// What reading the meshes of the case found that may be a mistake, body by body.
    pub fn notes(&self) -> Vec<String> {
        let bodies = self.origins.bodies.iter();
        bodies.flat_map(|body| body.notes.clone()).collect()
    }

    /// A report of a fault that was found after reading, at the place that `subject` comes from.
    pub fn fault(
        &self,
        subject: Subject,
        fact: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> CaseError {
        let span = self.origins.place(subject);
        CaseError::semantic(&self.source, span, fact.into(), label, help)
    }
}

fn unreadable(path: &Path, error: io::Error) -> CaseError {
    let (reason, help, source) = if path.is_dir() {
        let help = "name the case file inside it, such as `case.toml`";
        ("it is a directory", Some(help.to_owned()), None)
    } else if error.kind() == io::ErrorKind::NotFound {
        ("there is no such file", Some(missing_file(path)), None)
    } else {
        ("the system refuses", None, Some(error))
    };
    CaseError::Unreadable {
        path: path.to_owned(),
        reason,
        help,
        source,
    }
}

/// The likely cause of a missing file: another name in the same directory, or a missing directory.
fn missing_file(path: &Path) -> String {
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let Ok(entries) = std::fs::read_dir(directory) else {
        return format!("there is no directory `{}` either", directory.display());
    };
    let names: Vec<String> = entries
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name.ends_with(".toml"))
        .collect();
    let wanted = path.file_name().unwrap_or_default().to_string_lossy();
    match tresca_io::names::nearest(&wanted, names.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{}`?", path.with_file_name(near).display()),
        None => {
            "a path that does not start at the root counts from the current directory".to_owned()
        }
    }
}

fn not_text(path: &Path, error: &std::string::FromUtf8Error) -> CaseError {
    let bad = error.utf8_error().valid_up_to();
    let good = String::from_utf8_lossy(&error.as_bytes()[..bad]).into_owned();
    let (line, column) = CaseSource::new("", good).line_column(bad);
    CaseError::NotText {
        path: path.to_owned(),
        line,
        column,
        byte: error.as_bytes()[bad],
    }
}
