//! A value with its place in the text.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Deref;

use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use tresca_io::located::Span;

/// What the deserializer knows an [`At`] by; no type of serde's has this name.
pub(super) const NAME: &str = "tresca_case::At";

/// A value with its place in the text. Equal, and ordered, as the values are.
#[derive(Clone, Debug)]
pub(crate) struct At<T> {
    pub value: T,
    span: Span,
}

impl<T> At<T> {
    pub fn new(span: Span, value: T) -> Self {
        Self { value, span }
    }

    pub fn span(&self) -> Span {
        self.span.clone()
    }
}

impl<T> Deref for At<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.value
    }
}

impl<T: PartialEq> PartialEq for At<T> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<T: Eq> Eq for At<T> {}

impl<T: PartialOrd> PartialOrd for At<T> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<T: Ord> Ord for At<T> {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.value.cmp(&other.value)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for At<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_newtype_struct(NAME, AtVisitor(PhantomData))
    }
}

struct AtVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for AtVisitor<T> {
    type Value = At<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("start, end and value")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut parts: A) -> Result<At<T>, A::Error> {
        let mut bound = || match parts.next_element::<usize>()? {
            Some(bound) => Ok(bound),
            None => Err(A::Error::custom("a place without bounds")),
        };
        let span = bound()?..bound()?;
        match parts.next_element()? {
            Some(value) => Ok(At { value, span }),
            None => Err(A::Error::custom("a place without a value")),
        }
    }
}
