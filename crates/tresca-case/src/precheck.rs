//! What must be looked at ahead of the keys, because afterwards the report would be about something
//! else, or there would be none.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{CaseError, Fault, FaultKind};
use super::friction::LAWS;
use super::source::CaseSource;
use super::translate::unsupported;

/// Keys whose value is a table.
const TABLES: [&str; 14] = [
    "mesh",
    "brick",
    "rectangle",
    "rotate",
    "plane",
    "sphere",
    "cylinder",
    "circle",
    "surface",
    "material",
    "friction",
    "factors",
    "values",
    "solver",
];

/// Keys whose value is a list of tables.
const TABLE_LISTS: [&str; 10] = [
    "body",
    "clamp",
    "support",
    "traction",
    "pressure",
    "body_force",
    "gravity",
    "obstacle",
    "contact",
    "step",
];

/// Tables whose keys are names that the user chose, among them perhaps one of the above.
const NAMED_BY_USER: [&str; 2] = ["factors", "values"];

/// Friction laws that are not known. Without this the report on a law of another version would name
/// one of its keys instead of the law.
pub(super) fn friction_laws(source: &CaseSource, root: &DeTable<'_>) -> Result<(), CaseError> {
    let contacts = root
        .get("contact")
        .and_then(|list| list.get_ref().as_array());
    let laws = contacts
        .into_iter()
        .flatten()
        .filter_map(|contact| contact.get_ref().get("friction")?.get_ref().get("law"));
    for law in laws {
        if let DeValue::String(name) = law.get_ref()
            && !LAWS.contains(&name.as_ref())
        {
            return Err(unsupported(
                FaultKind::BadValue,
                source,
                law.span(),
                format!("the friction law `{name}` is not supported"),
                name,
                &LAWS,
            )
            .into());
        }
    }
    Ok(())
}

/// Lists in the place of tables. Derived deserialisation would take their entries for the values of
/// the keys, in the order of declaration.
pub(super) fn lists_for_tables(source: &CaseSource, root: &DeTable<'_>) -> Result<(), CaseError> {
    for (key, value) in root {
        let key = key.get_ref().as_ref();
        match value.get_ref() {
            DeValue::Table(_) if NAMED_BY_USER.contains(&key) => {}
            DeValue::Table(table) => lists_for_tables(source, table)?,
            DeValue::Array(_) if TABLES.contains(&key) => {
                return Err(expected_table(source, key, value));
            }
            DeValue::Array(entries) => {
                for entry in entries {
                    match entry.get_ref() {
                        DeValue::Table(table) => lists_for_tables(source, table)?,
                        DeValue::Array(_) if TABLE_LISTS.contains(&key) => {
                            return Err(expected_table(source, key, entry));
                        }
                        _ => {}
                    }
                }
            }
            _ => {}
        }
    }
    Ok(())
}

fn expected_table(source: &CaseSource, key: &str, value: &Spanned<DeValue<'_>>) -> CaseError {
    Fault::new(
        FaultKind::WrongType,
        source,
        value.span(),
        format!("expected a table of keys for `{key}`"),
        "found a list",
    )
    .with_help("a table has braces and names its values: { key = value, … }")
    .into()
}
