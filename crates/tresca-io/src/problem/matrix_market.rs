//! Folders of Matrix Market files, one array each, and `problem.toml` for words and single numbers.
//!
//! The format: R. F. Boisvert, R. Pozo, K. A. Remington, *The Matrix Market exchange formats: initial design*,
//! NISTIR 5935, 1996. Read here: `coordinate` and `array`, `real` and `integer` (and `pattern` not: there is
//! no matrix of ones here), `general` and `symmetric`.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use super::content::Source;
use crate::atomic::OutputSet;
use crate::error::WriteError;
use crate::problem::arrays::{DenseArray, Sparse};
use crate::problem::content::{Content, Words};
use crate::problem::error::{ProblemError, ProblemFault};

/// Words and single numbers.
const TABLE: &str = "problem.toml";

/// A folder that is read.
pub(super) struct Folder {
    path: PathBuf,
    /// Names of the `.mtx` files without the extension.
    files: Vec<String>,
    table: toml::Table,
}

impl Folder {
    pub fn open(path: &Path) -> Result<Self, ProblemError> {
        let mut files = Vec::new();
        for entry in fs::read_dir(path).map_err(ProblemFault::io(path))? {
            let file = entry.map_err(ProblemFault::io(path))?.path();
            if file.extension().is_some_and(|extension| extension == "mtx")
                && let Some(stem) = file.file_stem().and_then(|stem| stem.to_str())
            {
                files.push(stem.to_owned());
            }
        }
        files.sort();
        let file = path.join(TABLE);
        let table = if file.exists() {
            let text = fs::read_to_string(&file).map_err(ProblemFault::io(&file))?;
            text.parse().map_err(|error: toml::de::Error| {
                let offset = error.span().map_or(0, |span| span.start);
                let before = &text.as_bytes()[..offset.min(text.len())];
                let line = 1 + before.iter().filter(|byte| **byte == b'\n').count();
                ProblemFault::Line {
                    expected: "TOML".to_owned(),
                    found: error.message().to_owned(),
                }
                .on(&file, line)
            })?
        } else {
            toml::Table::new()
        };
        if let Some(key) = files.iter().find(|key| table.contains_key(*key)) {
            return Err(ProblemFault::Wrong {
                expected: format!("it in one place: here or in {key}.mtx"),
                found: "both".to_owned(),
            }
            .at(&file, key.clone()));
        }
        Ok(Self {
            path: path.to_owned(),
            files,
            table,
        })
    }

    fn wrong(&self, key: &str, expected: &str, found: impl Into<String>) -> ProblemError {
        ProblemFault::Wrong {
            expected: expected.to_owned(),
            found: found.into(),
        }
        .at(self.path.join(TABLE), key)
    }

    fn file(&self, key: &str) -> Result<File, ProblemError> {
        let path = self.path.join(format!("{key}.mtx"));
        let text = fs::read_to_string(&path).map_err(ProblemFault::io(&path))?;
        parse(&path, &text)
    }
}

impl Source for Folder {
    fn path(&self) -> &Path {
        &self.path
    }

    fn keys(&self) -> Vec<String> {
        let table = self.table.keys().filter(|key| *key != "info");
        self.files.iter().chain(table).cloned().collect()
    }

    fn sparse(&mut self, key: &str) -> Result<Sparse, ProblemError> {
        if self.table.contains_key(key) {
            return Err(self.wrong(key, &format!("a matrix, in {key}.mtx"), "a value"));
        }
        Ok(match self.file(key)? {
            File::Sparse(sparse) => sparse,
            // An array file always has two extents.
            File::Dense(dense) => Sparse::from_dense(&dense).unwrap_or_default(),
        })
    }

    fn dense(&mut self, key: &str) -> Result<DenseArray, ProblemError> {
        if let Some(value) = self.table.get(key) {
            let number = |value: &toml::Value| {
                value
                    .as_float()
                    .or_else(|| value.as_integer().map(|integer| integer as f64))
            };
            let dense = match value {
                toml::Value::Array(values) => values
                    .iter()
                    .map(number)
                    .collect::<Option<Vec<_>>>()
                    .map(DenseArray::vector),
                value => number(value).map(|value| DenseArray {
                    shape: Vec::new(),
                    values: vec![value],
                }),
            };
            return dense
                .ok_or_else(|| self.wrong(key, "a number or a list of numbers", value.type_str()));
        }
        Ok(match self.file(key)? {
            File::Dense(mut dense) => {
                // A column is a vector.
                if let [length, 1] = dense.shape[..] {
                    dense.shape = vec![length];
                }
                dense
            }
            File::Sparse(sparse) => {
                let (rows, columns) = sparse.shape;
                let mut values = vec![0.0; rows * columns];
                let entries = sparse.rows.iter().zip(&sparse.columns).zip(&sparse.values);
                entries.for_each(|((&i, &j), &value)| values[columns * i + j] += value);
                let shape = if columns == 1 {
                    vec![rows]
                } else {
                    vec![rows, columns]
                };
                DenseArray { shape, values }
            }
        })
    }

    fn words(&mut self, key: &str) -> Result<Words, ProblemError> {
        let word = |value: &toml::Value| value.as_str().map(str::to_owned);
        match self.table.get(key) {
            Some(toml::Value::Array(values)) => values.iter().map(word).collect::<Option<_>>(),
            Some(value) => word(value).map(|word| vec![word]),
            None => None,
        }
        .ok_or_else(|| self.wrong(key, "a word or a list of words", "something else"))
    }
}

/// What a file holds.
enum File {
    Sparse(Sparse),
    Dense(DenseArray),
}

/// The lines of a file that say something, with their numbers.
struct Lines<'a> {
    path: &'a Path,
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    last: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self, expected: &str) -> Result<&'a str, ProblemError> {
        for (index, line) in self.lines.by_ref() {
            self.last = index + 1;
            let line = line.trim();
            if !(line.is_empty() || line.starts_with('%')) {
                return Ok(line);
            }
        }
        self.last += 1;
        Err(self.wrong(expected, "the end of the file"))
    }

    fn wrong(&self, expected: &str, found: &str) -> ProblemError {
        ProblemFault::Line {
            expected: expected.to_owned(),
            found: found.to_owned(),
        }
        .on(self.path, self.last)
    }

    fn counts<const N: usize>(&mut self, expected: &str) -> Result<[usize; N], ProblemError> {
        let line = self.next(expected)?;
        let counts: Result<Vec<usize>, _> = line.split_whitespace().map(str::parse).collect();
        let counts = counts.ok().and_then(|counts| counts.try_into().ok());
        counts.ok_or_else(|| self.wrong(expected, &format!("`{line}`")))
    }
}

fn parse(path: &Path, text: &str) -> Result<File, ProblemError> {
    let mut lines = Lines {
        path,
        lines: text.lines().enumerate(),
        last: 1,
    };
    let header = lines
        .lines
        .next()
        .map_or("", |(_, line)| line)
        .to_lowercase();
    let words: Vec<&str> = header.split_whitespace().collect();
    let expected = "`%%MatrixMarket matrix coordinate|array real|integer general|symmetric`";
    let (coordinate, symmetric) = match words[..] {
        [
            "%%matrixmarket",
            "matrix",
            format @ ("coordinate" | "array"),
            "real" | "integer" | "double",
            symmetry @ ("general" | "symmetric"),
        ] => (format == "coordinate", symmetry == "symmetric"),
        _ => return Err(lines.wrong(expected, &format!("`{header}`"))),
    };
    let file = if coordinate {
        File::Sparse(coordinates(&mut lines, symmetric)?)
    } else {
        File::Dense(array(&mut lines, symmetric)?)
    };
    match lines.next("") {
        Ok(line) => Err(lines.wrong("the end of the file", &format!("`{line}`"))),
        Err(_) => Ok(file),
    }
}

fn coordinates(lines: &mut Lines<'_>, symmetric: bool) -> Result<Sparse, ProblemError> {
    let [rows, columns, entries] = lines.counts("rows, columns and number of entries")?;
    let mut sparse = Sparse {
        shape: (rows, columns),
        ..Sparse::default()
    };
    let expected = "a row, a column (counted from 1) and a number";
    for _ in 0..entries {
        let line = lines.next(&format!("{entries} entries"))?;
        let mut words = line.split_whitespace();
        let mut index = |count: usize| {
            let index: usize = words.next()?.parse().ok()?;
            (1..=count).contains(&index).then(|| index - 1)
        };
        let place = index(rows).and_then(|row| Some((row, index(columns)?)));
        let value = words.next().and_then(|word| word.parse().ok());
        let (Some((row, column)), Some(value), None) = (place, value, words.next()) else {
            return Err(lines.wrong(expected, &format!("`{line}`")));
        };
        sparse.push(row, column, value);
        if symmetric && row != column {
            sparse.push(column, row, value);
        }
    }
    Ok(sparse)
}

/// Arrays stand by columns; of symmetric ones the lower triangle.
fn array(lines: &mut Lines<'_>, symmetric: bool) -> Result<DenseArray, ProblemError> {
    let [rows, columns] = lines.counts("rows and columns")?;
    let mut values = vec![0.0; rows * columns];
    for column in 0..columns {
        for row in if symmetric { column } else { 0 }..rows {
            let line = lines.next(&format!("{rows} × {columns} numbers"))?;
            let Ok(value) = line.parse() else {
                return Err(lines.wrong("a number", &format!("`{line}`")));
            };
            values[columns * row + column] = value;
            if symmetric && column < rows && row < columns {
                values[columns * column + row] = value;
            }
        }
    }
    Ok(DenseArray {
        shape: vec![rows, columns],
        values,
    })
}

/// Stages a problem as a folder of files.
///
/// # Errors
/// [`WriteError`] from the set; NaN is refused.
pub fn write_folder(files: &mut OutputSet, content: &Content) -> Result<(), WriteError> {
    let parts = content.parts();
    let mut table = toml::Table::new();
    for (key, matrix) in &parts.sparse {
        check_finite(key, &matrix.values)?;
        let text = coordinate_text(matrix, key.starts_with('K'));
        files.stage(&format!("{key}.mtx"), |out| {
            Ok(out.write_all(text.as_bytes())?)
        })?;
    }
    for (key, array) in &parts.dense {
        if *key == "limits" && array.values.iter().all(|value| *value == f64::INFINITY) {
            continue;
        }
        match array.shape[..] {
            [] => {
                table.insert((*key).to_owned(), array.values[0].into());
            }
            _ if *key == "limits" => {
                // TOML has a word for infinity, Matrix Market has none.
                let values = array.values.iter().map(|&value| toml::Value::Float(value));
                table.insert((*key).to_owned(), toml::Value::Array(values.collect()));
            }
            _ => {
                check_finite(key, &array.values)?;
                let text = array_text(array);
                files.stage(&format!("{key}.mtx"), |out| {
                    Ok(out.write_all(text.as_bytes())?)
                })?;
            }
        }
    }
    if let Some(law) = parts.law {
        let value = match &law[..] {
            [law] => law.clone().into(),
            laws => toml::Value::Array(laws.iter().map(|law| law.clone().into()).collect()),
        };
        table.insert("law".to_owned(), value);
    }
    files.stage(
        TABLE,
        |out| Ok(out.write_all(table.to_string().as_bytes())?),
    )
}

fn check_finite(key: &str, values: &[f64]) -> Result<(), WriteError> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(WriteError::NotFinite {
            field: key.to_owned(),
            place: format!("entry {index}"),
            value: values[index],
        }),
    }
}

fn coordinate_text(matrix: &Sparse, symmetric: bool) -> String {
    let stored = |k: &usize| !symmetric || matrix.rows[*k] >= matrix.columns[*k];
    let entries: Vec<usize> = (0..matrix.values.len()).filter(stored).collect();
    let kind = if symmetric { "symmetric" } else { "general" };
    let (rows, columns) = matrix.shape;
    let mut text = format!("%%MatrixMarket matrix coordinate real {kind}\n");
    let _ = writeln!(text, "{rows} {columns} {}", entries.len());
    for k in entries {
        // The shortest digits that read back to the same number.
        let _ = writeln!(
            text,
            "{} {} {:?}",
            matrix.rows[k] + 1,
            matrix.columns[k] + 1,
            matrix.values[k]
        );
    }
    text
}

fn array_text(array: &DenseArray) -> String {
    let (rows, columns) = match array.shape[..] {
        [rows, columns] => (rows, columns),
        _ => (array.values.len(), 1),
    };
    let mut text = format!("%%MatrixMarket matrix array real general\n{rows} {columns}\n");
    for column in 0..columns {
        for row in 0..rows {
            let _ = writeln!(text, "{:?}", array.values[columns * row + column]);
        }
    }
    text
}
