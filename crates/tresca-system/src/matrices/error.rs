//! What can be wrong with matrices that are brought along.

use tresca_qcqp::QcqpError;

use crate::progress::Stopped;
use crate::run::Unsolved;

/// Arrays that are no matrix.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MatrixError {
    /// Too many or too few row (column) starts.
    #[error(
        "{found} row (column) starts, expected {expected}: one more than there are rows (columns)"
    )]
    StartCount {
        /// What the shape asks for.
        expected: usize,
        /// What was given.
        found: usize,
    },
    /// Row (column) starts that do not ascend from 0 to the number of entries.
    #[error("the row (column) starts must ascend from 0 to the number of entries, {entries}")]
    Starts {
        /// Number of entries.
        entries: usize,
    },
    /// An entry outside of the matrix.
    #[error("entry {entry} has a {what} that is not in 0..{count}")]
    Index {
        /// `row` or `column`.
        what: &'static str,
        /// Number of the entry, from 0.
        entry: usize,
        /// Number of rows or columns.
        count: usize,
    },
    /// Arrays of different lengths.
    #[error("{found} values for {expected} places")]
    ValueCount {
        /// Number of indices, or the size of the shape.
        expected: usize,
        /// Number of values.
        found: usize,
    },
    /// NaN or infinity.
    #[error("entry {entry} is {value}: every entry must be finite")]
    NotFinite {
        /// Number of the entry, from 0.
        entry: usize,
        /// The value.
        value: f64,
    },
}

/// Why an algebraic problem cannot be solved. How a solve *ended* is no error but a
/// [`Status`](tresca_qcqp::Status).
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AlgebraicError {
    /// No block of K.
    #[error("there is no stiffness matrix")]
    NoStiffness,
    /// A block of K that is not square.
    #[error(
        "block {block} of K has {rows} rows and {columns} columns: a stiffness matrix is square"
    )]
    NotSquare {
        /// Number of the block, from 0.
        block: usize,
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
    },
    /// A block of K that is not symmetric.
    #[error(
        "block {block} of K is not symmetric: entries ({row}, {column}) and ({column}, {row}) differ by \
         {asymmetry:.1e} of the largest entry{hint}",
        hint = if *triangle { "; only one triangle seems to be given, but both are needed" } else { "" }
    )]
    NotSymmetric {
        /// Number of the block, from 0.
        block: usize,
        /// Where the difference is largest.
        row: usize,
        /// Where the difference is largest.
        column: usize,
        /// max |K_ij − K_ji| / max |K_ij|.
        asymmetry: f64,
        /// Whether all entries lie on one side of the diagonal.
        triangle: bool,
    },
    /// K is not positive semidefinite.
    #[error("K is not positive semidefinite: {reason} at dof {dof}")]
    NotPositive {
        /// A dof that shows it, numbered over all blocks, from 0.
        dof: usize,
        /// What shows it.
        reason: &'static str,
    },
    /// A given kernel vector that K does not map to zero.
    #[error(
        "kernel vector {vector} is none: K maps it to {residual:.1e} of what the absolute values of its \
         entries give"
    )]
    Kernel {
        /// Its number, from 0.
        vector: usize,
        /// max |K r| over max |K||r|, for the connected part of K where that is largest.
        residual: f64,
    },
    /// K is singular beyond the kernel that was given.
    #[error(
        "K is singular beyond the kernel that was given, in the connected part with dof {dof}: give all \
         kernel vectors, or none and let them be found"
    )]
    KernelIncomplete {
        /// The first dof of the part.
        dof: usize,
    },
    /// The kernel of K has more dimensions than can be kernel vectors of a body.
    #[error(
        "the connected part of K with dof {dof} has more than {limit} kernel vectors: it is no stiffness \
         matrix of one body"
    )]
    KernelTooLarge {
        /// The first dof of the part.
        dof: usize,
        /// How many were looked for.
        limit: usize,
    },
    /// A part of K is singular, and no row of B touches what can move.
    #[error(
        "the connected part of K with dof {dof} ({dofs} dofs) is not held: {motions} of its kernel vectors \
         are not touched by any row of N or T"
    )]
    Floating {
        /// The first dof of the part.
        dof: usize,
        /// Its size.
        dofs: usize,
        /// How many.
        motions: usize,
    },
    /// No contact pair.
    #[error("N has no rows: there is no contact to solve for")]
    NoPairs,
    /// No row of B touches anything.
    #[error("every row of N and T is zero")]
    NothingTouches,
    /// A matrix of the wrong shape.
    #[error("{what} is {rows} × {columns}, expected {expected}")]
    Shape {
        /// Which one.
        what: &'static str,
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
        /// The shapes that are possible.
        expected: String,
    },
    /// A vector of the wrong length.
    #[error("{what} has length {found}, expected {expected} ({meaning})")]
    Length {
        /// Which one.
        what: &'static str,
        /// The right length.
        expected: usize,
        /// What it counts.
        meaning: &'static str,
        /// The length found.
        found: usize,
    },
    /// NaN or infinity in a vector.
    #[error("{what} holds {value} at index {index}: every entry must be finite")]
    NotFinite {
        /// Which one.
        what: &'static str,
        /// Position, from 0.
        index: usize,
        /// The entry.
        value: f64,
    },
    /// A matrix that is none.
    #[error("{what}: {source}")]
    Matrix {
        /// Which one.
        what: &'static str,
        /// What is wrong.
        source: MatrixError,
    },
    /// A figure of a friction law that is out of range.
    #[error("the {what} of pair {pair} is {value}: it must be a number ≥ 0")]
    Friction {
        /// The pair, from 0.
        pair: usize,
        /// Which figure.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// Friction data for a problem without T.
    #[error("pair {pair} has the law `{law}`, which needs the tangential matrix T")]
    NoTangents {
        /// The pair, from 0.
        pair: usize,
        /// Its law.
        law: &'static str,
    },
    /// Laws of another kind than the problem was prepared for.
    #[error(
        "the friction laws are of another kind than those that the problem was prepared with: figures may \
         change from solve to solve, but not which pairs may open, which are tied, nor the ratio of \
         orthotropic bounds; prepare the problem anew"
    )]
    LawsChanged,
    /// A matrix A that is not symmetric.
    #[error(
        "A is not symmetric: entries ({row}, {column}) and ({column}, {row}) differ by {asymmetry:.1e} of \
         the largest entry"
    )]
    DualNotSymmetric {
        /// Where the difference is largest.
        row: usize,
        /// Where the difference is largest.
        column: usize,
        /// The relative difference.
        asymmetry: f64,
    },
    /// A part of K has no ordering.
    #[error("the part of K with dof {dof}: {source}")]
    Ordering {
        /// Its first dof.
        dof: usize,
        /// Why.
        source: tresca_la::OrderingError,
    },
    /// A part of K cannot be factored.
    #[error("the part of K with dof {dof}: {source}")]
    Factorization {
        /// Its first dof.
        dof: usize,
        /// Why.
        source: tresca_la::FactorError,
    },
    /// The dual problem was refused.
    #[error(transparent)]
    Dual(#[from] QcqpError),
    /// The caller stopped the run before its first iteration.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

impl From<Unsolved> for AlgebraicError {
    fn from(error: Unsolved) -> Self {
        match error {
            Unsolved::Stopped(stopped) => AlgebraicError::Stopped(stopped),
            Unsolved::Refused(error) => AlgebraicError::Dual(error),
        }
    }
}
