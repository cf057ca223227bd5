//! From the messages of the TOML reader to ours: plain words, the keys that belong there, and what
//! was probably meant.
//!
//! The reader hands on serde's standard sentences ("unknown field `x`, expected one of …"), and
//! nothing more structured. They are taken apart here, in one place, and the tests hold every form.

use super::error::{CaseError, Fault, FaultKind};
use super::source::{CaseSource, Span};
use tresca_io::names::{listed, nearest};

/// The text is no TOML.
pub(super) fn syntax_error(source: &CaseSource, error: &toml::de::Error) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let message = error.message();
    if message == "duplicate key" {
        return Fault::new(
            FaultKind::Duplicate,
            source,
            span,
            "the same key or table stands here a second time",
            "already given above",
        )
        .with_help(
            "a key is given once per table; entries of a list of tables each start with double \
             brackets, as in `[[body]]`",
        )
        .into();
    }
    if follows_decimal_comma(source, &span) {
        return Fault::new(
            FaultKind::Syntax,
            source,
            span,
            "the case file is not valid TOML",
            "unexpected behind a comma between digits",
        )
        .with_help("decimals are written with a point, as in 0.277")
        .into();
    }
    Fault::new(
        FaultKind::Syntax,
        source,
        span,
        "the case file is not valid TOML",
        message,
    )
    .with_help(
        "keys are written `key = value`, texts stand in \"quotes\", lists in [brackets] and inline \
         tables in {braces}, each closed; see https://toml.io",
    )
    .into()
}

/// Whether the text before the fault ends with a number like `0,277`: the reader takes what stands
/// behind the comma for a key, and stumbles at its end.
fn follows_decimal_comma(source: &CaseSource, span: &Span) -> bool {
    let before = source.slice(0..span.start).trim_end();
    let decimals = before.trim_end_matches(|c: char| c.is_ascii_digit());
    decimals.len() < before.len()
        && decimals
            .strip_suffix(',')
            .is_some_and(|whole| whole.ends_with(|c: char| c.is_ascii_digit()))
}

/// The text is TOML, but not of the shape of a case file.
pub(super) fn shape_error(source: &CaseSource, error: &toml::de::Error) -> CaseError {
    let span = source.clip(error.span().unwrap_or(0..0));
    let message = error.message();
    if let Some(rest) = message.strip_prefix("unknown field ") {
        unknown_key(source, span, rest)
    } else if let Some(rest) = message.strip_prefix("unknown variant ") {
        unknown_choice(source, span, rest)
    } else if let Some(key) = message.strip_prefix("missing field ") {
        missing_key(source, span, key)
    } else if let Some((found, expected)) = ["invalid type: ", "invalid value: "]
        .iter()
        .find_map(|prefix| message.strip_prefix(prefix))
        .and_then(|rest| rest.rsplit_once(", expected "))
    {
        wrong_type(source, span, found, expected)
    } else if let Some((found, expected)) = message
        .strip_prefix("invalid length ")
        .and_then(|rest| rest.rsplit_once(", expected "))
    {
        Fault::new(
            FaultKind::WrongType,
            source,
            span,
            "a list of the wrong length",
            format!("expected {expected}, found {found} entries"),
        )
        .into()
    } else if message == "wanted string or table" {
        // A word of a choice, in the place of which something else stands.
        let found = source.slice(span.clone()).to_owned();
        Fault::new(
            FaultKind::WrongType,
            source,
            span,
            "expected a text in quotes",
            format!("found {found}"),
        )
        .into()
    } else if message.starts_with("wanted exactly 1 element") {
        Fault::new(
            FaultKind::WrongType,
            source,
            span,
            "one choice is wanted here",
            "expected exactly one key in this table",
        )
        .into()
    } else {
        Fault::new(
            FaultKind::BadValue,
            source,
            span,
            "this value cannot be used",
            message,
        )
        .into()
    }
}

fn unknown_key(source: &CaseSource, span: Span, rest: &str) -> CaseError {
    let allowed = choices(rest);
    let found = bare(source.slice(span.clone())).to_owned();
    let label = match nearest(&found, allowed.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "not a key of this table".to_owned(),
    };
    Fault::new(
        FaultKind::UnknownKey,
        source,
        span,
        format!("unknown key `{found}`"),
        label,
    )
    .with_help(match allowed.as_slice() {
        [] => "no keys belong here".to_owned(),
        [only] => format!("the only key that belongs here is `{only}`"),
        _ => format!("the keys that belong here are {}", listed(&allowed)),
    })
    .into()
}

fn unknown_choice(source: &CaseSource, span: Span, rest: &str) -> CaseError {
    let allowed = choices(rest);
    let found = bare(source.slice(span.clone())).to_owned();
    unsupported(
        FaultKind::BadValue,
        source,
        span,
        format!("`{found}` is not among the choices here"),
        &found,
        &allowed,
    )
    .into()
}

/// A word that is none of those `allowed`.
pub(super) fn unsupported(
    kind: FaultKind,
    source: &CaseSource,
    span: Span,
    message: impl Into<String>,
    found: &str,
    allowed: &[&str],
) -> Fault {
    let label = match (nearest(found, allowed.iter().copied()), allowed) {
        (Some(near), _) => format!("did you mean `{near}`?"),
        (None, [only]) => format!("expected `{only}`"),
        (None, _) => format!("expected one of {}", listed(allowed)),
    };
    Fault::new(kind, source, span, message, label)
        .with_help(format!("supported: {}", listed(allowed)))
}

fn missing_key(source: &CaseSource, span: Span, key: &str) -> CaseError {
    Fault::new(
        FaultKind::MissingKey,
        source,
        span,
        format!("missing key {key}"),
        format!("expected {key} in this table"),
    )
    .with_help("the tables and their keys are listed in docs/case-file.md")
    .into()
}

fn wrong_type(source: &CaseSource, span: Span, found: &str, expected: &str) -> CaseError {
    let text = source.slice(span.clone());
    let help = if found == "map" && expected == "a sequence" {
        Some("entries of this kind start with double brackets, as in `[[body]]`".to_owned())
    } else if found.starts_with("string") && expected == "a sequence" {
        Some(format!(
            "a list has brackets, also with one entry: [{text}]"
        ))
    } else if found.starts_with("string") && expected.contains("{ file = ") {
        Some(format!("a file is given in a table: {{ file = {text} }}"))
    } else if found.starts_with("string") && is_number(expected) {
        let inner = bare(text);
        Some(if inner.parse::<f64>().is_ok() {
            format!("numbers stand without quotes: {inner}")
        } else {
            "numbers are written as in 0.3, 16 or 5.0e4".to_owned()
        })
    } else if found.starts_with("floating point") && is_number(expected) {
        Some("counts are written without decimal point or exponent".to_owned())
    } else {
        None
    };
    let fault = Fault::new(
        FaultKind::WrongType,
        source,
        span,
        format!("expected {}", expected_in_words(expected)),
        format!("found {}", found_in_words(found, text)),
    );
    match help {
        Some(help) => fault.with_help(help),
        None => fault,
    }
    .into()
}

fn is_number(expected: &str) -> bool {
    matches!(
        expected,
        "f64" | "f32" | "usize" | "u64" | "u32" | "u16" | "u8" | "i64" | "i32"
    )
}

fn expected_in_words(expected: &str) -> &str {
    match expected {
        "f64" | "f32" => "a number",
        "usize" | "u64" | "u32" | "u16" | "u8" => "a whole number, 0 or more",
        "i64" | "i32" => "a whole number",
        "a string" => "a text in quotes",
        "a sequence" => "a list",
        "a boolean" => "true or false",
        other if other.starts_with("struct ") => "a table of keys",
        other => other,
    }
}

/// `found` is serde's word for it, `text` what stands in the file.
fn found_in_words(found: &str, text: &str) -> String {
    match found.split([' ', '(']).next() {
        Some("string") => format!("the text {text}"),
        Some("floating" | "integer") => format!("the number {text}"),
        Some("boolean") => text.to_owned(),
        Some("map") => "a table".to_owned(),
        Some("sequence") => "a list".to_owned(),
        _ => found.to_owned(),
    }
}

/// The names between backticks behind the last "expected": behind it, because a misspelt key may
/// itself contain anything.
fn choices(rest: &str) -> Vec<&str> {
    let allowed = rest.rsplit_once(", expected ").map_or("", |(_, list)| list);
    allowed.split('`').skip(1).step_by(2).collect()
}

/// A key or text without its quotes.
fn bare(text: &str) -> &str {
    text.trim_matches(|c| c == '"' || c == '\'')
}
