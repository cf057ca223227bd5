//! What can be wrong with a case file, told with the place, what was expected and the likely cause.

use std::fmt;
use std::io;
use std::path::PathBuf;

use miette::{Diagnostic, LabeledSpan, SourceCode};

use crate::source::{CaseSource, Span};

/// Why a case file was refused. Renders as a [`miette`] report.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum CaseError {
    /// The file could not be read: missing, a directory, no permission.
    #[error("cannot read the case file `{}`: {reason}", path.display())]
    #[diagnostic(code(case::unreadable))]
    Unreadable {
        /// The path as it was given.
        path: PathBuf,
        /// What stood in the way, in words.
        reason: &'static str,
        /// The likely cause.
        #[help]
        help: Option<String>,
        /// What the operating system says, where the reason does not say it all.
        #[source]
        source: Option<io::Error>,
    },

    /// The file holds bytes that are no UTF-8 text.
    #[error(
        "the case file `{}` is not UTF-8 text: line {line}, column {column} holds the byte 0x{byte:02x}",
        path.display()
    )]
    #[diagnostic(
        code(case::not_text),
        help("save the file as UTF-8; a case file is plain text in the TOML format")
    )]
    NotText {
        /// The path as it was given.
        path: PathBuf,
        /// Line of the first bad byte, from 1.
        line: usize,
        /// Column of the first bad byte, from 1, in characters.
        column: usize,
        /// The first bad byte.
        byte: u8,
    },

    /// The text is wrong at a place that can be shown.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Fault(Box<Fault>),
}

impl CaseError {
    /// An error found after the file was read, by whoever knows the meaning: say what is wrong
    /// (`message`), what the marked text is or should have been (`label`), and the likely cause or
    /// cure (`help`).
    pub fn semantic(
        source: &CaseSource,
        span: Span,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        Fault::new(FaultKind::Semantic, source, span, message, label)
            .with_help(help)
            .into()
    }

    /// Marks a second place in the same report, such as the other member of a pair. Nothing happens
    /// to errors that have no place.
    pub fn and_at(mut self, span: Span, label: impl Into<String>) -> Self {
        if let CaseError::Fault(fault) = &mut self {
            fault.mark(span, label);
        }
        self
    }

    /// Line and column, from 1, of the place the error points at.
    pub fn line_column(&self) -> Option<(usize, usize)> {
        match self {
            CaseError::Unreadable { .. } => None,
            CaseError::NotText { line, column, .. } => Some((*line, *column)),
            CaseError::Fault(fault) => Some(fault.source.line_column(fault.span().start)),
        }
    }
}

impl From<Fault> for CaseError {
    fn from(fault: Fault) -> Self {
        CaseError::Fault(Box::new(fault))
    }
}

/// The sorts of faults in a case file's text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
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
    /// Refused by a later check, which knows more than the text; see [`CaseError::semantic`].
    Semantic,
}

impl FaultKind {
    fn code(self) -> &'static str {
        match self {
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

/// A fault with its place in the text.
#[derive(Debug, Clone)]
pub struct Fault {
    kind: FaultKind,
    message: String,
    /// The first is the place itself.
    labels: Vec<(Span, String)>,
    help: Option<String>,
    source: CaseSource,
}

impl Fault {
    pub(crate) fn new(
        kind: FaultKind,
        source: &CaseSource,
        span: Span,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> Self {
        let mut fault = Self {
            kind,
            message: message.into(),
            labels: Vec::new(),
            help: None,
            source: source.clone(),
        };
        fault.mark(span, label);
        fault
    }

    pub(crate) fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    pub(crate) fn and_at(mut self, span: Span, label: impl Into<String>) -> Self {
        self.mark(span, label);
        self
    }

    fn mark(&mut self, span: Span, label: impl Into<String>) {
        self.labels.push((self.source.clip(span), label.into()));
    }

    /// The sort of fault.
    pub fn kind(&self) -> FaultKind {
        self.kind
    }

    /// The bytes of the case file that the fault is about.
    pub fn span(&self) -> Span {
        self.labels[0].0.clone()
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}

impl Diagnostic for Fault {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.kind.code()))
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help
            .as_ref()
            .map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.source)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().enumerate().map(
            |(i, (span, label))| {
                let (label, range) = (Some(label.clone()), span.clone());
                if i == 0 {
                    LabeledSpan::new_primary_with_span(label, range)
                } else {
                    LabeledSpan::new_with_span(label, range)
                }
            },
        )))
    }
}
