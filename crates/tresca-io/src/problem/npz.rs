//! NumPy archives: ZIP files of `.npy` arrays.

use std::fs::File;
use std::io::{BufReader, Cursor, Read, Seek, Write};
use std::path::{Path, PathBuf};

use npyz::{DType, NpyFile, Order, TypeChar, WriterBuilder};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use super::content::Source;
use crate::error::WriteError;
use crate::problem::arrays::{DenseArray, Sparse};
use crate::problem::content::{Content, Words};
use crate::problem::error::{ProblemError, ProblemFault};

/// Parts of a sparse matrix, as `scipy.sparse.save_npz` calls them.
const PARTS: [&str; 7] = ["data", "indices", "indptr", "shape", "format", "row", "col"];

/// Parts that `save_npz` may write and that say nothing here.
const IGNORED_PARTS: [&str; 1] = ["_is_array"];

/// An archive that is read.
pub(super) struct Reader {
    path: PathBuf,
    archive: ZipArchive<BufReader<File>>,
    /// Names of all arrays.
    names: Vec<String>,
}

/// An array as it was found, numbers not looked at yet.
enum Found {
    Numbers(DenseArray),
    Words(Words),
}

impl Reader {
    pub fn open(path: &Path) -> Result<Self, ProblemError> {
        let file = File::open(path).map_err(ProblemFault::io(path))?;
        let archive = ZipArchive::new(BufReader::new(file))
            .map_err(|error| ProblemError::new(ProblemFault::Archive(error.to_string()), path))?;
        let names = (0..archive.len()).filter_map(|index| {
            let name = archive.name_for_index(index)?.ok()?;
            npyz::npz::array_name_from_file_name(&name).map(str::to_owned)
        });
        let names = names.collect();
        Ok(Self {
            path: path.to_owned(),
            archive,
            names,
        })
    }

    fn wrong(&self, key: &str, expected: &str, found: impl Into<String>) -> ProblemError {
        ProblemFault::Wrong {
            expected: expected.to_owned(),
            found: found.into(),
        }
        .at(&self.path, key)
    }

    fn has(&self, name: &str) -> bool {
        self.names.iter().any(|own| own == name)
    }

    fn array(&mut self, name: &str) -> Result<Found, ProblemError> {
        let path = self.path.clone();
        let refuse = |found: String| {
            ProblemFault::Wrong {
                expected: "an array of numbers or words".to_owned(),
                found,
            }
            .at(&path, name)
        };
        let file = self
            .archive
            .by_name(&npyz::npz::file_name_from_array_name(name))
            .map_err(|error| refuse(error.to_string()))?;
        let file = NpyFile::new(file).map_err(|error| refuse(error.to_string()))?;
        read_array(file).map_err(refuse)
    }

    /// An array of numbers.
    fn numbers(&mut self, name: &str) -> Result<DenseArray, ProblemError> {
        match self.array(name)? {
            Found::Numbers(dense) => Ok(dense),
            Found::Words(_) => Err(self.wrong(name, "numbers", "words")),
        }
    }

    /// An array of counts.
    fn counts(&mut self, name: &str) -> Result<Vec<usize>, ProblemError> {
        let numbers = self.numbers(name)?;
        let count = |&x: &f64| (x >= 0.0 && x.fract() == 0.0 && x < 9e15).then_some(x as usize);
        let counts: Option<Vec<usize>> = numbers.values.iter().map(count).collect();
        counts.ok_or_else(|| self.wrong(name, "whole numbers ≥ 0", "others"))
    }

    /// A matrix from its parts.
    fn joined(&mut self, key: &str) -> Result<Sparse, ProblemError> {
        let part = |name: &str| format!("{key}/{name}");
        let shape = self.counts(&part("shape"))?;
        let [rows, columns] = shape[..] else {
            return Err(self.wrong(
                &part("shape"),
                "two numbers",
                format!("{} numbers", shape.len()),
            ));
        };
        let values = self.numbers(&part("data"))?.values;
        let format = if self.has(&part("format")) {
            match self.array(&part("format"))? {
                Found::Words(words) if words.len() == 1 => words[0].clone(),
                _ => return Err(self.wrong(&part("format"), "one word", "something else")),
            }
        } else if self.has(&part("row")) {
            "coo".to_owned()
        } else {
            return Err(ProblemFault::Missing {
                meaning: "`csr`, `csc` or `coo`",
            }
            .at(&self.path, part("format")));
        };
        let mut sparse = Sparse {
            shape: (rows, columns),
            values,
            ..Sparse::default()
        };
        match &format[..] {
            "coo" => {
                sparse.rows = self.counts(&part("row"))?;
                sparse.columns = self.counts(&part("col"))?;
            }
            "csr" => {
                sparse.columns = self.counts(&part("indices"))?;
                sparse.rows = self.lines(&part("indptr"), rows, sparse.columns.len())?;
            }
            "csc" => {
                sparse.rows = self.counts(&part("indices"))?;
                sparse.columns = self.lines(&part("indptr"), columns, sparse.rows.len())?;
            }
            other => {
                return Err(self.wrong(
                    &part("format"),
                    "`csr`, `csc` or `coo`",
                    format!("`{other}`"),
                ));
            }
        }
        let count = sparse.values.len();
        if sparse.rows.len() != count || sparse.columns.len() != count {
            let found = format!(
                "{} rows and {} columns",
                sparse.rows.len(),
                sparse.columns.len()
            );
            return Err(self.wrong(key, &format!("as many as values ({count})"), found));
        }
        let inside = |indices: &[usize], end: usize| indices.iter().all(|&index| index < end);
        if !(inside(&sparse.rows, rows) && inside(&sparse.columns, columns)) {
            let expected = format!("entries inside of the shape {rows} × {columns}");
            return Err(self.wrong(key, &expected, "one outside"));
        }
        Ok(sparse)
    }

    /// The row (column) of each entry from the starts of the rows (columns).
    fn lines(
        &mut self,
        name: &str,
        count: usize,
        entries: usize,
    ) -> Result<Vec<usize>, ProblemError> {
        let starts = self.counts(name)?;
        let ascending = starts.windows(2).all(|pair| pair[0] <= pair[1]);
        if starts.len() != count + 1 || starts[0] != 0 || starts[count] != entries || !ascending {
            let expected = format!("{} numbers ascending from 0 to {entries}", count + 1);
            return Err(self.wrong(name, &expected, "something else"));
        }
        let mut lines = vec![0; entries];
        for (line, range) in starts.windows(2).enumerate() {
            lines[range[0]..range[1]].fill(line);
        }
        Ok(lines)
    }
}

impl Source for Reader {
    fn path(&self) -> &Path {
        &self.path
    }

    fn keys(&self) -> Vec<String> {
        let mut keys = Vec::new();
        for name in &self.names {
            let key = match name.rsplit_once('/') {
                _ if name.starts_with("info/") => continue,
                Some((_, part)) if IGNORED_PARTS.contains(&part) => continue,
                Some((key, part)) if PARTS.contains(&part) => key,
                _ => name,
            };
            if !keys.iter().any(|known| known == key) {
                keys.push(key.to_owned());
            }
        }
        keys
    }

    fn sparse(&mut self, key: &str) -> Result<Sparse, ProblemError> {
        if !self.has(key) {
            return self.joined(key);
        }
        let dense = self.numbers(key)?;
        Sparse::from_dense(&dense).ok_or_else(|| {
            let expected = "a matrix: two-dimensional, or the parts of a sparse one";
            self.wrong(key, expected, dense.size())
        })
    }

    fn dense(&mut self, key: &str) -> Result<DenseArray, ProblemError> {
        if !self.has(key) {
            return Err(self.wrong(key, "a dense array", "parts of a sparse matrix"));
        }
        self.numbers(key)
    }

    fn words(&mut self, key: &str) -> Result<Words, ProblemError> {
        match self.array(key)? {
            Found::Words(words) => Ok(words),
            Found::Numbers(_) => Err(self.wrong(key, "words", "numbers")),
        }
    }
}

/// Reads an array of whatever type.
fn read_array(file: NpyFile<impl Read>) -> Result<Found, String> {
    let DType::Plain(kind) = file.dtype() else {
        return Err("a structured array".to_owned());
    };
    let shape: Vec<usize> = file
        .shape()
        .iter()
        .map(|&extent| usize::try_from(extent).map_err(|_| "an array too large".to_owned()))
        .collect::<Result<_, _>>()?;
    let by_columns = file.order() == Order::Fortran;
    let failed = |error: std::io::Error| error.to_string();
    macro_rules! numbers {
        ($type:ty) => {
            file.into_vec::<$type>()
                .map_err(failed)?
                .into_iter()
                .map(|x| x as f64)
                .collect()
        };
    }
    let values: Vec<f64> = match (kind.type_char(), kind.size_field()) {
        (TypeChar::Float, 8) => file.into_vec().map_err(failed)?,
        (TypeChar::Float, 4) => numbers!(f32),
        (TypeChar::Int, 8) => numbers!(i64),
        (TypeChar::Int, 4) => numbers!(i32),
        (TypeChar::Int, 2) => numbers!(i16),
        (TypeChar::Int, 1) => numbers!(i8),
        (TypeChar::Uint, 8) => numbers!(u64),
        (TypeChar::Uint, 4) => numbers!(u32),
        (TypeChar::Uint, 2) => numbers!(u16),
        (TypeChar::Uint, 1) => numbers!(u8),
        (TypeChar::Bool, _) => {
            let flags = file.into_vec::<bool>().map_err(failed)?;
            flags
                .into_iter()
                .map(|flag| f64::from(u8::from(flag)))
                .collect()
        }
        (TypeChar::UnicodeStr, _) => return file.into_vec().map(Found::Words).map_err(failed),
        (TypeChar::ByteStr, _) => {
            let words = file.into_vec::<Vec<u8>>().map_err(failed)?;
            let words = words.into_iter().map(String::from_utf8);
            return words
                .collect::<Result<_, _>>()
                .map(Found::Words)
                .map_err(|e| e.to_string());
        }
        _ => return Err(format!("the type {kind}")),
    };
    if values.len() != shape.iter().product::<usize>() {
        return Err("an array that ends early".to_owned());
    }
    let values = match shape[..] {
        [rows, columns] if by_columns => (0..rows * columns)
            .map(|k| values[k / columns + rows * (k % columns)])
            .collect(),
        _ => values,
    };
    Ok(Found::Numbers(DenseArray { shape, values }))
}

/// An archive that is written.
pub struct Archive<W: Write + Seek> {
    zip: ZipWriter<W>,
}

impl<W: Write + Seek> Archive<W> {
    /// An archive in the stream.
    pub fn new(stream: W) -> Self {
        Self {
            zip: ZipWriter::new(stream),
        }
    }

    /// Adds numbers.
    ///
    /// # Errors
    /// [`WriteError::NotFinite`] for NaN and infinity; those of the stream.
    pub fn numbers(
        &mut self,
        name: &str,
        shape: &[usize],
        values: &[f64],
    ) -> Result<(), WriteError> {
        if let Some(index) = values.iter().position(|value| !value.is_finite()) {
            return Err(WriteError::NotFinite {
                field: name.to_owned(),
                place: format!("index {index}"),
                value: values[index],
            });
        }
        self.write(name, shape, values.iter().copied())
    }

    /// Adds whole numbers.
    ///
    /// # Errors
    /// Those of the stream.
    pub fn counts(
        &mut self,
        name: &str,
        shape: &[usize],
        values: &[usize],
    ) -> Result<(), WriteError> {
        let integer = |&count: &usize| i64::try_from(count).unwrap_or(i64::MAX);
        self.write(name, shape, values.iter().map(integer))
    }

    /// Adds flags.
    ///
    /// # Errors
    /// Those of the stream.
    pub fn flags(&mut self, name: &str, values: &[bool]) -> Result<(), WriteError> {
        self.write(name, &[values.len()], values.iter().copied())
    }

    /// Adds words; a single one as a scalar.
    ///
    /// # Errors
    /// Those of the stream.
    pub fn words(&mut self, name: &str, values: &[String]) -> Result<(), WriteError> {
        let length = values
            .iter()
            .map(|word| word.chars().count())
            .max()
            .unwrap_or(0)
            .max(1);
        let kind = format!("<U{length}")
            .parse()
            .map_err(std::io::Error::other)?;
        let shape = [values.len() as u64];
        let shape = if values.len() == 1 {
            &[][..]
        } else {
            &shape[..]
        };
        self.begin(name)?;
        let options = npyz::WriteOptions::<str>::new()
            .dtype(DType::Plain(kind))
            .shape(shape);
        let mut writer = options.writer(&mut self.zip).begin_nd()?;
        for word in values {
            writer.push(word)?;
        }
        Ok(writer.finish()?)
    }

    /// Adds a sparse matrix as the parts of a `csr` one.
    ///
    /// # Errors
    /// As [`Archive::numbers`].
    pub fn sparse(&mut self, name: &str, matrix: &Sparse) -> Result<(), WriteError> {
        let (rows, columns) = matrix.shape;
        let mut order: Vec<usize> = (0..matrix.values.len()).collect();
        order.sort_by_key(|&k| (matrix.rows[k], matrix.columns[k]));
        let mut starts = vec![0; rows + 1];
        matrix.rows.iter().for_each(|&row| starts[row + 1] += 1);
        (0..rows).for_each(|row| starts[row + 1] += starts[row]);
        let indices: Vec<usize> = order.iter().map(|&k| matrix.columns[k]).collect();
        let values: Vec<f64> = order.iter().map(|&k| matrix.values[k]).collect();
        self.numbers(&format!("{name}/data"), &[values.len()], &values)?;
        self.counts(&format!("{name}/indices"), &[indices.len()], &indices)?;
        self.counts(&format!("{name}/indptr"), &[starts.len()], &starts)?;
        self.counts(&format!("{name}/shape"), &[2], &[rows, columns])?;
        self.words(&format!("{name}/format"), &["csr".to_owned()])
    }

    /// Ends the archive.
    ///
    /// # Errors
    /// Those of the stream.
    pub fn finish(self) -> Result<W, WriteError> {
        Ok(self.zip.finish().map_err(std::io::Error::from)?)
    }

    fn begin(&mut self, name: &str) -> Result<(), WriteError> {
        // Stored as `numpy.savez` does; files of 4 GiB and more need to be told beforehand.
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .large_file(true);
        let file = npyz::npz::file_name_from_array_name(name);
        Ok(self
            .zip
            .start_file(file, options)
            .map_err(std::io::Error::from)?)
    }

    fn write<T: npyz::AutoSerialize>(
        &mut self,
        name: &str,
        shape: &[usize],
        values: impl Iterator<Item = T>,
    ) -> Result<(), WriteError> {
        let shape: Vec<u64> = shape.iter().map(|&extent| extent as u64).collect();
        self.begin(name)?;
        let options = npyz::WriteOptions::new().default_dtype().shape(&shape);
        let mut writer = options.writer(&mut self.zip).begin_nd()?;
        writer.extend(values)?;
        Ok(writer.finish()?)
    }
}

impl Archive<Cursor<Vec<u8>>> {
    /// An archive in memory: streams of result files cannot go back, as ZIP wants it.
    pub fn in_memory() -> Self {
        Self::new(Cursor::new(Vec::new()))
    }

    /// Ends the archive and writes it to a stream.
    ///
    /// # Errors
    /// Those of the stream.
    pub fn finish_to(self, out: &mut dyn Write) -> Result<(), WriteError> {
        out.write_all(self.finish()?.get_ref())?;
        Ok(())
    }
}

/// Writes a problem as an archive.
///
/// # Errors
/// [`WriteError::NotFinite`]; those of the stream.
pub fn write_npz(out: &mut dyn Write, content: &Content) -> Result<(), WriteError> {
    let mut archive = Archive::in_memory();
    let parts = content.parts();
    for (key, matrix) in &parts.sparse {
        archive.sparse(key, matrix)?;
    }
    for (key, array) in &parts.dense {
        archive.limits_allowed(key, array)?;
    }
    if let Some(law) = parts.law {
        archive.words("law", law)?;
    }
    for (name, array) in &content.info {
        archive.numbers(&format!("info/{name}"), &array.shape, &array.values)?;
    }
    archive.finish_to(out)
}

impl<W: Write + Seek> Archive<W> {
    /// Numbers of a problem: a limit may be infinite.
    fn limits_allowed(&mut self, key: &str, array: &DenseArray) -> Result<(), WriteError> {
        if key == "limits" {
            return self.write(key, &array.shape, array.values.iter().copied());
        }
        self.numbers(key, &array.shape, &array.values)
    }
}
