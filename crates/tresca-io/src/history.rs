//! Tables of numbers as CSV: the history of an iteration, one row per step.

use std::fmt;
use std::io::Write;

use crate::error::WriteError;

/// A table with named columns.
///
/// ```
/// use tresca_io::history::{History, Value};
///
/// let mut history = History::new(&["iteration", "residual", "step_length"]);
/// history.push(&[Value::from(0), 1.0.into(), Value::Absent])?;
/// history.push(&[Value::from(1), 2.5e-9.into(), 1.0.into()])?;
///
/// let mut csv = Vec::new();
/// history.write(&mut csv)?;
/// assert_eq!(csv, b"iteration,residual,step_length\n0,1.0,\n1,2.5e-9,1.0\n");
/// # Ok::<(), tresca_io::WriteError>(())
/// ```
#[derive(Clone, Debug)]
pub struct History {
    columns: Vec<String>,
    /// Row after row.
    values: Vec<Value>,
}

/// One entry of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A count.
    Integer(i64),
    /// A finite number; written with the fewest digits that read back to the same.
    Number(f64),
    /// Nothing to say in this row; the entry is empty.
    Absent,
}

impl From<usize> for Value {
    /// Counts beyond the range of `i64`, which nothing here can reach, become its largest value.
    fn from(count: usize) -> Self {
        Value::Integer(i64::try_from(count).unwrap_or(i64::MAX))
    }
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Value::Number(value)
    }
}

impl<T: Into<Value>> From<Option<T>> for Value {
    fn from(value: Option<T>) -> Self {
        value.map_or(Value::Absent, Into::into)
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Integer(value) => write!(f, "{value}"),
            // The debug form is the shortest exact one, with an exponent where that is shorter.
            Value::Number(value) => write!(f, "{value:?}"),
            Value::Absent => Ok(()),
        }
    }
}

impl History {
    /// An empty table.
    pub fn new(columns: &[&str]) -> Self {
        Self {
            columns: columns.iter().map(|&name| name.to_owned()).collect(),
            values: Vec::new(),
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.values.len() / self.columns.len().max(1)
    }

    /// Appends a row, one value per column.
    ///
    /// # Errors
    /// [`WriteError::Length`] for another number of values, [`WriteError::NotFinite`] for NaN and
    /// infinity. The table stays as it was.
    pub fn push(&mut self, row: &[Value]) -> Result<(), WriteError> {
        if row.len() != self.columns.len() {
            return Err(WriteError::Length {
                field: format!("row {}", self.rows()),
                expected: self.columns.len(),
                found: row.len(),
            });
        }
        for (column, value) in self.columns.iter().zip(row) {
            if let Value::Number(value) = *value
                && !value.is_finite()
            {
                return Err(WriteError::NotFinite {
                    field: column.clone(),
                    place: format!("row {}", self.rows()),
                    value,
                });
            }
        }
        self.values.extend_from_slice(row);
        Ok(())
    }

    /// Writes a header line and the rows, separated by commas.
    ///
    /// # Errors
    /// Those of the stream.
    pub fn write(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record(&self.columns)?;
        for row in self.values.chunks_exact(self.columns.len().max(1)) {
            csv.write_record(row.iter().map(Value::to_string))?;
        }
        csv.flush()?;
        Ok(())
    }
}
