//! Where the value of a key stands in a text.

use toml::Spanned;
use toml::de::{DeTable, DeValue};
use tresca_io::located::Span;

/// As [`Case::locate`](crate::Case::locate).
pub(crate) fn locate(text: &str, path: &str) -> Option<Span> {
    let root = DeTable::parse(text).ok()?;
    let mut steps = path.split('.');
    let mut at = step_into(root.get_ref(), steps.next()?)?;
    for step in steps {
        at = step_into(at.get_ref().as_table()?, step)?;
    }
    Some(at.span())
}

/// One step of [`locate`]: `key` or `key[index]`.
fn step_into<'t, 'i>(table: &'t DeTable<'i>, step: &str) -> Option<&'t Spanned<DeValue<'i>>> {
    let (key, index) = match step.split_once('[') {
        None => (step, None),
        Some((key, rest)) => (key, Some(rest.strip_suffix(']')?.parse::<usize>().ok()?)),
    };
    let value = table.get(key)?;
    match index {
        None => Some(value),
        Some(index) => value.get_ref().as_array()?.get(index),
    }
}
