//! Values at points, from a table in a file: a field may be given by one.

use rstar::RTree;
use rstar::primitives::GeomWithData;

use crate::error::{CaseError, FaultKind};
use crate::reader::Reader;
use crate::text::at::At;

/// Values at points, read from a CSV file: everywhere else, the value of the nearest point holds.
#[derive(Debug)]
pub(crate) struct ValueTable {
    /// Row numbers with the points, so that the first of several nearest rows can be taken.
    tree: RTree<GeomWithData<[f64; 3], usize>>,
    values: Vec<f64>,
}

impl ValueTable {
    /// Of points and their values; at least one, all finite.
    fn new(rows: Vec<([f64; 3], f64)>) -> Self {
        let values = rows.iter().map(|(_, value)| *value).collect();
        let points = rows
            .into_iter()
            .enumerate()
            .map(|(row, (point, _))| GeomWithData::new(point, row))
            .collect();
        Self {
            tree: RTree::bulk_load(points),
            values,
        }
    }

    /// The value of the row whose point is nearest; of several, that of the first. NaN when the point
    /// is not finite, or without rows.
    pub fn at(&self, point: [f64; 3]) -> f64 {
        if !point.iter().all(|x| x.is_finite()) {
            return f64::NAN;
        }
        let nearest = self.tree.nearest_neighbors(&point);
        let row = nearest.iter().map(|leaf| leaf.data).min();
        row.map_or(f64::NAN, |row| self.values[row])
    }
}

impl Reader<'_> {
    /// Reads the table of a slip bound; `what` names the quantity in reports.
    pub(crate) fn value_table(
        &self,
        what: &str,
        file: &At<String>,
    ) -> Result<ValueTable, CaseError> {
        let fail = |message: String, label: String, help: String| -> CaseError {
            self.fault(FaultKind::BadFile, file.span(), message, label)
                .with_help(help)
        };
        let path = self.beside(file);
        let text = std::fs::read_to_string(&path).map_err(|error| {
            fail(
                format!("cannot read `{}`", path.display()),
                error.to_string(),
                "paths that do not start at the root count from the directory of the case file"
                    .to_owned(),
            )
        })?;
        let header = match self.analysis.dimension() {
            2 => "x,y,value",
            _ => "x,y,z,value",
        };
        read_rows(&text, header, what).map(ValueTable::new).map_err(
            |TableFault { line, fault, label }| {
                fail(
                    format!("{}:{line}: {fault}", path.display()),
                    label,
                    format!("a table of values is a CSV file with the header `{header}`"),
                )
            },
        )
    }
}

/// What is wrong with a table.
struct TableFault {
    /// From 1.
    line: usize,
    fault: String,
    label: String,
}

/// The rows of a table with this header: a point, then a value that is 0 or more.
fn read_rows(text: &str, header: &str, what: &str) -> Result<Vec<([f64; 3], f64)>, TableFault> {
    let fault = |line: usize, fault: String, label: &str| TableFault {
        line,
        fault,
        label: label.to_owned(),
    };
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let columns: Vec<&str> = header.split(',').collect();
    // Numbers need no quotes, so lines are rows; a reader of CSV would lose count at blank ones.
    let mut lines = (1..)
        .zip(text.lines())
        .filter(|(_, text)| !text.trim().is_empty())
        .map(|(line, text)| (line, text.split(',').map(str::trim).collect::<Vec<_>>()));
    match lines.next() {
        Some((line, found)) if found != columns => {
            let text = format!(
                "expected the header `{header}`, found `{}`",
                found.join(",")
            );
            return Err(fault(line, text, "the header of this file is wrong"));
        }
        _ => {}
    }
    let mut rows = Vec::new();
    for (line, entries) in lines {
        if entries.len() != columns.len() {
            let text = format!(
                "expected {} entries, found {}",
                columns.len(),
                entries.len()
            );
            return Err(fault(line, text, "a row of this file has the wrong length"));
        }
        let mut numbers = Vec::with_capacity(columns.len());
        for (entry, column) in entries.into_iter().zip(&columns) {
            match entry.parse::<f64>() {
                Ok(number) if number.is_finite() => numbers.push(number),
                _ => {
                    let text = format!("expected a finite number for {column}, found `{entry}`");
                    return Err(fault(line, text, "an entry of this file is no number"));
                }
            }
        }
        // The value comes last, behind as many coordinates as the case has.
        let value = numbers.pop().unwrap_or(f64::NAN);
        if value < 0.0 {
            let text = format!("{what} must not be negative, found {value:?}");
            return Err(fault(line, text, "a value of this file is negative"));
        }
        numbers.resize(3, 0.0);
        rows.push(([numbers[0], numbers[1], numbers[2]], value));
    }
    if rows.is_empty() {
        let text = "expected at least one row of values behind the header".to_owned();
        return Err(fault(1, text, "this file has no values"));
    }
    Ok(rows)
}
