//! What is wrong in a file, told with its place: one type of error for meshes, problems and case files.
//!
//! A family of files has its own type of faults (a [`Fault`]); a [`Located`] is one of them with the place, a second place
//! that has to do with it, the likely cause or cure, and the text around where there is one. It renders as a [`miette`]
//! report.

use std::error::Error;
use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use miette::{
    Diagnostic, LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents,
};

/// A range of bytes in a text.
pub type Span = Range<usize>;

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilePlace {
    /// The file.
    pub path: PathBuf,
    /// Where in it.
    pub position: Position,
}

/// Where in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Position {
    /// The file as a whole.
    File,
    /// A line of text, from 1.
    Line(usize),
    /// A line and a column of text, from 1; columns count characters.
    LineColumn(usize, usize),
    /// A byte of a binary part, from 0.
    Byte(usize),
    /// A dataset, an array or a group, by its name.
    Part(String),
}

impl<P: Into<PathBuf>> From<P> for FilePlace {
    fn from(path: P) -> Self {
        let path = path.into();
        let position = Position::File;
        Self { path, position }
    }
}

impl fmt::Display for FilePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display();
        match &self.position {
            Position::File => write!(f, "{path}"),
            Position::Line(line) => write!(f, "{path}:{line}"),
            Position::LineColumn(line, column) => write!(f, "{path}:{line}:{column}"),
            Position::Byte(byte) => write!(f, "{path}, byte {byte}"),
            Position::Part(name) => write!(f, "{path}, `{name}`"),
        }
    }
}

/// What can be wrong in a family of files.
pub trait Fault: fmt::Debug + Send + Sync + 'static {
    /// A word for the sort of fault, such as `mesh::syntax`.
    fn code(&self) -> &'static str;

    /// Says what is wrong, and where, in one sentence: what was expected and what is there.
    ///
    /// # Errors
    /// Those of the formatter.
    fn tell(&self, place: &FilePlace, f: &mut fmt::Formatter<'_>) -> fmt::Result;

    /// The likely cause or cure, where it goes with every such fault.
    fn help(&self) -> Option<String> {
        None
    }

    /// An error of a lower layer that it comes from.
    fn cause(&self) -> Option<&(dyn Error + 'static)> {
        None
    }
}

/// A fault with its place.
#[derive(Debug)]
pub struct Located<F>(Box<Parts<F>>);

#[derive(Debug)]
struct Parts<F> {
    fault: F,
    place: FilePlace,
    help: Option<String>,
    /// The text around, with what to say about parts of it; the first is the place itself.
    text: Option<SourceText>,
    labels: Vec<(Span, String)>,
}

impl<F> Located<F> {
    /// A fault in a file that is not shown.
    pub fn new(fault: F, place: impl Into<FilePlace>) -> Self {
        Self(Box::new(Parts {
            fault,
            place: place.into(),
            help: None,
            text: None,
            labels: Vec::new(),
        }))
    }

    /// A fault in a text that is shown; `label` is what the marked part is or should have been.
    pub fn in_text(fault: F, text: &SourceText, span: Span, label: impl Into<String>) -> Self {
        let (line, column) = text.line_column(span.start);
        let place = FilePlace {
            path: text.name().into(),
            position: Position::LineColumn(line, column),
        };
        let mut located = Self::new(fault, place);
        located.0.text = Some(text.clone());
        located.and_at(span, label)
    }

    /// With the likely cause or cure.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.0.help = Some(help.into());
        self
    }

    /// Marks one more part of the text, such as the other member of a pair. Nothing happens where no text is shown.
    #[must_use]
    pub fn and_at(mut self, span: Span, label: impl Into<String>) -> Self {
        if let Some(text) = &self.0.text {
            let span = text.clip(span);
            self.0.labels.push((span, label.into()));
        }
        self
    }

    /// What is wrong.
    pub fn fault(&self) -> &F {
        &self.0.fault
    }

    /// Where.
    pub fn place(&self) -> &FilePlace {
        &self.0.place
    }

    /// The bytes of the text that it is about, where a text is shown.
    pub fn span(&self) -> Option<Span> {
        self.0.labels.first().map(|(span, _)| span.clone())
    }

    /// Line and column, from 1, where the file is text.
    pub fn line_column(&self) -> Option<(usize, usize)> {
        match self.0.place.position {
            Position::LineColumn(line, column) => Some((line, column)),
            Position::Line(line) => Some((line, 1)),
            _ => None,
        }
    }
}

impl<F: Fault> fmt::Display for Located<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fault.tell(&self.0.place, f)
    }
}

impl<F: Fault> Error for Located<F> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        self.0.fault.cause()
    }
}

impl<F: Fault> Diagnostic for Located<F> {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.0.fault.code()))
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        let help = self.0.help.clone().or_else(|| self.0.fault.help());
        help.map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.0.text.as_ref().map(|text| text as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let text = self.0.text.is_some();
        text.then(|| Box::new(self.labeled_spans()) as Box<dyn Iterator<Item = LabeledSpan>>)
    }
}

impl<F> Located<F> {
    fn labeled_spans(&self) -> impl Iterator<Item = LabeledSpan> {
        let labels = self.0.labels.iter().enumerate();
        labels.map(|(i, (span, label))| {
            let (label, range) = (Some(label.clone()), span.clone());
            match i {
                0 => LabeledSpan::new_primary_with_span(label, range),
                _ => LabeledSpan::new_with_span(label, range),
            }
        })
    }
}

/// Name and text of a file: what reports quote from. Cheap to clone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceText {
    name: Arc<str>,
    text: Arc<str>,
}

impl SourceText {
    /// `name` is what reports show, usually the path as the user gave it.
    pub fn new(name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> Self {
        Self {
            name: name.into(),
            text: text.into(),
        }
    }

    /// The name shown in reports.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The directory that relative paths in the text count from.
    pub fn directory(&self) -> &Path {
        Path::new(self.name()).parent().unwrap_or(Path::new(""))
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Line and column of a byte offset, both counted from 1; the column counts characters.
    /// Offsets beyond the end are taken as the end.
    pub fn line_column(&self, offset: usize) -> (usize, usize) {
        let before = &self.text[..self.floor(offset)];
        let line = before.matches('\n').count() + 1;
        let start = before.rfind('\n').map_or(0, |newline| newline + 1);
        (line, before[start..].chars().count() + 1)
    }

    /// The same range with both ends inside the text and between characters.
    pub fn clip(&self, span: Span) -> Span {
        let start = self.floor(span.start);
        start..self.floor(span.end).max(start)
    }

    /// The text that a span covers.
    pub fn slice(&self, span: Span) -> &str {
        &self.text[self.clip(span)]
    }

    fn floor(&self, offset: usize) -> usize {
        let mut offset = offset.min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        offset
    }
}

impl SourceCode for SourceText {
    /// As for plain text, but with the file's name, and with columns that count characters: the
    /// text's own implementation counts bytes, which is wrong behind the first umlaut.
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        context_lines_before: usize,
        context_lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let contents = self
            .text
            .read_span(span, context_lines_before, context_lines_after)?;
        let start = contents.span().offset();
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.to_string(),
            contents.data(),
            *contents.span(),
            contents.line(),
            self.line_column(start).1 - 1,
            contents.line_count(),
        )))
    }
}
