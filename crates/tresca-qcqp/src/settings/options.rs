//! The machinery behind [`Settings`](super::Settings): one declaration per
//! option, from which come the field, its rustdoc, its key in a case file, its
//! line in the list of options and its check.

use serde::Serialize;
use std::fmt;

/// What there is to know of one option.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct OptionInfo {
    /// Key in the case file and name of the field.
    pub name: &'static str,
    /// What it does.
    pub doc: String,
    /// Default, as it is written in a case file.
    pub default: String,
    /// Allowed values, in words.
    pub allowed: String,
}

/// An interval of numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub lower: f64,
    pub lower_allowed: bool,
    pub upper: f64,
    pub upper_allowed: bool,
}

impl Range {
    /// The range of an option that is a word: its type alone restricts it.
    pub const WORDS: Range = Range::closed(f64::NEG_INFINITY, f64::INFINITY);

    /// lower < x < upper.
    pub const fn open(lower: f64, upper: f64) -> Self {
        Self {
            lower,
            lower_allowed: false,
            upper,
            upper_allowed: false,
        }
    }

    /// lower ≤ x ≤ upper.
    pub const fn closed(lower: f64, upper: f64) -> Self {
        Self {
            lower,
            lower_allowed: true,
            upper,
            upper_allowed: true,
        }
    }

    /// x ≥ lower.
    pub const fn at_least(lower: f64) -> Self {
        Self {
            lower,
            lower_allowed: true,
            upper: f64::INFINITY,
            upper_allowed: false,
        }
    }

    fn holds(&self, x: f64) -> bool {
        let above = x > self.lower || self.lower_allowed && x == self.lower;
        let below = x < self.upper || self.upper_allowed && x == self.upper;
        above && below
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let relation = |allowed| if allowed { "≤" } else { "<" };
        if self.upper.is_infinite() {
            let relation = if self.lower_allowed { "≥" } else { ">" };
            return write!(f, "{relation} {}", self.lower);
        }
        let (low, high) = (relation(self.lower_allowed), relation(self.upper_allowed));
        write!(f, "{} {low} value {high} {}", self.lower, self.upper)
    }
}

/// A type that an option can have.
pub(super) trait OptionValue {
    /// The value as written in a case file.
    fn show(&self) -> String;
    /// Whether the value is allowed.
    fn is_within(&self, range: &Range) -> bool;
    /// What is allowed, in words.
    fn allowed(range: &Range) -> String;
}

impl OptionValue for f64 {
    fn show(&self) -> String {
        // The shortest of the two spellings: 0.03, but 1e-8.
        let (plain, scientific) = (format!("{self:?}"), format!("{self:e}"));
        if scientific.len() < plain.len() {
            scientific
        } else {
            plain
        }
    }
    fn is_within(&self, range: &Range) -> bool {
        self.is_finite() && range.holds(*self)
    }
    fn allowed(range: &Range) -> String {
        format!("a number, {range}")
    }
}

impl OptionValue for usize {
    fn show(&self) -> String {
        self.to_string()
    }
    fn is_within(&self, range: &Range) -> bool {
        range.holds(*self as f64)
    }
    fn allowed(range: &Range) -> String {
        format!("a whole number, {range}")
    }
}

/// Declares an enum whose values are words: serde, `Display`, `FromStr` and the
/// list of words come from the one declaration.
macro_rules! words {
    (
        $(#[doc = $enum_doc:literal])+
        pub enum $type:ident, $what:literal {
            $( $(#[doc = $doc:literal])+ $variant:ident = $word:literal, )+
        }
    ) => {
        $(#[doc = $enum_doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
        pub enum $type {
            $( $(#[doc = $doc])+ #[serde(rename = $word)] $variant, )+
        }

        impl $type {
            /// Every choice, in the order of the documentation.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// The word for it.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $word,)+ }
            }

            /// What it means.
            pub fn doc(self) -> &'static str {
                match self { $(Self::$variant => concat!($($doc),+).trim_ascii(),)+ }
            }
        }

        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.name())
            }
        }

        impl std::str::FromStr for $type {
            type Err = $crate::error::QcqpError;
            fn from_str(word: &str) -> Result<Self, Self::Err> {
                Self::ALL.iter().copied().find(|choice| choice.name() == word).ok_or_else(|| {
                    $crate::error::QcqpError::Choice {
                        what: $what,
                        found: word.to_owned(),
                        allowed: [$($word),+].join(", "),
                    }
                })
            }
        }

        impl $crate::settings::options::OptionValue for $type {
            fn show(&self) -> String {
                format!("\"{self}\"")
            }
            fn is_within(&self, _: &$crate::settings::options::Range) -> bool {
                true
            }
            fn allowed(_: &$crate::settings::options::Range) -> String {
                [$($word),+].join(" | ")
            }
        }
    };
}

/// Declares the settings: `/// doc`, `name: type = default, range;` each.
macro_rules! settings {
    (
        $(#[doc = $struct_doc:literal])+
        pub struct $settings:ident {
            $( $(#[doc = $doc:literal])+ $name:ident : $type:ty = $default:expr, $range:expr; )+
        }
    ) => {
        $(#[doc = $struct_doc])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
        #[serde(deny_unknown_fields, default)]
        pub struct $settings {
            $(
                $(#[doc = $doc])+
                #[doc = ""]
                #[doc = concat!("Default: `", stringify!($default), "`.")]
                pub $name: $type,
            )+
        }

        impl Default for $settings {
            fn default() -> Self {
                Self { $($name: $default),+ }
            }
        }

        impl $settings {
            /// All options with documentation, default and allowed values: the
            /// source of command line help and of the documentation page.
            pub fn options() -> &'static [OptionInfo] {
                static OPTIONS: std::sync::LazyLock<Vec<OptionInfo>> = std::sync::LazyLock::new(|| vec![
                    $( OptionInfo {
                        name: stringify!($name),
                        doc: [$($doc.trim()),+].join(" "),
                        default: <$type as OptionValue>::show(&$default),
                        allowed: <$type as OptionValue>::allowed(&$range),
                    }, )+
                ]);
                &OPTIONS
            }

            /// Checks every option against its own range.
            fn check_ranges(&self) -> Result<(), crate::error::QcqpError> {
                $(
                    if !self.$name.is_within(&$range) {
                        return Err(crate::error::QcqpError::Setting {
                            name: stringify!($name),
                            value: self.$name.show(),
                            allowed: <$type as OptionValue>::allowed(&$range),
                        });
                    }
                )+
                Ok(())
            }
        }
    };
}

pub(super) use {settings, words};
