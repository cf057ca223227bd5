//! ρ as an option: a number or the word "auto".

use super::options::{OptionValue, Range};
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// ρ in units of 1/σmax.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rho {
    /// What suits the method.
    Auto,
    /// This many times 1/σmax.
    Times(f64),
}

const AUTO: &str = "auto";

impl Serialize for Rho {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Rho::Auto => serializer.serialize_str(AUTO),
            Rho::Times(rho) => serializer.serialize_f64(*rho),
        }
    }
}

impl<'de> Deserialize<'de> for Rho {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberOrAuto)
    }
}

struct NumberOrAuto;

impl Visitor<'_> for NumberOrAuto {
    type Value = Rho;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a number or \"{AUTO}\"")
    }
    fn visit_f64<E: Error>(self, rho: f64) -> Result<Rho, E> {
        Ok(Rho::Times(rho))
    }
    fn visit_i64<E: Error>(self, rho: i64) -> Result<Rho, E> {
        Ok(Rho::Times(rho as f64))
    }
    fn visit_u64<E: Error>(self, rho: u64) -> Result<Rho, E> {
        Ok(Rho::Times(rho as f64))
    }
    fn visit_str<E: Error>(self, word: &str) -> Result<Rho, E> {
        if word == AUTO {
            Ok(Rho::Auto)
        } else {
            Err(E::invalid_value(serde::de::Unexpected::Str(word), &self))
        }
    }
}

impl OptionValue for Rho {
    fn show(&self) -> String {
        match self {
            Rho::Auto => format!("\"{AUTO}\""),
            Rho::Times(rho) => rho.show(),
        }
    }
    fn is_within(&self, range: &Range) -> bool {
        match self {
            Rho::Auto => true,
            Rho::Times(rho) => rho.is_within(range),
        }
    }
    fn allowed(range: &Range) -> String {
        format!("\"{AUTO}\" or {}", f64::allowed(range))
    }
}
