//! Why a text is no formula.

use std::ops::Range;

/// Why a text is no formula.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
#[non_exhaustive]
pub struct ExpressionError {
    /// What is wrong.
    pub message: String,
    /// The bytes of the text that are at fault; empty at the end of a text that stops too early.
    pub span: Range<usize>,
    /// What is expected there, or was probably meant.
    pub expected: String,
    /// The likely cause or cure.
    pub help: String,
}
