//! Numbers and vectors: finite, of the right sign, with as many components as the case has.

use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::{Deserializer, SeqAccess, Visitor};
use tresca_io::located::Span;

use crate::error::{CaseError, FaultKind};
use crate::reader::Reader;
use crate::text::at::At;

/// Values for the directions of the axes, each with its place in the file.
#[derive(Clone, Debug)]
pub(crate) struct Components<T, const N: usize>(pub [At<T>; N]);

/// Values for the directions x, y, z.
pub(crate) type Triple<T> = Components<T, 3>;

impl<T: Copy, const N: usize> Components<T, N> {
    /// The values alone.
    pub fn values(&self) -> [T; N] {
        std::array::from_fn(|axis| self.0[axis].value)
    }
}

impl<'de, T: Deserialize<'de>, const N: usize> Deserialize<'de> for Components<T, N> {
    /// Not derived: the array of the standard library takes the first ones of a longer list.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(ComponentsVisitor(PhantomData))
    }
}

struct ComponentsVisitor<T, const N: usize>(PhantomData<T>);

impl<'de, T: Deserialize<'de>, const N: usize> Visitor<'de> for ComponentsVisitor<T, N> {
    type Value = Components<T, N>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(list_of_numbers(N))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<Self::Value, A::Error> {
        let mut values = Vec::with_capacity(N);
        while let Some(value) = sequence.next_element()? {
            values.push(value);
        }
        let found = values.len();
        let values = <[At<T>; N]>::try_from(values)
            .map_err(|_| serde::de::Error::invalid_length(found, &self))?;
        Ok(Components(values))
    }
}

/// A vector in words, by the number of its components.
fn list_of_numbers(dimension: usize) -> &'static str {
    match dimension {
        2 => "a list of two numbers [x, y]",
        _ => "a list of three numbers [x, y, z]",
    }
}

impl Reader<'_> {
    pub(crate) fn finite(&self, what: &str, value: &At<f64>) -> Result<f64, CaseError> {
        let number = value.value;
        if number.is_finite() {
            return Ok(number);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                value.span(),
                format!("{what} is not a finite number"),
                format!("expected a finite number, found {number:?}"),
            )
            .with_help("TOML knows the words `nan` and `inf`; a case file takes numbers only"))
    }

    /// `help` says what the number is.
    pub(crate) fn not_negative(
        &self,
        what: &str,
        value: &At<f64>,
        help: &str,
    ) -> Result<f64, CaseError> {
        let number = self.finite(what, value)?;
        if number >= 0.0 {
            return Ok(number);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                value.span(),
                format!("{what} must not be negative"),
                format!("expected 0 or more, found {number:?}"),
            )
            .with_help(help))
    }

    /// A number above 0.
    pub(crate) fn positive(
        &self,
        what: &str,
        value: &At<f64>,
        help: &str,
    ) -> Result<f64, CaseError> {
        let number = self.finite(what, value)?;
        if number > 0.0 {
            return Ok(number);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                value.span(),
                format!("{what} must be positive"),
                format!("expected more than 0, found {number:?}"),
            )
            .with_help(help))
    }

    pub(crate) fn finite_components<const N: usize>(
        &self,
        what: &str,
        values: &At<Components<f64, N>>,
    ) -> Result<(), CaseError> {
        for value in &values.value.0 {
            self.finite(what, value)?;
        }
        Ok(())
    }

    /// A vector that points somewhere.
    pub(crate) fn direction(
        &self,
        what: &str,
        span: Span,
        vector: [f64; 3],
    ) -> Result<[f64; 3], CaseError> {
        if vector != [0.0; 3] {
            return Ok(vector);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                span,
                format!("{what} has no direction"),
                "expected a vector that is not zero",
            )
            .with_help("its length does not matter"))
    }

    /// As [`Check::vector_field`], for vectors that do not vary.
    pub(crate) fn vector(
        &self,
        what: &str,
        keys: &At<Vec<At<f64>>>,
    ) -> Result<[f64; 3], CaseError> {
        self.right_length(keys)?;
        let mut vector = [0.0; 3];
        for (component, value) in vector.iter_mut().zip(keys.iter()) {
            *component = self.finite(what, value)?;
        }
        Ok(vector)
    }

    pub(crate) fn right_length<T>(&self, list: &At<Vec<T>>) -> Result<(), CaseError> {
        let (expected, found) = (self.analysis.dimension(), list.value.len());
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
            )))
    }
}
