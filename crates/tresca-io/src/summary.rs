//! Summaries as JSON, for programs that ask how a run went.

use std::io::Write;

use serde::Serialize;
use serde_json::Value;

use crate::error::WriteError;

/// Writes a value as indented JSON, keys in the order of declaration.
///
/// JSON has no NaN and no infinity, and its writer turns them into `null` without a word. So there
/// is no `null` at all in a summary: leave absent values out
/// (`#[serde(skip_serializing_if = "Option::is_none")]`).
///
/// # Errors
/// [`WriteError::Null`] naming the key of a NaN, an infinity or a `None`; those of the stream.
pub fn write(out: &mut dyn Write, summary: &impl Serialize) -> Result<(), WriteError> {
    let text = serde_json::to_string_pretty(summary)?;
    let mut path = Vec::new();
    if finds_null(&serde_json::from_str(&text)?, &mut path) {
        return Err(WriteError::Null {
            path: path.join("."),
        });
    }
    writeln!(out, "{text}")?;
    Ok(())
}

/// Whether there is a null; the path then leads to it.
fn finds_null(value: &Value, path: &mut Vec<String>) -> bool {
    let mut descend = |key: String, value: &Value| {
        path.push(key);
        let found = finds_null(value, path);
        if !found {
            path.pop();
        }
        found
    };
    match value {
        Value::Null => true,
        Value::Array(entries) => entries
            .iter()
            .enumerate()
            .any(|(i, entry)| descend(i.to_string(), entry)),
        Value::Object(entries) => entries
            .iter()
            .any(|(key, entry)| descend(key.clone(), entry)),
        Value::Bool(_) | Value::Number(_) | Value::String(_) => false,
    }
}
