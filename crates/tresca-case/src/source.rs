//! The text of a case file together with its name: what error reports quote from.

use std::ops::Range;
use std::sync::Arc;

use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A range of bytes in the case file.
pub type Span = Range<usize>;

/// Name and text of a case file. Cheap to clone; every [`CaseError`](super::CaseError) that points
/// at a place carries one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CaseSource {
    name: Arc<str>,
    text: Arc<str>,
}

impl CaseSource {
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

    /// Where the value of a key stands, for checks made after the file was read. Steps are joined by
    /// dots and list entries counted from 0: `solver.tolerance`, `body[1].material.young`.
    /// `None` when the file does not contain the key.
    pub fn locate(&self, path: &str) -> Option<Span> {
        let root = DeTable::parse(&self.text).ok()?;
        let mut steps = path.split('.');
        let mut at = step_into(root.get_ref(), steps.next()?)?;
        for step in steps {
            at = step_into(at.get_ref().as_table()?, step)?;
        }
        Some(at.span())
    }

    /// The same range with both ends inside the text and between characters.
    pub(crate) fn clip(&self, span: Span) -> Span {
        let start = self.floor(span.start);
        start..self.floor(span.end).max(start)
    }

    /// The text that a span covers.
    pub(crate) fn slice(&self, span: Span) -> &str {
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

/// One step of [`CaseSource::locate`]: `key` or `key[index]`.
fn step_into<'t, 'i>(table: &'t DeTable<'i>, step: &str) -> Option<&'t Spanned<DeValue<'i>>> {
    let (key, index) = match step.split_once('[') {
        None => (step, None),
        Some((key, rest)) => (key, Some(rest.strip_suffix(']')?.parse::<usize>().ok()?)),
    };
    let value = table.get(key)?;
    match index {
        None => Some(value),
        Some(index) => value.get_ref().as_array()?.get(index),
    }
}

impl SourceCode for CaseSource {
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
