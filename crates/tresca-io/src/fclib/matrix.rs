//! A sparse matrix as plain data.

use crate::fclib::error::Defect;

/// A sparse matrix: its entries by rows, columns ascending within a row, no place twice.
#[derive(Clone, Debug, PartialEq)]
pub struct FclibMatrix {
    rows: usize,
    columns: usize,
    entries: Vec<(usize, usize, f64)>,
}

impl FclibMatrix {
    /// From entries (row, column, value) in any order. Values at the same place add up, as they do in
    /// every triplet format; zeros are dropped.
    ///
    /// # Errors
    /// [`Defect::Outside`] and [`Defect::NotFinite`].
    pub fn new(
        rows: usize,
        columns: usize,
        mut entries: Vec<(usize, usize, f64)>,
    ) -> Result<Self, Defect> {
        for (index, &(row, column, value)) in entries.iter().enumerate() {
            if row >= rows || column >= columns {
                return Err(Defect::Outside {
                    row,
                    column,
                    rows,
                    columns,
                });
            }
            if !value.is_finite() {
                return Err(Defect::NotFinite { index, value });
            }
        }
        // Stable: the sum of values at one place does not depend on the sorting.
        entries.sort_by_key(|&(row, column, _)| (row, column));
        entries.dedup_by(|next, kept| {
            let same = (next.0, next.1) == (kept.0, kept.1);
            if same {
                kept.2 += next.2;
            }
            same
        });
        entries.retain(|&(_, _, value)| value != 0.0);
        Ok(Self {
            rows,
            columns,
            entries,
        })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// (row, column, value), counted from 0, by rows.
    pub fn entries(&self) -> &[(usize, usize, f64)] {
        &self.entries
    }

    /// A x.
    ///
    /// # Panics
    /// When x has not as many values as there are columns.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        assert_eq!(x.len(), self.columns, "a vector for the columns");
        let mut y = vec![0.0; self.rows];
        for &(row, column, value) in &self.entries {
            y[row] += value * x[column];
        }
        y
    }

    /// Aᵀ x.
    ///
    /// # Panics
    /// When x has not as many values as there are rows.
    pub fn transposed_times(&self, x: &[f64]) -> Vec<f64> {
        assert_eq!(x.len(), self.rows, "a vector for the rows");
        let mut y = vec![0.0; self.columns];
        for &(row, column, value) in &self.entries {
            y[column] += value * x[row];
        }
        y
    }

    /// Whether storing all entries, zeros included, takes no more than row, column and value of each.
    pub(super) fn is_rather_dense(&self) -> bool {
        3 * self.entries.len() >= self.rows * self.columns
    }
}

/// Checks that pointers to the first entry of each row (column, block row) rise from 0 to at most the
/// number of entries.
pub(super) fn check_pointers(pointers: &[usize], entries: usize) -> Result<(), Defect> {
    let mut before = 0;
    for (index, &pointer) in pointers.iter().enumerate() {
        let begins_wrong = index == 0 && pointer != 0;
        if begins_wrong || pointer < before || pointer > entries {
            let found = i64::try_from(pointer).unwrap_or(i64::MAX);
            return Err(Defect::Pointers {
                index,
                found,
                entries,
            });
        }
        before = pointer;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_sorted_summed_and_checked() {
        let entries = vec![(1, 0, 2.0), (0, 1, 1.0), (1, 0, 3.0), (0, 0, 0.0)];
        let matrix = FclibMatrix::new(2, 3, entries).unwrap();
        assert_eq!(matrix.entries(), [(0, 1, 1.0), (1, 0, 5.0)]);
        assert_eq!(matrix.times(&[1.0, 2.0, 4.0]), [2.0, 5.0]);
        assert_eq!(matrix.transposed_times(&[1.0, 2.0]), [10.0, 1.0, 0.0]);

        let outside = FclibMatrix::new(2, 3, vec![(2, 0, 1.0)]).unwrap_err();
        assert!(matches!(outside, Defect::Outside { row: 2, .. }));
        let infinite = FclibMatrix::new(1, 1, vec![(0, 0, f64::INFINITY)]).unwrap_err();
        assert!(matches!(infinite, Defect::NotFinite { index: 0, .. }));
    }
}
