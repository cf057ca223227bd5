//! Formulas in x, y, z: slip bounds, gaps, loads and mesh maps that vary over a body.
//!
//! ```
//! use tresca_case::expression::Expression;
//!
//! let bound = Expression::parse("0.5*(1 + x^2)")?;
//! assert_eq!(bound.at([2.0, 0.0, 0.0]), 2.5);
//! # Ok::<(), tresca_case::expression::ExpressionError>(())
//! ```
//!
//! The grammar is that of mathematics: `-x^2` is −(x²), `2^3^2` is 2⁹, `a/b*c` is (a/b)c, functions
//! have parentheses, and nothing is multiplied without `*`. The parser is our own because a report
//! needs the place of every fault, and because those of the ecosystem that are maintained under a
//! permissive licence read `-x^2` as (−x)² (`exmex` 0.21): a wrong load without a word of warning.

mod code;
pub(crate) mod error;
pub(crate) mod names;
mod parser;

use std::fmt;
use std::sync::Arc;

use code::Program;

pub use error::ExpressionError;
pub use names::{CONSTANTS, VARIABLES};

/// A formula in x, y, z. Cheap to clone.
#[derive(Clone)]
pub struct Expression {
    text: Arc<str>,
    program: Arc<Program>,
}

impl Expression {
    /// Reads a formula.
    ///
    /// # Errors
    /// [`ExpressionError`], with the bytes of `text` that are at fault.
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        Ok(Self {
            text: text.into(),
            program: Arc::new(parser::parse(text)?),
        })
    }

    /// The value at a point. Outside the domain of a function it is NaN or infinite, as IEEE 754 has
    /// it: callers check, for they know what the value is for.
    pub fn at(&self, point: [f64; 3]) -> f64 {
        self.program.run(point)
    }

    /// The text as it was given.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether the formula mentions the coordinate with this number.
    pub fn uses(&self, axis: usize) -> bool {
        self.program.uses(axis)
    }

    /// The value of a formula without variables.
    pub fn constant(&self) -> Option<f64> {
        let varies = (0..VARIABLES.len()).any(|axis| self.uses(axis));
        (!varies).then(|| self.at([0.0; 3]))
    }
}

impl fmt::Debug for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Expression").field(&self.text).finish()
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl PartialEq for Expression {
    /// Formulas are equal when their texts are.
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}
