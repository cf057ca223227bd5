//! Quantities that may vary over a body or a surface: a number, a formula, or values from a file.

use std::fmt;
use std::sync::Arc;

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, MapAccess, Visitor};
use tresca_contact::ScalarField;
use tresca_io::located::Span;
use tresca_model::VectorField;

use crate::analysis::Analysis;
use crate::error::{CaseError, FaultKind};
use crate::expression::Expression;
use crate::expression::names::VARIABLES;
use crate::reader::Reader;
use crate::text::at::At;

/// A field over a body or surface, as it stands in the text.
#[derive(Clone, Debug)]
pub(crate) enum FieldKeys {
    /// The same everywhere.
    Number(f64),
    /// A formula.
    Text(String),
    /// A table of values in a file.
    File(At<String>),
}

/// `{ file = … }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ file = \"….csv\" }`")]
struct FileKeys {
    /// Path of the file, relative to the case file.
    file: At<String>,
}

impl<'de> Deserialize<'de> for FieldKeys {
    /// Not derived: an untagged enum forgets where its errors are.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FieldVisitor)
    }
}

struct FieldVisitor;

impl<'de> Visitor<'de> for FieldVisitor {
    type Value = FieldKeys;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or an expression in quotes")
    }

    fn visit_f64<E>(self, value: f64) -> Result<FieldKeys, E> {
        Ok(FieldKeys::Number(value))
    }

    fn visit_str<E>(self, text: &str) -> Result<FieldKeys, E> {
        Ok(FieldKeys::Text(text.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<FieldKeys, A::Error> {
        let keys = FileKeys::deserialize(MapAccessDeserializer::new(map))?;
        Ok(FieldKeys::File(keys.file))
    }
}

/// What values a field may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Any finite number; values from a file are not foreseen.
    Signed,
    /// 0 or more; values may come from a file.
    Bound,
}

impl Reader<'_> {
    /// `what` names the quantity, as in "the slip bound"; `help` says what it is.
    pub(crate) fn field(
        &self,
        what: &str,
        kind: Kind,
        keys: &At<FieldKeys>,
        help: &str,
    ) -> Result<ScalarField, CaseError> {
        let span = keys.span();
        let field = match &keys.value {
            FieldKeys::Number(value) => ScalarField::Constant(*value),
            FieldKeys::Text(text) => {
                let expression = self.expression(text, span.clone())?;
                match expression.constant() {
                    Some(value) if !value.is_finite() => {
                        return Err(self
                            .fault(
                                FaultKind::BadValue,
                                span,
                                format!("{what} is not a finite number"),
                                format!("the value of this expression is {value:?}"),
                            )
                            .with_help(
                                "this comes from a division by 0, or a function outside its domain",
                            ));
                    }
                    Some(value) => ScalarField::Constant(value),
                    None => ScalarField::Function(Arc::new(move |point| expression.at(point))),
                }
            }
            FieldKeys::File(_) if kind == Kind::Signed => {
                return Err(self
                    .fault(
                        FaultKind::WrongType,
                        span,
                        format!("{what} cannot come from a file"),
                        "expected a number, or an expression in quotes",
                    )
                    .with_help("slip bounds are the fields that may come from a file"));
            }
            FieldKeys::File(file) => {
                let table = self.value_table(what, file)?;
                ScalarField::Function(Arc::new(move |point| table.at(point)))
            }
        };
        if let ScalarField::Constant(value) = field {
            let number = At::new(span, value);
            match kind {
                Kind::Signed => self.finite(what, &number)?,
                Kind::Bound => self.not_negative(what, &number, help)?,
            };
        }
        Ok(field)
    }

    /// As many components as the case has dimensions.
    pub(crate) fn vector_field(
        &self,
        what: &str,
        keys: &At<Vec<At<FieldKeys>>>,
    ) -> Result<VectorField, CaseError> {
        self.right_length(keys)?;
        let mut components = std::array::from_fn(|_| ScalarField::Constant(0.0));
        for (component, keys) in components.iter_mut().zip(&keys.value) {
            *component = self.field(what, Kind::Signed, keys, "")?;
        }
        Ok(match &components {
            [
                ScalarField::Constant(x),
                ScalarField::Constant(y),
                ScalarField::Constant(z),
            ] => VectorField::Constant([*x, *y, *z]),
            _ => VectorField::Function(Arc::new(move |point| {
                components.each_ref().map(|field| match field {
                    ScalarField::Constant(value) => *value,
                    ScalarField::Function(function) => function(point),
                    // No key gives any.
                    ScalarField::Values(_) => f64::NAN,
                })
            })),
        })
    }

    /// A formula, checked for coordinates that the case does not have.
    fn expression(&self, text: &str, span: Span) -> Result<Expression, CaseError> {
        let expression = Expression::parse(text).map_err(|error| {
            let place = self.inside(text, &span, error.span);
            self.fault(FaultKind::BadValue, place, error.message, error.expected)
                .with_help(error.help)
        })?;
        for (axis, name) in VARIABLES.iter().enumerate().skip(self.analysis.dimension()) {
            if expression.uses(axis) {
                let analysis = self.analysis.word();
                return Err(self
                    .fault(
                        FaultKind::BadValue,
                        span,
                        format!("there is no {name} with `analysis = \"{analysis}\"`"),
                        "expected a formula in x and y",
                    )
                    .with_help(match self.analysis {
                        Analysis::Axisymmetric => "x is the radius, and y runs along the axis",
                        _ => "a plane case has the coordinates x and y",
                    }));
            }
        }
        Ok(expression)
    }

    /// The place of a part of a text in quotes; the whole where escapes make it unclear.
    fn inside(&self, text: &str, whole: &Span, part: Span) -> Span {
        let raw = self.source.slice(whole.clone());
        match raw.get(1..raw.len().saturating_sub(1)) {
            Some(inner) if inner == text => {
                let start = whole.start + 1;
                start + part.start..start + part.end
            }
            _ => whole.clone(),
        }
    }
}
