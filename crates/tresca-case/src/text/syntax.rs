//! Text that is no TOML.

use toml::de::{DeTable, Error};
use tresca_io::located::{SourceText, Span};

use crate::error::{CaseError, FaultKind, fault_in};

/// The report. What the parser says is shown, never interpreted: its words may change.
pub(super) fn report(source: &SourceText, error: &Error) -> CaseError {
    let span = source.clip(error.span().unwrap_or(0..0));
    if is_second_key(source, &span) {
        let message = "the same key or table stands here a second time";
        return fault_in(
            FaultKind::Duplicate,
            source,
            span,
            message,
            "already given above",
        )
        .with_help(
            "a key is given once per table; entries of a list of tables each start with double \
                 brackets, as in `[[body]]`",
        );
    }
    let (label, help) = match follows_decimal_comma(source, &span) {
        true => (
            "unexpected behind a comma between digits",
            "decimals are written with a point, as in 0.277",
        ),
        false => (
            error.message(),
            "keys are written `key = value`, texts stand in \"quotes\", lists in [brackets] and inline \
             tables in {braces}, each closed; see https://toml.io",
        ),
    };
    let message = "the case file is not valid TOML";
    fault_in(FaultKind::Syntax, source, span, message, label).with_help(help)
}

/// Whether a key of another name would be in order at this place: then the key is right, and there are two of it.
fn is_second_key(source: &SourceText, span: &Span) -> bool {
    let text = source.text();
    let key = source.slice(span.clone());
    if key.trim().is_empty() || DeTable::parse(&format!("{key} = 0")).is_err() {
        return false;
    }
    let mut other = "other".to_owned();
    while text.contains(&other) {
        other.push('_');
    }
    let renamed = format!("{}{other}{}", &text[..span.start], &text[span.end..]);
    match DeTable::parse(&renamed) {
        Ok(_) => true,
        Err(next) => next
            .span()
            .is_some_and(|next| next.start > span.start + other.len()),
    }
}

/// Whether the text before the fault ends with a number like `0,277`: the reader takes what stands
/// behind the comma for a key, and stumbles at its end.
fn follows_decimal_comma(source: &SourceText, span: &Span) -> bool {
    let before = source.slice(0..span.start).trim_end();
    let decimals = before.trim_end_matches(|c: char| c.is_ascii_digit());
    decimals.len() < before.len()
        && decimals
            .strip_suffix(',')
            .is_some_and(|whole| whole.ends_with(|c: char| c.is_ascii_digit()))
}
