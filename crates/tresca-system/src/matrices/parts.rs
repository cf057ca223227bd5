//! K at the door: symmetric? Of one piece?

use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use tresca_la::SymmetricMatrix;

use super::error::AlgebraicError;
use super::matrix::Matrix;
use super::note::Note;
use crate::tame::unit_of;

/// Relative asymmetry up to which K is symmetrised: rounding, or an assembly in another order.
const ALLOWED_ASYMMETRY: f64 = 1e-8;

/// The symmetric K of all blocks, by rows over all dofs.
pub(super) struct Stiffness {
    /// (K + Kᵀ)/2, both triangles.
    pub matrix: Matrix,
    /// The dofs of its connected parts, ascending; the parts by their first dof.
    pub parts: Vec<Vec<usize>>,
    /// The unit of its entries, a power of two.
    pub unit: f64,
}

impl Stiffness {
    /// Checks the blocks and puts them on one diagonal.
    pub fn new(blocks: &[Matrix], notes: &mut Vec<Note>) -> Result<Self, AlgebraicError> {
        let order: usize = blocks.iter().map(Matrix::rows).sum();
        if order == 0 {
            return Err(AlgebraicError::NoStiffness);
        }
        let mut matrix = Matrix::zeros(0, order);
        let mut first = 0;
        for (block, k) in blocks.iter().enumerate() {
            let (rows, columns) = (k.rows(), k.columns());
            if rows != columns {
                return Err(AlgebraicError::NotSquare {
                    block,
                    rows,
                    columns,
                });
            }
            let asymmetry = append_symmetric(&mut matrix, block, k, first)?;
            if asymmetry > 0.0 {
                notes.push(Note::Symmetrised { block, asymmetry });
            }
            first += rows;
        }
        for dof in 0..order {
            let diagonal = matrix
                .row(dof)
                .find(|&(j, _)| j == dof)
                .map_or(0.0, |(_, k)| k);
            if diagonal < 0.0 {
                return Err(AlgebraicError::NotPositive {
                    dof,
                    reason: "a negative entry on the diagonal",
                });
            }
            if diagonal == 0.0 && matrix.row(dof).any(|(_, k)| k != 0.0) {
                return Err(AlgebraicError::NotPositive {
                    dof,
                    reason: "a zero on the diagonal of a row that is not zero",
                });
            }
        }
        let unit = unit_of(matrix.largest());
        if unit != 1.0 {
            matrix.scale(1.0 / unit);
        }
        let parts = connected_parts(&matrix);
        Ok(Self {
            matrix,
            parts,
            unit,
        })
    }

    /// K on some dofs (ascending, whole parts), numbered from 0 in their order.
    pub fn restricted(&self, dofs: &[usize]) -> SymmetricMatrix {
        let local = |dof: usize| dofs.binary_search(&dof).ok();
        let mut starts = vec![0];
        let (mut rows, mut values) = (Vec::new(), Vec::new());
        for (column, &dof) in dofs.iter().enumerate() {
            // Row and column are the same, and ascending.
            let below = self
                .matrix
                .row(dof)
                .filter(|&(i, k)| i >= dof && (k != 0.0 || i == dof));
            let mut diagonal = false;
            let first = rows.len();
            for (i, k) in below.filter_map(|(i, k)| Some((local(i)?, k))) {
                diagonal |= i == column;
                rows.push(i);
                values.push(k);
            }
            if !diagonal {
                // The factorisation wants one, and a grounding may add to it.
                rows.insert(first, column);
                values.insert(first, 0.0);
            }
            starts.push(rows.len());
        }
        let order = dofs.len();
        let pattern = SymbolicSparseColMat::new_checked(order, order, starts, None, rows);
        SymmetricMatrix::from_lower(SparseColMat::new(pattern, values))
    }
}

/// Appends (K + Kᵀ)/2 with its first dof at `first`, and returns the relative asymmetry of K.
fn append_symmetric(
    all: &mut Matrix,
    block: usize,
    k: &Matrix,
    first: usize,
) -> Result<f64, AlgebraicError> {
    let transposed = k.transposed();
    let scale = k.largest();
    let mut worst = (0.0, 0, 0);
    for i in 0..k.rows() {
        let mut below = transposed.row(i).peekable();
        let mut above = k.row(i).peekable();
        let mut row: Vec<(usize, f64)> = Vec::new();
        loop {
            let next = match (above.peek(), below.peek()) {
                (Some(&(a, _)), Some(&(b, _))) => a.min(b),
                (Some(&(a, _)), None) => a,
                (None, Some(&(b, _))) => b,
                (None, None) => break,
            };
            let own = above
                .next_if(|&(j, _)| j == next)
                .map_or(0.0, |(_, value)| value);
            let other = below
                .next_if(|&(j, _)| j == next)
                .map_or(0.0, |(_, value)| value);
            let difference = (own - other).abs();
            if difference > worst.0 {
                worst = (difference, i, next);
            }
            // Where they agree the sum could overflow or round for nothing.
            let mean = if own == other {
                own
            } else {
                0.5 * own + 0.5 * other
            };
            row.push((first + next, mean));
        }
        all.push_row(row.into_iter());
    }
    let (difference, row, column) = worst;
    let asymmetry = if scale > 0.0 { difference / scale } else { 0.0 };
    if asymmetry > ALLOWED_ASYMMETRY {
        let one_sided = |test: fn(usize, usize) -> bool| {
            (0..k.rows()).all(|i| k.row(i).all(|(j, value)| value == 0.0 || test(i, j)))
        };
        return Err(AlgebraicError::NotSymmetric {
            block,
            row,
            column,
            asymmetry,
            triangle: one_sided(|i, j| i >= j) || one_sided(|i, j| i <= j),
        });
    }
    Ok(asymmetry)
}

/// The connected parts of the graph of a symmetric matrix.
fn connected_parts(matrix: &Matrix) -> Vec<Vec<usize>> {
    let mut seen = vec![false; matrix.rows()];
    let mut parts = Vec::new();
    for start in 0..matrix.rows() {
        if std::mem::replace(&mut seen[start], true) {
            continue;
        }
        let mut part = vec![start];
        let mut head = 0;
        while let Some(&dof) = part.get(head) {
            head += 1;
            for (other, _) in matrix.row(dof).filter(|(_, value)| *value != 0.0) {
                if !std::mem::replace(&mut seen[other], true) {
                    part.push(other);
                }
            }
        }
        part.sort_unstable();
        parts.push(part);
    }
    parts
}
