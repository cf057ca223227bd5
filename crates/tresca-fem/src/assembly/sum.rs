//! Sums of symmetric matrices by columns.

use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use std::iter::Peekable;
use tresca_la::SymmetricMatrix;

/// The sum of two matrices of order n, given column by column: (row, value) from the diagonal downwards, rows
/// ascending, of the second also repeated (values of one row are added up). `entries` is about how many there
/// will be.
pub(crate) fn sum_of_columns<A, B>(
    n: usize,
    entries: usize,
    first: impl Fn(usize) -> A,
    second: impl Fn(usize) -> B,
) -> SymmetricMatrix
where
    A: Iterator<Item = (usize, f64)>,
    B: Iterator<Item = (usize, f64)>,
{
    let (mut rows, mut values) = (Vec::with_capacity(entries), Vec::with_capacity(entries));
    let mut starts = Vec::with_capacity(n + 1);
    starts.push(0);
    for j in 0..n {
        let mut added = second(j).peekable();
        for (row, value) in first(j) {
            while let Some(&(before, _)) = added.peek().filter(|&&(other, _)| other < row) {
                rows.push(before);
                values.push(sum_of_row(&mut added, before).unwrap_or(0.0));
            }
            rows.push(row);
            values.push(value + sum_of_row(&mut added, row).unwrap_or(0.0));
        }
        while let Some(&(row, _)) = added.peek() {
            rows.push(row);
            values.push(sum_of_row(&mut added, row).unwrap_or(0.0));
        }
        starts.push(rows.len());
    }
    let pattern = SymbolicSparseColMat::new_checked(n, n, starts, None, rows);
    SymmetricMatrix::from_lower(SparseColMat::new(pattern, values))
}

/// Takes the next entries as long as they belong to the row, and adds them up; `None` if there is none.
fn sum_of_row(
    entries: &mut Peekable<impl Iterator<Item = (usize, f64)>>,
    row: usize,
) -> Option<f64> {
    let mut sum = entries.next_if(|&(other, _)| other == row)?.1;
    while let Some((_, value)) = entries.next_if(|&(other, _)| other == row) {
        sum += value;
    }
    Some(sum)
}
