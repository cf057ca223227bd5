//! What can be wrong with a case file, told with the place, what was expected and the likely cause.

use std::error::Error;
use std::fmt;
use std::io;

use tresca_io::located::{Fault, FilePlace, Located, SourceText, Span};

/// Why a case file was refused, and where. Renders as a [`miette`] report.
pub type CaseError = Located<CaseFault>;

/// Why a case file was refused.
#[derive(Debug)]
#[non_exhaustive]
pub struct CaseFault {
    /// The sort of fault.
    pub kind: FaultKind,
    /// What is wrong, in a sentence.
    pub message: String,
    /// What the operating system says, where the message does not say it all.
    pub system: Option<io::Error>,
}

/// The sorts of faults in a case file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FaultKind {
    /// The file could not be read: missing, a directory, no permission.
    Unreadable,
    /// The file holds bytes that are no UTF-8 text.
    NotText,
    /// Not TOML.
    Syntax,
    /// A key that does not belong here.
    UnknownKey,
    /// A key that must be there and is not.
    MissingKey,
    /// A value of the wrong type: text for a number, a list of the wrong length.
    WrongType,
    /// A value of the right type outside what is possible.
    BadValue,
    /// A name that nothing answers to.
    BadReference,
    /// The same thing said twice.
    Duplicate,
    /// A file that the case file names cannot be used.
    BadFile,
    /// Refused by a later check, which knows more than the text; see [`Case::fault`](crate::Case::fault).
    Semantic,
}

impl FaultKind {
    fn code(self) -> &'static str {
        match self {
            FaultKind::Unreadable => "case::unreadable",
            FaultKind::NotText => "case::not_text",
            FaultKind::Syntax => "case::syntax",
            FaultKind::UnknownKey => "case::unknown_key",
            FaultKind::MissingKey => "case::missing_key",
            FaultKind::WrongType => "case::wrong_type",
            FaultKind::BadValue => "case::bad_value",
            FaultKind::BadReference => "case::bad_reference",
            FaultKind::Duplicate => "case::duplicate",
            FaultKind::BadFile => "case::bad_file",
            FaultKind::Semantic => "case::semantic",
        }
    }
}

impl Fault for CaseFault {
    fn code(&self) -> &'static str {
        self.kind.code()
    }

    fn tell(&self, _: &FilePlace, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }

    fn cause(&self) -> Option<&(dyn Error + 'static)> {
        let error = self.system.as_ref()?;
        Some(error)
    }
}

impl CaseFault {
    pub(crate) fn new(kind: FaultKind, message: impl Into<String>) -> Self {
        Self {
            kind,
            message: message.into(),
            system: None,
        }
    }
}

/// A fault of the text: what is wrong (`message`), and what the marked text is or should have been (`label`).
pub(crate) fn fault_in(
    kind: FaultKind,
    source: &SourceText,
    span: Span,
    message: impl Into<String>,
    label: impl Into<String>,
) -> CaseError {
    Located::in_text(CaseFault::new(kind, message), source, span, label)
}

/// A fault found by whoever knows the meaning; with the likely cause or cure (`help`).
pub(crate) fn semantic(
    source: &SourceText,
    span: Span,
    message: impl Into<String>,
    label: impl Into<String>,
    help: impl Into<String>,
) -> CaseError {
    fault_in(FaultKind::Semantic, source, span, message, label).with_help(help)
}
