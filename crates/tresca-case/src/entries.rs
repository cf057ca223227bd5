//! Values that TOML has no type for: fields, new values of load steps, lists of fixed length.

use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use toml::Spanned;

/// A field over a body or surface, as it stands in the text.
#[derive(Clone, Debug)]
pub(super) enum FieldKeys {
    /// The same everywhere.
    Number(f64),
    /// A formula.
    Text(String),
    /// A table of values in a file.
    File(Spanned<String>),
}

/// `{ file = … }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ file = \"….csv\" }`")]
struct FileKeys {
    /// Path of the file, relative to the case file.
    file: Spanned<String>,
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

    fn visit_i64<E>(self, value: i64) -> Result<FieldKeys, E> {
        Ok(FieldKeys::Number(value as f64))
    }

    fn visit_str<E>(self, text: &str) -> Result<FieldKeys, E> {
        Ok(FieldKeys::Text(text.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<FieldKeys, A::Error> {
        let keys = FileKeys::deserialize(MapAccessDeserializer::new(map))?;
        Ok(FieldKeys::File(keys.file))
    }
}

/// A new value in a load step, as it stands in the text.
#[derive(Clone, Debug)]
pub(super) enum ValueKeys {
    /// A pressure or a slip bound.
    Number(f64),
    /// A traction, a body force or an acceleration.
    List(Vec<Spanned<f64>>),
    /// A prescribed displacement.
    Components(ComponentKeys),
}

/// `{ x = …, y = …, z = … }`: components of a displacement.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ x = …, y = …, z = … }`")]
pub(super) struct ComponentKeys {
    /// Along x (length).
    pub x: Option<Spanned<f64>>,
    /// Along y (length).
    pub y: Option<Spanned<f64>>,
    /// Along z (length).
    pub z: Option<Spanned<f64>>,
}

impl<'de> Deserialize<'de> for ValueKeys {
    /// Not derived, for the same reason as with [`FieldKeys`].
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueVisitor)
    }
}

struct ValueVisitor;

impl<'de> Visitor<'de> for ValueVisitor {
    type Value = ValueKeys;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a list of numbers or a table `{ x = …, y = …, z = … }`")
    }

    fn visit_f64<E>(self, value: f64) -> Result<ValueKeys, E> {
        Ok(ValueKeys::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<ValueKeys, E> {
        Ok(ValueKeys::Number(value as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<ValueKeys, A::Error> {
        Deserialize::deserialize(SeqAccessDeserializer::new(list)).map(ValueKeys::List)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<ValueKeys, A::Error> {
        Deserialize::deserialize(MapAccessDeserializer::new(map)).map(ValueKeys::Components)
    }
}

/// Values for the directions of the axes, each with its place in the file.
#[derive(Clone, Debug)]
pub struct Components<T, const N: usize>(pub [Spanned<T>; N]);

/// Values for the directions x, y, z.
pub type Triple<T> = Components<T, 3>;

/// Values for the directions x, y.
pub type Pair<T> = Components<T, 2>;

impl<T: Copy, const N: usize> Components<T, N> {
    /// The values alone.
    pub fn values(&self) -> [T; N] {
        std::array::from_fn(|axis| *self.0[axis].get_ref())
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
        let values = <[Spanned<T>; N]>::try_from(values)
            .map_err(|_| serde::de::Error::invalid_length(found, &self))?;
        Ok(Components(values))
    }
}

/// A vector in words, by the number of its components.
pub(super) fn list_of_numbers(dimension: usize) -> &'static str {
    match dimension {
        2 => "a list of two numbers [x, y]",
        _ => "a list of three numbers [x, y, z]",
    }
}
