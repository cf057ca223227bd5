//! From text to keys: TOML is read into the structs that declare the keys, and whatever does not fit is reported in plain
//! words, with the keys that belong there and what was probably meant.

pub(crate) mod at;
mod deserializer;
pub(crate) mod shape;
mod syntax;

use serde::de::DeserializeOwned;
use toml::de::DeTable;
use tresca_io::located::SourceText;

use crate::error::CaseError;

/// Parses a text, lets `ahead` look at the tree, and reads the keys.
pub(crate) fn read<K: DeserializeOwned>(
    source: &SourceText,
    ahead: impl FnOnce(&DeTable<'_>) -> Result<(), CaseError>,
) -> Result<K, CaseError> {
    let root = DeTable::parse(source.text()).map_err(|error| syntax::report(source, &error))?;
    ahead(root.get_ref())?;
    deserializer::table(&root).map_err(|error| shape::report(source, error))
}
