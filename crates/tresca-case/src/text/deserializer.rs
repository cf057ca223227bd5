//! serde's deserializer of a TOML tree. Not that of the `toml` crate, for its errors are sentences: here they say what is
//! wrong, see [`ShapeError`].

use serde::de::value::{StrDeserializer, UsizeDeserializer};
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, Error, IntoDeserializer, MapAccess, SeqAccess,
    Unexpected, Visitor,
};
use serde::forward_to_deserialize_any;
use toml::Spanned;
use toml::de::{DeInteger, DeString, DeTable, DeValue};
use tresca_io::located::Span;

use super::at;
use super::shape::{Expected, ShapeError};

/// Reads the table of a whole file.
pub(super) fn table<K: DeserializeOwned>(root: &Spanned<DeTable<'_>>) -> Result<K, ShapeError> {
    let place = Place {
        span: root.span(),
        key: "",
    };
    let table = Entries::new(root.get_ref());
    K::deserialize(TableDeserializer { table, place })
}

/// Where a value stands.
#[derive(Clone)]
struct Place<'t> {
    span: Span,
    /// The key that it belongs to; entries of a list have that of the list.
    key: &'t str,
}

struct TableDeserializer<'t, 'i> {
    table: Entries<'t, 'i>,
    place: Place<'t>,
}

impl<'de> Deserializer<'de> for TableDeserializer<'_, '_> {
    type Error = ShapeError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        let at = |error: ShapeError| error.or_at(&self.place.span);
        visitor.visit_map(self.table).map_err(at)
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

/// The entries of a table, one after the other.
struct Entries<'t, 'i> {
    entries: Box<dyn Iterator<Item = (&'t Spanned<DeString<'i>>, &'t Spanned<DeValue<'i>>)> + 't>,
    value: Option<ValueDeserializer<'t, 'i>>,
}

impl<'t, 'i> Entries<'t, 'i> {
    fn new(table: &'t DeTable<'i>) -> Self {
        Self {
            entries: Box::new(table.iter()),
            value: None,
        }
    }
}

impl<'de> MapAccess<'de> for Entries<'_, '_> {
    type Error = ShapeError;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, ShapeError> {
        let Some((key, value)) = self.entries.next() else {
            return Ok(None);
        };
        self.value = Some(ValueDeserializer {
            value: value.get_ref(),
            place: Place {
                span: value.span(),
                key: key.get_ref(),
            },
        });
        let place = Place {
            span: key.span(),
            key: key.get_ref(),
        };
        seed.deserialize(KeyDeserializer(place)).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(
        &mut self,
        seed: V,
    ) -> Result<V::Value, ShapeError> {
        match self.value.take() {
            Some(value) => seed.deserialize(value),
            None => Err(ShapeError::custom("a value without a key")),
        }
    }
}

struct KeyDeserializer<'t>(Place<'t>);

impl<'de> Deserializer<'de> for KeyDeserializer<'_> {
    type Error = ShapeError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        let at = |error: ShapeError| error.or_at(&self.0.span);
        visitor.visit_str(self.0.key).map_err(at)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, ShapeError> {
        match name {
            at::NAME => visitor.visit_seq(Parts::new(self.0.span.clone(), self)),
            _ => self.deserialize_any(visitor),
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

/// Start, end and value, for [`at::At`].
struct Parts<D> {
    bounds: Vec<usize>,
    value: Option<D>,
}

impl<D> Parts<D> {
    fn new(span: Span, value: D) -> Self {
        Self {
            bounds: vec![span.end, span.start],
            value: Some(value),
        }
    }
}

impl<'de, D: Deserializer<'de, Error = ShapeError>> SeqAccess<'de> for Parts<D> {
    type Error = ShapeError;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, ShapeError> {
        if let Some(bound) = self.bounds.pop() {
            let bound: UsizeDeserializer<ShapeError> = bound.into_deserializer();
            return seed.deserialize(bound).map(Some);
        }
        self.value
            .take()
            .map(|value| seed.deserialize(value))
            .transpose()
    }
}

#[derive(Clone)]
struct ValueDeserializer<'t, 'i> {
    value: &'t DeValue<'i>,
    place: Place<'t>,
}

impl<'t, 'i> ValueDeserializer<'t, 'i> {
    /// Something else than `expected`.
    fn wrong(&self, expected: Expected) -> ShapeError {
        let found = unexpected(self.value);
        ShapeError::wrong_type(expected, found).or_at(&self.place.span)
    }

    fn at<T>(&self, result: Result<T, ShapeError>) -> Result<T, ShapeError> {
        result.map_err(|error| error.or_at(&self.place.span))
    }

    fn whole<T: TryFrom<i128>>(&self, expected: Expected) -> Result<T, ShapeError> {
        let number = match self.value {
            DeValue::Integer(integer) => integer_value(integer),
            _ => None,
        };
        let fits = number.and_then(|number| T::try_from(number).ok());
        fits.ok_or_else(|| self.wrong(expected))
    }

    fn number(&self) -> Result<f64, ShapeError> {
        let number = match self.value {
            DeValue::Integer(integer) => integer_value(integer).map(|number| number as f64),
            DeValue::Float(float) => match float.as_str().parse::<f64>() {
                Ok(number) if number.is_infinite() && !float.as_str().contains("inf") => {
                    return self.at(Err(Error::custom("floating-point number overflowed")));
                }
                number => number.ok(),
            },
            _ => None,
        };
        number.ok_or_else(|| self.wrong(Expected::Number))
    }

    fn list(&self) -> Option<List<'t, 'i>> {
        let DeValue::Array(list) = self.value else {
            return None;
        };
        Some(List {
            entries: Box::new(list.iter()),
            key: self.place.key,
        })
    }
}

fn integer_value(integer: &DeInteger<'_>) -> Option<i128> {
    i128::from_str_radix(integer.as_str(), integer.radix()).ok()
}

fn unexpected<'t>(value: &'t DeValue<'_>) -> Unexpected<'t> {
    match value {
        DeValue::String(text) => Unexpected::Str(text),
        DeValue::Integer(_) => Unexpected::Signed(0),
        DeValue::Float(_) => Unexpected::Float(0.0),
        DeValue::Boolean(word) => Unexpected::Bool(*word),
        DeValue::Datetime(_) => Unexpected::Other("a date or a time"),
        DeValue::Array(_) => Unexpected::Seq,
        DeValue::Table(_) => Unexpected::Map,
    }
}

macro_rules! whole_numbers {
    ($($deserialize:ident $visit:ident $type:ty: $expected:ident,)*) => {$(
        fn $deserialize<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
            visitor.$visit(self.whole::<$type>(Expected::$expected)?)
        }
    )*};
}

impl<'de> Deserializer<'de> for ValueDeserializer<'_, '_> {
    type Error = ShapeError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        let value = match self.value {
            DeValue::String(text) => visitor.visit_str(text),
            DeValue::Integer(_) | DeValue::Float(_) => visitor.visit_f64(self.number()?),
            DeValue::Boolean(word) => visitor.visit_bool(*word),
            DeValue::Array(list) => visitor.visit_seq(List {
                entries: Box::new(list.iter()),
                key: self.place.key,
            }),
            DeValue::Table(table) => visitor.visit_map(Entries::new(table)),
            DeValue::Datetime(_) => Err(Error::invalid_type(unexpected(self.value), &visitor)),
        };
        self.at(value)
    }

    whole_numbers! {
        deserialize_u8 visit_u8 u8: Count,
        deserialize_u16 visit_u16 u16: Count,
        deserialize_u32 visit_u32 u32: Count,
        deserialize_u64 visit_u64 u64: Count,
        deserialize_i32 visit_i32 i32: Whole,
        deserialize_i64 visit_i64 i64: Whole,
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        visitor.visit_f64(self.number()?)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        match self.value {
            DeValue::Boolean(word) => visitor.visit_bool(*word),
            _ => Err(self.wrong(Expected::Bool)),
        }
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        match self.value {
            DeValue::String(text) => self.at(visitor.visit_str(text)),
            _ => Err(self.wrong(Expected::Text)),
        }
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        self.deserialize_string(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        visitor.visit_some(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        match self.list() {
            Some(list) => self.at(visitor.visit_seq(list)),
            None => Err(self.wrong(Expected::List)),
        }
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        match self.value {
            DeValue::Table(table) => self.at(visitor.visit_map(Entries::new(table))),
            DeValue::Array(_) => Err(self.wrong(Expected::Table(self.place.key.to_owned()))),
            value => self.at(Err(Error::invalid_type(unexpected(value), &visitor))),
        }
    }

    /// A list is no table: its entries are not the values of the keys in the order in which they are declared.
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ShapeError> {
        self.deserialize_map(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ShapeError> {
        match self.value {
            DeValue::String(text) => {
                let word: StrDeserializer<'_, ShapeError> = text.as_ref().into_deserializer();
                self.at(visitor.visit_enum(word))
            }
            _ => Err(self.wrong(Expected::Word)),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, ShapeError> {
        match name {
            at::NAME => visitor.visit_seq(Parts::new(self.place.span.clone(), self)),
            _ => visitor.visit_newtype_struct(self),
        }
    }

    forward_to_deserialize_any! {
        i8 i16 i128 u128 f32 char bytes byte_buf unit unit_struct tuple tuple_struct identifier ignored_any
    }
}

/// The entries of a list, one after the other.
struct List<'t, 'i> {
    entries: Box<dyn Iterator<Item = &'t Spanned<DeValue<'i>>> + 't>,
    key: &'t str,
}

impl<'de> SeqAccess<'de> for List<'_, '_> {
    type Error = ShapeError;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, ShapeError> {
        let entry = self.entries.next().map(|entry| ValueDeserializer {
            value: entry.get_ref(),
            place: Place {
                span: entry.span(),
                key: self.key,
            },
        });
        entry.map(|entry| seed.deserialize(entry)).transpose()
    }
}
