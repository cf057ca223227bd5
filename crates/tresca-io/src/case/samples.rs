//! Values at points, from a table in a file.

use std::path::Path;
use std::sync::Arc;

use rstar::RTree;
use rstar::primitives::GeomWithData;
use toml::Spanned;

use super::check::Check;
use super::error::{CaseError, FaultKind};

/// Values at points, read from a CSV file: everywhere else, the value of the nearest point holds.
/// Cheap to clone.
#[derive(Clone, Debug)]
pub struct Samples {
    file: Arc<str>,
    /// Row numbers with the points, so that the first of several nearest rows can be taken.
    tree: Arc<RTree<GeomWithData<[f64; 3], usize>>>,
    values: Arc<[f64]>,
}

impl Samples {
    /// Of points and their values; at least one, all finite.
    fn new(file: &str, rows: Vec<([f64; 3], f64)>) -> Self {
        let values = rows.iter().map(|(_, value)| *value).collect();
        let points = rows
            .into_iter()
            .enumerate()
            .map(|(row, (point, _))| GeomWithData::new(point, row))
            .collect();
        Self {
            file: file.into(),
            tree: Arc::new(RTree::bulk_load(points)),
            values,
        }
    }

    /// The path of the file as the case file gives it.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there are no rows; never, of a case file that was read.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
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

impl Check<'_> {
    /// Reads the table of a slip bound; `what` names the quantity in reports.
    pub(super) fn samples(&self, what: &str, file: &Spanned<String>) -> Result<Samples, CaseError> {
        let fail = |message: String, label: String, help: String| -> CaseError {
            self.fault(FaultKind::BadFile, file.span(), message, label)
                .with_help(help)
                .into()
        };
        let name = file.get_ref();
        let directory = Path::new(self.source.name()).parent();
        let path = directory.unwrap_or(Path::new("")).join(name);
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
        read_rows(&text, header, what)
            .map(|rows| Samples::new(name, rows))
            .map_err(|TableFault { line, fault, label }| {
                fail(
                    format!("{}:{line}: {fault}", path.display()),
                    label,
                    format!("a table of values is a CSV file with the header `{header}`"),
                )
            })
    }
}

/// What is wrong with a table.
struct TableFault {
    /// From 1.
    line: u64,
    fault: String,
    label: String,
}

/// The rows of a table with this header: a point, then a value that is 0 or more.
fn read_rows(text: &str, header: &str, what: &str) -> Result<Vec<([f64; 3], f64)>, TableFault> {
    let fault = |line: u64, fault: String, label: &str| TableFault {
        line,
        fault,
        label: label.to_owned(),
    };
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let columns: Vec<&str> = header.split(',').collect();
    let mut rows = Vec::new();
    let mut head = true;
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = error.position().map_or(1, csv::Position::line);
            fault(line, error.to_string(), "this file")
        })?;
        let line = record.position().map_or(1, csv::Position::line);
        if head {
            if !record.iter().eq(columns.iter().copied()) {
                let found = record.iter().collect::<Vec<_>>().join(",");
                let text = format!("expected the header `{header}`, found `{found}`");
                return Err(fault(line, text, "the header of this file is wrong"));
            }
            head = false;
            continue;
        }
        if record.len() != columns.len() {
            let text = format!("expected {} entries, found {}", columns.len(), record.len());
            return Err(fault(line, text, "a row of this file has the wrong length"));
        }
        let mut point = [0.0; 3];
        let mut value = 0.0;
        for (i, entry) in record.iter().enumerate() {
            let number: f64 = entry
                .parse()
                .ok()
                .filter(|number: &f64| number.is_finite())
                .ok_or_else(|| {
                    let text = format!(
                        "expected a finite number for {}, found `{entry}`",
                        columns[i]
                    );
                    fault(line, text, "an entry of this file is no number")
                })?;
            match point[..columns.len() - 1].get_mut(i) {
                Some(coordinate) => *coordinate = number,
                None => value = number,
            }
        }
        if value < 0.0 {
            let text = format!("{what} must not be negative, found {value:?}");
            return Err(fault(line, text, "a value of this file is negative"));
        }
        rows.push((point, value));
    }
    if rows.is_empty() {
        let text = "expected at least one row of values behind the header".to_owned();
        return Err(fault(1, text, "this file has no values"));
    }
    Ok(rows)
}
