//! `history.csv`.

use std::io::Write;

use tresca_io::WriteError;
use tresca_io::history::{History, Value};

use crate::IterationRecord;
use crate::report::{COLUMNS, Entry};

/// Writes the records of load steps, with their numbers.
pub(super) fn write<'a>(
    steps: impl IntoIterator<Item = (usize, &'a [IterationRecord])>,
    out: &mut dyn Write,
) -> Result<(), WriteError> {
    let names = COLUMNS.iter().map(|column| column.name);
    let mut table = History::new(&["step"].into_iter().chain(names).collect::<Vec<_>>());
    for (number, records) in steps {
        for record in records {
            let entries = COLUMNS.iter().map(|column| match column.value {
                Entry::Count(value) => value(record).into(),
                Entry::Figure(value) | Entry::Share(value) => value(record).into(),
            });
            let row: Vec<Value> = std::iter::once(number.into()).chain(entries).collect();
            table.push(&row)?;
        }
    }
    table.write(out)
}
