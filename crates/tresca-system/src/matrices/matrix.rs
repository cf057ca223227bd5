//! Sparse matrices as they are handed in: by rows, by columns, as triplets, dense.

use super::error::MatrixError;

/// An integer that may count rows, columns or entries in the arrays of others.
pub trait Index: Copy {
    /// The same number; `None` when it is negative or too large.
    fn to_usize(self) -> Option<usize>;
}

macro_rules! index {
    ($($integer:ty),*) => {$(
        impl Index for $integer {
            fn to_usize(self) -> Option<usize> {
                usize::try_from(self).ok()
            }
        }
    )*};
}
index!(i32, i64, u32, u64, usize);

/// A sparse matrix: rows with ascending columns, every entry finite, none listed twice.
///
/// Entries that are handed in more than once are summed up, as finite element assembly means it.
/// Explicit zeros stay.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    columns: usize,
    starts: Vec<usize>,
    indices: Vec<usize>,
    values: Vec<f64>,
}

impl Matrix {
    /// Compressed rows, as of `scipy.sparse.csr_matrix`: row i has the entries
    /// `starts[i]..starts[i + 1]` of `indices` (their columns) and `values`.
    ///
    /// # Errors
    /// [`MatrixError`] for arrays that do not fit each other or the shape, and entries that are not finite.
    pub fn from_csr<I: Index>(
        (rows, columns): (usize, usize),
        starts: &[I],
        indices: &[I],
        values: &[f64],
    ) -> Result<Self, MatrixError> {
        let starts = checked_starts(starts, rows, indices.len())?;
        let indices = checked_indices("column", indices, columns)?;
        check_count(indices.len(), values)?;
        check_finite(values)?;
        Ok(canonical(columns, &starts, &indices, values))
    }

    /// Compressed columns, as of `scipy.sparse.csc_matrix`: column j has the entries
    /// `starts[j]..starts[j + 1]` of `indices` (their rows) and `values`.
    ///
    /// # Errors
    /// As [`Matrix::from_csr`].
    pub fn from_csc<I: Index>(
        (rows, columns): (usize, usize),
        starts: &[I],
        indices: &[I],
        values: &[f64],
    ) -> Result<Self, MatrixError> {
        let starts = checked_starts(starts, columns, indices.len())?;
        let indices = checked_indices("row", indices, rows)?;
        check_count(indices.len(), values)?;
        check_finite(values)?;
        let by_column = Self {
            columns: rows,
            starts,
            indices,
            values: values.to_vec(),
        };
        let rows = by_column.transposed();
        // Transposing sorts; what is listed twice is still to be summed up.
        Ok(canonical(
            columns,
            &rows.starts,
            &rows.indices,
            &rows.values,
        ))
    }

    /// Triplets, as of `scipy.sparse.coo_matrix`: entry k is `values[k]` at (`row[k]`, `column[k]`).
    ///
    /// # Errors
    /// As [`Matrix::from_csr`].
    pub fn from_triplets<I: Index>(
        (rows, columns): (usize, usize),
        row: &[I],
        column: &[I],
        values: &[f64],
    ) -> Result<Self, MatrixError> {
        let row = checked_indices("row", row, rows)?;
        let column = checked_indices("column", column, columns)?;
        check_count(row.len(), values)?;
        check_count(column.len(), values)?;
        check_finite(values)?;
        let mut starts = vec![0; rows + 1];
        row.iter().for_each(|&i| starts[i + 1] += 1);
        (0..rows).for_each(|i| starts[i + 1] += starts[i]);
        let mut next = starts.clone();
        let mut indices = vec![0; values.len()];
        let mut sorted = vec![0.0; values.len()];
        for ((&i, &j), &value) in row.iter().zip(&column).zip(values) {
            indices[next[i]] = j;
            sorted[next[i]] = value;
            next[i] += 1;
        }
        Ok(canonical(columns, &starts, &indices, &sorted))
    }

    /// A dense matrix, row by row; zeros are dropped.
    ///
    /// # Errors
    /// As [`Matrix::from_csr`].
    pub fn from_dense(
        (rows, columns): (usize, usize),
        values: &[f64],
    ) -> Result<Self, MatrixError> {
        check_count(rows * columns, values)?;
        check_finite(values)?;
        let mut matrix = Self::zeros(0, columns);
        for row in values.chunks_exact(columns.max(1)).take(rows) {
            let entries = row.iter().enumerate().filter(|(_, value)| **value != 0.0);
            matrix.push_row(entries.map(|(j, &value)| (j, value)));
        }
        Ok(matrix)
    }

    /// The zero matrix.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self {
            columns,
            starts: vec![0; rows + 1],
            indices: Vec::new(),
            values: Vec::new(),
        }
    }

    /// Appends a row with ascending columns.
    pub(crate) fn push_row(&mut self, entries: impl Iterator<Item = (usize, f64)>) {
        for (j, value) in entries {
            self.indices.push(j);
            self.values.push(value);
        }
        self.starts.push(self.indices.len());
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of stored entries.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// (column, value) of the entries of a row, columns ascending.
    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> + Clone {
        let range = self.starts[i]..self.starts[i + 1];
        let indices = self.indices[range.clone()].iter().copied();
        indices.zip(self.values[range].iter().copied())
    }

    /// Row starts, columns and values, as [`Matrix::from_csr`] takes them.
    pub fn csr(&self) -> (&[usize], &[usize], &[f64]) {
        (&self.starts, &self.indices, &self.values)
    }

    /// The rows `first..end`.
    pub fn rows_between(&self, first: usize, end: usize) -> Self {
        let range = self.starts[first]..self.starts[end];
        Self {
            columns: self.columns,
            starts: self.starts[first..=end]
                .iter()
                .map(|start| start - range.start)
                .collect(),
            indices: self.indices[range.clone()].to_vec(),
            values: self.values[range].to_vec(),
        }
    }

    /// The transpose.
    pub fn transposed(&self) -> Self {
        let mut starts = vec![0; self.columns + 1];
        self.indices.iter().for_each(|&j| starts[j + 1] += 1);
        (0..self.columns).for_each(|j| starts[j + 1] += starts[j]);
        let mut next = starts.clone();
        let mut indices = vec![0; self.values.len()];
        let mut values = vec![0.0; self.values.len()];
        for i in 0..self.rows() {
            for k in self.starts[i]..self.starts[i + 1] {
                let j = self.indices[k];
                indices[next[j]] = i;
                values[next[j]] = self.values[k];
                next[j] += 1;
            }
        }
        Self {
            columns: self.rows(),
            starts,
            indices,
            values,
        }
    }

    /// Multiplies all entries by a factor.
    pub(super) fn scale(&mut self, factor: f64) {
        self.values.iter_mut().for_each(|x| *x *= factor);
    }

    /// Every row times its factor.
    pub(super) fn with_rows_scaled(mut self, factors: &[f64]) -> Self {
        for (i, factor) in factors.iter().enumerate() {
            let row = self.starts[i]..self.starts[i + 1];
            self.values[row].iter_mut().for_each(|x| *x *= factor);
        }
        self
    }

    /// y ← y + M x.
    ///
    /// # Panics
    /// When the lengths do not fit.
    pub fn add_product(&self, x: &[f64], y: &mut [f64]) {
        assert_eq!(x.len(), self.columns);
        assert_eq!(y.len(), self.rows());
        for (i, y) in y.iter_mut().enumerate() {
            *y += self.row(i).map(|(j, value)| value * x[j]).sum::<f64>();
        }
    }

    /// x ← x + Mᵀ y.
    ///
    /// # Panics
    /// When the lengths do not fit.
    pub fn add_transposed_product(&self, y: &[f64], x: &mut [f64]) {
        assert_eq!(x.len(), self.columns);
        assert_eq!(y.len(), self.rows());
        for (i, y) in y.iter().enumerate() {
            self.row(i).for_each(|(j, value)| x[j] += value * y);
        }
    }

    /// Largest absolute value.
    pub(crate) fn largest(&self) -> f64 {
        crate::measures::largest(&self.values)
    }
}

/// Sorts every row by columns and sums up what is listed twice.
fn canonical(columns: usize, starts: &[usize], indices: &[usize], values: &[f64]) -> Matrix {
    let ascending = starts.windows(2).all(|row| {
        indices[row[0]..row[1]]
            .windows(2)
            .all(|pair| pair[0] < pair[1])
    });
    if ascending {
        return Matrix {
            columns,
            starts: starts.to_vec(),
            indices: indices.to_vec(),
            values: values.to_vec(),
        };
    }
    let mut matrix = Matrix::zeros(0, columns);
    let mut row: Vec<(usize, f64)> = Vec::new();
    for range in starts.windows(2).map(|row| row[0]..row[1]) {
        row.clear();
        let entries = indices[range.clone()].iter().copied();
        row.extend(entries.zip(values[range].iter().copied()));
        // Stable: the order of summation is that of the input.
        row.sort_by_key(|&(j, _)| j);
        row.dedup_by(|next, kept| {
            let twice = next.0 == kept.0;
            if twice {
                kept.1 += next.1;
            }
            twice
        });
        matrix.push_row(row.iter().copied());
    }
    matrix
}

fn checked_starts<I: Index>(
    starts: &[I],
    lines: usize,
    entries: usize,
) -> Result<Vec<usize>, MatrixError> {
    if starts.len() != lines + 1 {
        return Err(MatrixError::StartCount {
            expected: lines + 1,
            found: starts.len(),
        });
    }
    let checked: Option<Vec<usize>> = starts.iter().map(|start| start.to_usize()).collect();
    match checked {
        Some(starts)
            if starts[0] == 0
                && starts[lines] == entries
                && starts.windows(2).all(|pair| pair[0] <= pair[1]) =>
        {
            Ok(starts)
        }
        _ => Err(MatrixError::Starts { entries }),
    }
}

fn checked_indices<I: Index>(
    what: &'static str,
    indices: &[I],
    count: usize,
) -> Result<Vec<usize>, MatrixError> {
    let check = |(entry, index): (usize, &I)| {
        let index = index.to_usize().filter(|&index| index < count);
        index.ok_or(MatrixError::Index { what, entry, count })
    };
    indices.iter().enumerate().map(check).collect()
}

fn check_count(expected: usize, values: &[f64]) -> Result<(), MatrixError> {
    match values.len() {
        found if found == expected => Ok(()),
        found => Err(MatrixError::ValueCount { expected, found }),
    }
}

fn check_finite(values: &[f64]) -> Result<(), MatrixError> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(entry) => Err(MatrixError::NotFinite {
            entry,
            value: values[entry],
        }),
        None => Ok(()),
    }
}
