//! Arrays as they stand in a file.

/// A sparse matrix as triplets, in no special order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sparse {
    /// Rows and columns.
    pub shape: (usize, usize),
    /// Row of each entry, from 0.
    pub rows: Vec<usize>,
    /// Column of each entry, from 0.
    pub columns: Vec<usize>,
    /// The entries.
    pub values: Vec<f64>,
}

/// A dense array, the last index running fastest.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DenseArray {
    /// Its extents; empty for a single number.
    pub shape: Vec<usize>,
    /// The values.
    pub values: Vec<f64>,
}

impl DenseArray {
    /// A vector.
    pub fn vector(values: Vec<f64>) -> Self {
        Self {
            shape: vec![values.len()],
            values,
        }
    }

    /// Its extents in words, such as `4 × 2`.
    pub fn size(&self) -> String {
        match &self.shape[..] {
            [] => "a single number".to_owned(),
            [length] => format!("{length} numbers"),
            extents => extents
                .iter()
                .map(usize::to_string)
                .collect::<Vec<_>>()
                .join(" × "),
        }
    }

    /// The values as a vector; a matrix of one row or column is one, too.
    pub fn into_vector(self) -> Result<Vec<f64>, Self> {
        match self.shape[..] {
            [_] | [_, 1] | [1, _] => Ok(self.values),
            _ => Err(self),
        }
    }
}

impl Sparse {
    /// The entries of a dense matrix that are not zero. `None` for something that is no matrix.
    pub fn from_dense(dense: &DenseArray) -> Option<Self> {
        let [rows, columns] = dense.shape[..] else {
            return None;
        };
        let mut sparse = Self {
            shape: (rows, columns),
            ..Self::default()
        };
        for (place, &value) in dense.values.iter().enumerate() {
            // NaN is kept: it is for the solver to complain.
            if value != 0.0 {
                sparse.push(place / columns, place % columns, value);
            }
        }
        Some(sparse)
    }

    /// Adds an entry.
    pub fn push(&mut self, row: usize, column: usize, value: f64) {
        self.rows.push(row);
        self.columns.push(column);
        self.values.push(value);
    }
}
