//! serde's deserializer of a TOML tree. Not that of the `toml` crate, for its errors are sentences: here they say what is
//! wrong, see [`ShapeError`].

use serde::de::value::{MapDeserializer, SeqDeserializer, StrDeserializer, UsizeDeserializer};
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, Error, IntoDeserializer, SeqAccess,
    Unexpected, Visitor,
};
use serde::forward_to_deserialize_any;
use toml::Spanned;
use toml::de::{DeArray, DeInteger, DeTable, DeValue};
use tresca_io::located::Span;

use super::at;
use super::shape::{Expected, ShapeError};

/// Reads the table of a whole file.
pub(super) fn table<K: DeserializeOwned>(root: &Spanned<DeTable<'_>>) -> Result<K, ShapeError> {
    K::deserialize(entries(root.get_ref())).map_err(|error| error.or_at(&root.span()))
}

/// Where a key or a value stands.
#[derive(Clone)]
struct Place<'t> {
    span: Span,
    /// The key, or that of the value; entries of a list have that of the list.
    key: &'t str,
}

fn entries<'t, 'i>(
    table: &'t DeTable<'i>,
) -> MapDeserializer<
    'static,
    impl Iterator<Item = (KeyDeserializer<'t>, ValueDeserializer<'t, 'i>)>,
    ShapeError,
> {
    MapDeserializer::new(table.iter().map(|(key, value)| {
        let at = |span| Place {
            span,
            key: key.get_ref().as_ref(),
        };
        let value = ValueDeserializer {
            place: at(value.span()),
            value: value.get_ref(),
        };
        (KeyDeserializer(at(key.span())), value)
    }))
}

/// The entries of a list, which belongs to a key.
fn list<'t, 'i>(
    list: &'t DeArray<'i>,
    key: &'t str,
) -> SeqDeserializer<impl Iterator<Item = ValueDeserializer<'t, 'i>>, ShapeError> {
    SeqDeserializer::new(list.iter().map(move |entry| ValueDeserializer {
        value: entry.get_ref(),
        place: Place {
            span: entry.span(),
            key,
        },
    }))
}

#[derive(Clone)]
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

/// Both are deserializers of themselves.
macro_rules! into_itself {
    ($($type:ty),*) => {$(
        impl IntoDeserializer<'_, ShapeError> for $type {
            type Deserializer = Self;

            fn into_deserializer(self) -> Self {
                self
            }
        }
    )*};
}
into_itself!(KeyDeserializer<'_>, ValueDeserializer<'_, '_>);

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
            DeValue::Array(entries) => visitor.visit_seq(list(entries, self.place.key)),
            DeValue::Table(table) => visitor.visit_map(entries(table)),
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
        match self.value {
            DeValue::Array(entries) => self.at(visitor.visit_seq(list(entries, self.place.key))),
            _ => Err(self.wrong(Expected::List)),
        }
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ShapeError> {
        match self.value {
            DeValue::Table(table) => self.at(visitor.visit_map(entries(table))),
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
