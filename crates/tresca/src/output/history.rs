//! `history.csv`.

use std::io::Write;

use tresca_io::WriteError;
use tresca_io::history::{History, Value};

use tresca_qcqp::IterationRecord;
use tresca_qcqp::record::Entry;

/// Writes the records of load steps, with their numbers.
pub(super) fn write<'a>(
    steps: impl IntoIterator<Item = (usize, &'a [IterationRecord])>,
    out: &mut dyn Write,
) -> Result<(), WriteError> {
    let names = IterationRecord::COLUMNS.iter().map(|column| column.key);
    let mut table = History::new(&["step"].into_iter().chain(names).collect::<Vec<_>>());
    for (number, records) in steps {
        for record in records {
            let entries = IterationRecord::COLUMNS.iter();
            let entries = entries.map(|column| match (column.entry)(record) {
                Entry::Count(value) => value.into(),
                Entry::Real(value) => value.into(),
            });
            let row: Vec<Value> = std::iter::once(number.into()).chain(entries).collect();
            table.push(&row)?;
        }
    }
    table.write(out)
}
