//! A case: the model of a text, the solver's settings, and the text itself for reports.

use std::io;
use std::path::Path;

use serde::de::DeserializeOwned;
use tresca_io::located::{FilePlace, Position, SourceText, Span};
use tresca_model::{Model, Subject};
use tresca_qcqp::{QcqpError, Settings};

use crate::error::{CaseError, CaseFault, FaultKind, semantic};
use crate::file;
use crate::locate::locate;
use crate::origins::Origins;

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
    pub source: SourceText,
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
        let span = self.locate(&format!("solver.{name}"));
        semantic(
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
        let source = SourceText::new(name, text);
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

    /// Where the value of a key stands, for checks made after the file was read. Steps are joined by dots and list
    /// entries counted from 0: `solver.tolerance`, `body[1].material.young`. `None` when the text does not contain
    /// the key.
    pub fn locate(&self, key: &str) -> Option<Span> {
        locate(self.source.text(), key)
    }

    /// A report of a fault that was found after reading, at the place that `subject` comes from.
    pub fn fault(
        &self,
        subject: Subject,
        fact: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> CaseError {
        self.fault_at(self.origins.place(subject), fact, label, help)
    }

    /// The same at a place in the text: what is wrong, what the marked text is or should have been, and the likely
    /// cause or cure.
    pub fn fault_at(
        &self,
        span: Span,
        fact: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> CaseError {
        semantic(&self.source, span, fact, label, help)
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
    let name = path.display();
    let mut fault = CaseFault::new(
        FaultKind::Unreadable,
        format!("cannot read the case file `{name}`: {reason}"),
    );
    fault.system = source;
    let error = CaseError::new(fault, path);
    match help {
        Some(help) => error.with_help(help),
        None => error,
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
    let (line, column) = SourceText::new("", good).line_column(bad);
    let (name, byte) = (path.display(), error.as_bytes()[bad]);
    let message = format!(
        "the case file `{name}` is not UTF-8 text: line {line}, column {column} holds the byte 0x{byte:02x}"
    );
    let place = FilePlace {
        path: path.to_owned(),
        position: Position::LineColumn(line, column),
    };
    CaseError::new(CaseFault::new(FaultKind::NotText, message), place)
        .with_help("save the file as UTF-8; a case file is plain text in the TOML format")
}
