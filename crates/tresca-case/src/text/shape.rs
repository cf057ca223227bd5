//! Text that is TOML, but not of the shape of a case file: what serde finds, and how it is told.

use std::fmt;

use serde::de;
use tresca_io::located::{SourceText, Span};
use tresca_io::names::{listed, nearest};

use crate::error::{CaseError, FaultKind, fault_in};

/// What does not fit, with its place as soon as that is known.
#[derive(Debug)]
pub(super) struct ShapeError {
    shape: Shape,
    span: Option<Span>,
}

#[derive(Debug)]
enum Shape {
    UnknownKey(String, &'static [&'static str]),
    UnknownWord(String, &'static [&'static str]),
    MissingKey(&'static str),
    WrongType(Expected, Found),
    /// The entries expected and found.
    WrongLength(String, usize),
    Other(String),
}

/// What should stand at a place.
#[derive(Debug)]
pub(super) enum Expected {
    Number,
    /// A whole number from 0.
    Count,
    Whole,
    Bool,
    Text,
    /// One of several words.
    Word,
    List,
    /// The table of a key.
    Table(String),
    /// In the words of whoever reads the value.
    Said(String),
}

/// What stands there.
#[derive(Debug)]
enum Found {
    Text,
    Whole,
    Float,
    Bool,
    List,
    Table,
    Other,
}

impl ShapeError {
    fn new(shape: Shape) -> Self {
        Self { shape, span: None }
    }

    pub fn wrong_type(expected: Expected, found: de::Unexpected<'_>) -> Self {
        let found = match found {
            de::Unexpected::Str(_) => Found::Text,
            de::Unexpected::Signed(_) | de::Unexpected::Unsigned(_) => Found::Whole,
            de::Unexpected::Float(_) => Found::Float,
            de::Unexpected::Bool(_) => Found::Bool,
            de::Unexpected::Seq => Found::List,
            de::Unexpected::Map => Found::Table,
            _ => Found::Other,
        };
        Self::new(Shape::WrongType(expected, found))
    }

    /// At this place, if none is known yet.
    pub fn or_at(mut self, span: &Span) -> Self {
        self.span.get_or_insert_with(|| span.clone());
        self
    }
}

impl de::Error for ShapeError {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self::new(Shape::Other(message.to_string()))
    }

    fn invalid_type(found: de::Unexpected<'_>, expected: &dyn de::Expected) -> Self {
        Self::wrong_type(Expected::Said(expected.to_string()), found)
    }

    fn invalid_value(found: de::Unexpected<'_>, expected: &dyn de::Expected) -> Self {
        Self::invalid_type(found, expected)
    }

    fn invalid_length(found: usize, expected: &dyn de::Expected) -> Self {
        Self::new(Shape::WrongLength(expected.to_string(), found))
    }

    fn unknown_variant(found: &str, allowed: &'static [&'static str]) -> Self {
        Self::new(Shape::UnknownWord(found.to_owned(), allowed))
    }

    fn unknown_field(found: &str, allowed: &'static [&'static str]) -> Self {
        Self::new(Shape::UnknownKey(found.to_owned(), allowed))
    }

    fn missing_field(key: &'static str) -> Self {
        Self::new(Shape::MissingKey(key))
    }
}

impl fmt::Display for ShapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.shape)
    }
}

impl std::error::Error for ShapeError {}

/// The report.
pub(super) fn report(source: &SourceText, error: ShapeError) -> CaseError {
    let span = source.clip(error.span.unwrap_or(0..0));
    let fault =
        |kind, message: String, label: String| fault_in(kind, source, span.clone(), message, label);
    match error.shape {
        Shape::UnknownKey(found, allowed) => {
            let label = match nearest(&found, allowed.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => "not a key of this table".to_owned(),
            };
            let message = format!("unknown key `{found}`");
            fault(FaultKind::UnknownKey, message, label).with_help(match allowed {
                [] => "no keys belong here".to_owned(),
                [only] => format!("the only key that belongs here is `{only}`"),
                _ => format!("the keys that belong here are {}", listed(allowed)),
            })
        }
        Shape::UnknownWord(found, allowed) => {
            let message = format!("`{found}` is not among the choices here");
            unsupported(source, span.clone(), message, &found, allowed)
        }
        Shape::MissingKey(key) => {
            let message = format!("missing key `{key}`");
            let label = format!("expected `{key}` in this table");
            fault(FaultKind::MissingKey, message, label)
                .with_help("the tables and their keys are listed in docs/case-file.md")
        }
        Shape::WrongType(expected, found) => {
            let text = source.slice(span.clone());
            let help = help_with_type(&expected, &found, text);
            let message = format!("expected {}", expected.in_words());
            let fault = fault(FaultKind::WrongType, message, found.in_words(text));
            match help {
                Some(help) => fault.with_help(help),
                None => fault,
            }
        }
        Shape::WrongLength(expected, found) => fault(
            FaultKind::WrongType,
            "a list of the wrong length".to_owned(),
            format!("expected {expected}, found {found} entries"),
        ),
        Shape::Other(message) => {
            let fact = "this value cannot be used".to_owned();
            fault(FaultKind::BadValue, fact, message)
        }
    }
}

impl Expected {
    fn in_words(&self) -> String {
        match self {
            Expected::Number => "a number".to_owned(),
            Expected::Count => "a whole number, 0 or more".to_owned(),
            Expected::Whole => "a whole number".to_owned(),
            Expected::Bool => "true or false".to_owned(),
            Expected::Text | Expected::Word => "a text in quotes".to_owned(),
            Expected::List => "a list".to_owned(),
            Expected::Table(key) => format!("a table of keys for `{key}`"),
            Expected::Said(words) => words.clone(),
        }
    }
}

impl Found {
    /// `text` is what stands in the file.
    fn in_words(&self, text: &str) -> String {
        match self {
            Found::Text => format!("found the text {text}"),
            Found::Whole | Found::Float => format!("found the number {text}"),
            Found::Bool | Found::Other => format!("found {text}"),
            Found::List => "found a list".to_owned(),
            Found::Table => "found a table".to_owned(),
        }
    }
}

fn help_with_type(expected: &Expected, found: &Found, text: &str) -> Option<String> {
    let quoted = text.trim_matches(|c| c == '"' || c == '\'');
    Some(match (expected, found) {
        (Expected::List, Found::Table) => {
            "entries of this kind start with double brackets, as in `[[body]]`".to_owned()
        }
        (Expected::List, Found::Text) => {
            format!("a list has brackets, also with one entry: [{text}]")
        }
        (Expected::Table(_), Found::List) => {
            "a table has braces and names its values: { key = value, … }".to_owned()
        }
        (Expected::Said(words), Found::Text) if words.contains("{ file = ") => {
            format!("a file is given in a table: {{ file = {text} }}")
        }
        (Expected::Number | Expected::Count | Expected::Whole, Found::Text) => {
            match quoted.parse::<f64>() {
                Ok(_) => format!("numbers stand without quotes: {quoted}"),
                Err(_) => "numbers are written as in 0.3, 16 or 5.0e4".to_owned(),
            }
        }
        (Expected::Count | Expected::Whole, Found::Float) => {
            "counts are written without decimal point or exponent".to_owned()
        }
        _ => return None,
    })
}

/// A word that is none of those `allowed`.
pub(crate) fn unsupported(
    source: &SourceText,
    span: Span,
    message: impl Into<String>,
    found: &str,
    allowed: &[&str],
) -> CaseError {
    let label = match (nearest(found, allowed.iter().copied()), allowed) {
        (Some(near), _) => format!("did you mean `{near}`?"),
        (None, [only]) => format!("expected `{only}`"),
        (None, _) => format!("expected one of {}", listed(allowed)),
    };
    fault_in(FaultKind::BadValue, source, span, message, label)
        .with_help(format!("supported: {}", listed(allowed)))
}
