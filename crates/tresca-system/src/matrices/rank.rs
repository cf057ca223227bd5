//! Rows of B that depend on others: with them A is singular.

use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use tresca_la::{Ordering, SymmetricMatrix};

use super::matrix::Matrix;

/// Squared distance of a row of unit length from the span of the others below which it is in it.
const DEPENDENT: f64 = 1e-12;

/// Up to this many rows the natural order is kept: of rows that depend on each other, the last is named.
const NATURAL_UP_TO: usize = 600;

/// How far the rows of B are from depending on each other.
#[derive(Debug)]
pub(super) struct Dependence {
    /// Rows, ascending, that are in the span of others, or so near that it makes no difference to A.
    pub rows: Vec<usize>,
    /// The smallest distance of a row of unit length from the span of the others that is no rounding; at most 1.
    pub distance: f64,
}

/// Squared distances below this are rounding.
const ROUNDING: f64 = 1e-15;

/// The rows, ascending, without which the others have full rank; rows that are zero are left aside.
///
/// By a sparse Cholesky factorisation of BBᵀ (rows scaled to length 1) that takes a row out as soon as
/// its pivot vanishes.
pub(super) fn dependent_rows(b: &Matrix) -> Dependence {
    let lengths: Vec<f64> = (0..b.rows())
        .map(|i| b.row(i).map(|(_, value)| value * value).sum::<f64>().sqrt())
        .collect();
    let gram = gram(b, &lengths);
    let order: Vec<usize> = if b.rows() <= NATURAL_UP_TO {
        (0..b.rows()).collect()
    } else {
        // Without an ordering the natural one does, only slower.
        Ordering::nested_dissection(&symmetric(&gram)).map_or_else(
            |_| (0..b.rows()).collect(),
            |ordering| ordering.to_original().to_vec(),
        )
    };
    let (mut rows, distance) = eliminate(&gram, &order);
    rows.retain(|&row| lengths[row] > 0.0);
    rows.sort_unstable();
    Dependence { rows, distance }
}

/// BBᵀ with unit diagonal (zero for rows that are zero), by rows, ascending.
fn gram(b: &Matrix, lengths: &[f64]) -> Vec<Vec<(usize, f64)>> {
    let columns = b.transposed();
    let mut sums = vec![0.0; b.rows()];
    let mut seen = vec![false; b.rows()];
    let row = |i: usize| {
        let mut touched = Vec::new();
        for (j, value) in b.row(i) {
            for (other, factor) in columns.row(j) {
                if !std::mem::replace(&mut seen[other], true) {
                    touched.push(other);
                }
                sums[other] += value * factor;
            }
        }
        touched.sort_unstable();
        let entries = touched.iter().map(|&other| {
            let product = lengths[i] * lengths[other];
            let entry = if product > 0.0 {
                sums[other] / product
            } else {
                0.0
            };
            (sums[other], seen[other]) = (0.0, false);
            (other, entry)
        });
        // Rows of one pair share columns, but are orthogonal.
        entries
            .filter(|&(other, entry)| other == i || entry.abs() > f64::EPSILON)
            .collect()
    };
    (0..b.rows()).map(row).collect()
}

fn symmetric(gram: &[Vec<(usize, f64)>]) -> SymmetricMatrix {
    let mut starts = vec![0];
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for (j, row) in gram.iter().enumerate() {
        for &(i, value) in row.iter().filter(|(i, _)| *i >= j) {
            rows.push(i);
            values.push(value);
        }
        if row.is_empty() {
            rows.push(j);
            values.push(0.0);
        }
        starts.push(rows.len());
    }
    let order = gram.len();
    let pattern = SymbolicSparseColMat::new_checked(order, order, starts, None, rows);
    SymmetricMatrix::from_lower(SparseColMat::new(pattern, values))
}

/// Up-looking Cholesky in the given order; returns the rows whose pivot vanishes, and the root of the smallest pivot
/// that is no rounding.
fn eliminate(gram: &[Vec<(usize, f64)>], order: &[usize]) -> (Vec<usize>, f64) {
    let count = order.len();
    let mut position = vec![0; count];
    order
        .iter()
        .enumerate()
        .for_each(|(new, &old)| position[old] = new);
    let mut parent = vec![usize::MAX; count];
    let mut ancestor = vec![usize::MAX; count];
    let mut visited = vec![usize::MAX; count];
    // Columns of L below the diagonal; the diagonal, infinite for a row that is taken out.
    let mut columns: Vec<Vec<(usize, f64)>> = vec![Vec::new(); count];
    let mut diagonal = vec![0.0; count];
    let mut x = vec![0.0; count];
    let mut dependent = Vec::new();
    let mut smallest = 1.0_f64;
    for k in 0..count {
        visited[k] = k;
        let mut pivot = 0.0;
        let mut pattern = Vec::new();
        let row = || {
            gram[order[k]]
                .iter()
                .map(|&(old, value)| (position[old], value))
        };
        // The elimination tree, one row further.
        for (mut i, _) in row().filter(|&(i, _)| i < k) {
            while i != usize::MAX && i < k {
                let next = std::mem::replace(&mut ancestor[i], k);
                if next == usize::MAX {
                    parent[i] = k;
                }
                i = next;
            }
        }
        for (i, value) in row().filter(|&(i, _)| i <= k) {
            if i == k {
                pivot += value;
                continue;
            }
            x[i] += value;
            let mut node = i;
            while visited[node] != k {
                visited[node] = k;
                pattern.push(node);
                node = parent[node];
            }
        }
        // Ascending is an order in which every column comes after those that change it.
        pattern.sort_unstable();
        for i in pattern {
            let entry = std::mem::take(&mut x[i]) / diagonal[i];
            if entry == 0.0 {
                continue;
            }
            for &(row, value) in &columns[i] {
                x[row] -= value * entry;
            }
            pivot -= entry * entry;
            columns[i].push((k, entry));
        }
        // Columns hold rows up to k only, so that nothing of x is left but at k.
        x[k] = 0.0;
        if pivot > ROUNDING {
            smallest = smallest.min(pivot);
        }
        if pivot > DEPENDENT {
            diagonal[k] = pivot.sqrt();
        } else {
            diagonal[k] = f64::INFINITY;
            dependent.push(order[k]);
        }
    }
    (dependent, smallest.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dense(rows: &[&[f64]]) -> Matrix {
        Matrix::from_dense((rows.len(), rows[0].len()), &rows.concat()).unwrap()
    }

    #[test]
    fn the_last_of_dependent_rows_is_named() {
        let b = dense(&[
            &[1.0, 1.0, 0.0, 0.0],
            &[0.0, 0.0, 2.0, 0.0],
            &[0.0, 1.0, 1.0, 0.0],
            &[3.0, 0.0, 0.0, 0.0],
            // Half the first and a third of the fourth, less of the third, …
            &[2.0, 1.0, 1.0, 0.0],
            &[0.0, 0.0, 0.0, 0.0],
            &[0.0, 0.0, 0.0, 1e-3],
        ]);
        // The span of the first three is met by [3 0 0 0]: x1 = (r0 − (r2 − r1/2)).
        assert_eq!(dependent_rows(&b).rows, [3, 4]);
        let independent = dense(&[&[1.0, 1.0, 0.0], &[1.0, 1.0, 1e-4], &[0.0, 1.0, 1.0]]);
        let found = dependent_rows(&independent);
        assert_eq!(found.rows, [0_usize; 0]);
        // The first two rows differ by an angle of about 1e-4/√2.
        assert!(
            (found.distance / (1e-4 / 2_f64.sqrt()) - 1.0).abs() < 0.3,
            "{found:?}"
        );
    }

    #[test]
    fn many_rows_in_another_order_give_the_same_rank() {
        // A chain of differences is independent; closing the ring makes one row too many.
        let count = 900;
        let mut row = Vec::new();
        let mut column = Vec::new();
        let mut value = Vec::new();
        for i in 0..count {
            row.extend([i, i]);
            column.extend([i, (i + 1) % count]);
            value.extend([1.0, -1.0]);
        }
        let ring = Matrix::from_triplets((count, count), &row, &column, &value).unwrap();
        assert_eq!(dependent_rows(&ring).rows.len(), 1);
        let chain = ring.rows_between(0, count - 1);
        assert!(dependent_rows(&chain).rows.is_empty());
    }
}
