//! What reading a case needs to know and what it makes: the model, and where its parts stand in the text.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use tresca_io::located::{SourceText, Span};
use tresca_io::mesh::MeshFile;
use tresca_model::{Model, ModelError};

use crate::analysis::Analysis;
use crate::error::{CaseError, FaultKind, fault_in, semantic};
use crate::origins::Origins;
use crate::text::at::At;

/// Longest name of anything, in bytes: names become parts of names of files.
const MAX_NAME: usize = 64;

/// Fills a model, table by table. Every noun of the case language adds its own way of reading to this.
pub(crate) struct Reader<'a> {
    pub source: &'a SourceText,
    pub analysis: Analysis,
    /// Where the analysis stands, if it does.
    pub analysis_span: Option<Span>,
    /// The mesh files that were read, by path: several bodies may come out of one.
    pub mesh_files: HashMap<PathBuf, Rc<MeshFile>>,
    pub model: Model,
    pub origins: Origins,
}

impl Reader<'_> {
    pub fn fault(
        &self,
        kind: FaultKind,
        span: Span,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> CaseError {
        fault_in(kind, self.source, span, message, label)
    }

    /// What the model refuses, at the table that says it.
    pub fn refused(&self, span: &Span, error: ModelError) -> CaseError {
        semantic(self.source, span.clone(), error.to_string(), "here", "")
    }

    /// The name of a support, load, contact or step.
    pub fn checked_name(&self, name: Option<At<String>>) -> Result<Option<At<String>>, CaseError> {
        if let Some(name) = &name
            && let Some(label) = fault_of_name(name)
        {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    name.span(),
                    "this cannot be a name",
                    label,
                )
                .with_help("names are written as in `left_end` or `step-2`"));
        }
        Ok(name)
    }

    /// A path of the case file; one that does not start at the root counts from its directory.
    pub fn beside(&self, name: &str) -> PathBuf {
        let directory = Path::new(self.source.name()).parent();
        directory.unwrap_or(Path::new("")).join(name)
    }
}

/// What keeps a text from being a name.
pub(crate) fn fault_of_name(text: &str) -> Option<String> {
    let allowed = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    if text.is_empty() {
        Some("expected a name, found an empty text".to_owned())
    } else if let Some(bad) = text.chars().find(|&c| !allowed(c)) {
        Some(format!(
            "expected letters, digits, `_` and `-`, found `{}`",
            bad.escape_default()
        ))
    } else if text.len() > MAX_NAME {
        Some(format!(
            "expected at most {MAX_NAME} bytes, found {}",
            text.len()
        ))
    } else {
        None
    }
}
