//! Quantities that may vary over a body or a surface: a number, a formula, or values from a file.

use toml::Spanned;

use super::check::Check;
use super::entries::{FieldKeys, list_of_numbers};
use super::error::{CaseError, FaultKind};
use super::keys::Analysis;
use super::samples::Samples;
use super::source::Span;
use crate::expression::{Expression, VARIABLES};

/// A quantity over a body or a surface.
#[derive(Clone, Debug)]
pub enum Field {
    /// The same everywhere; finite.
    Constant(f64),
    /// A formula that mentions at least one coordinate.
    Expression(Expression),
    /// Values at points.
    Samples(Samples),
}

impl Field {
    /// The value, where it is the same everywhere.
    pub fn constant(&self) -> Option<f64> {
        match self {
            Field::Constant(value) => Some(*value),
            Field::Expression(_) | Field::Samples(_) => None,
        }
    }

    /// The value at a point of the undeformed body. That of a formula may be NaN, infinite or of
    /// the wrong sign: the caller checks, and reports the point.
    pub fn at(&self, point: [f64; 3]) -> f64 {
        match self {
            Field::Constant(value) => *value,
            Field::Expression(expression) => expression.at(point),
            Field::Samples(samples) => samples.at(point),
        }
    }
}

/// A vector over a body or a surface.
#[derive(Clone, Debug)]
pub struct VectorField {
    /// The components along x, y and z, each with its place; in a plane case the last is 0 and its
    /// place that of the whole.
    pub components: [Spanned<Field>; 3],
    /// Where the list stands.
    pub span: Span,
}

impl VectorField {
    /// The vector, where it is the same everywhere.
    pub fn constant(&self) -> Option<[f64; 3]> {
        let [x, y, z] = self
            .components
            .each_ref()
            .map(|field| field.get_ref().constant());
        Some([x?, y?, z?])
    }

    /// The vector at a point, as [`Field::at`].
    pub fn at(&self, point: [f64; 3]) -> [f64; 3] {
        self.components
            .each_ref()
            .map(|field| field.get_ref().at(point))
    }
}

/// What values a field may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Any finite number; values from a file are not foreseen.
    Signed,
    /// 0 or more; values may come from a file.
    Bound,
}

impl Check<'_> {
    /// `what` names the quantity, as in "the slip bound"; `help` says what it is.
    pub(super) fn field(
        &self,
        what: &str,
        kind: Kind,
        keys: &Spanned<FieldKeys>,
        help: &str,
    ) -> Result<Spanned<Field>, CaseError> {
        let span = keys.span();
        let field = match keys.get_ref() {
            FieldKeys::Number(value) => Field::Constant(*value),
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
                            )
                            .into());
                    }
                    Some(value) => Field::Constant(value),
                    None => Field::Expression(expression),
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
                    .with_help("slip bounds are the fields that may come from a file")
                    .into());
            }
            FieldKeys::File(file) => Field::Samples(self.samples(what, file)?),
        };
        if let Field::Constant(value) = field {
            let number = Spanned::new(span.clone(), value);
            match kind {
                Kind::Signed => self.finite(what, &number)?,
                Kind::Bound => self.not_negative(what, &number, help)?,
            };
        }
        Ok(Spanned::new(span, field))
    }

    /// As many components as the case has dimensions.
    pub(super) fn vector_field(
        &self,
        what: &str,
        keys: &Spanned<Vec<Spanned<FieldKeys>>>,
    ) -> Result<VectorField, CaseError> {
        self.right_length(keys)?;
        let mut components =
            std::array::from_fn(|_| Spanned::new(keys.span(), Field::Constant(0.0)));
        for (component, keys) in components.iter_mut().zip(keys.get_ref()) {
            *component = self.field(what, Kind::Signed, keys, "")?;
        }
        Ok(VectorField {
            components,
            span: keys.span(),
        })
    }

    /// As [`Check::vector_field`], for vectors that do not vary.
    pub(super) fn vector(
        &self,
        what: &str,
        keys: &Spanned<Vec<Spanned<f64>>>,
    ) -> Result<[f64; 3], CaseError> {
        self.right_length(keys)?;
        let mut vector = [0.0; 3];
        for (component, value) in vector.iter_mut().zip(keys.get_ref()) {
            *component = self.finite(what, value)?;
        }
        Ok(vector)
    }

    fn right_length<T>(&self, list: &Spanned<Vec<T>>) -> Result<(), CaseError> {
        let (expected, found) = (self.analysis.dimension(), list.get_ref().len());
        if found == expected {
            return Ok(());
        }
        Err(self
            .fault(
                FaultKind::WrongType,
                list.span(),
                "a list of the wrong length",
                format!(
                    "expected {}, found {found} entries",
                    list_of_numbers(expected)
                ),
            )
            .with_help(format!(
                "`analysis = \"{}\"` has {expected} coordinates",
                self.analysis.word()
            ))
            .into())
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
                    })
                    .into());
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
