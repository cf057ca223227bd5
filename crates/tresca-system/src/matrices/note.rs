//! Things about the input that a user should know, though they are no errors.

use std::fmt;

use serde::Serialize;

/// A row of B.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Row {
    /// A row of N, from 0: the pair's number.
    N(usize),
    /// A row of T, from 0.
    T(usize),
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Row::N(row) => write!(f, "N[{row}]"),
            Row::T(row) => write!(f, "T[{row}]"),
        }
    }
}

/// Something about the input that is worth a word.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub enum Note {
    /// A block of K was symmetrised.
    Symmetrised {
        /// Number of the block, from 0.
        block: usize,
        /// max |K_ij − K_ji| / max |K_ij|.
        asymmetry: f64,
    },
    /// A (of the pure dual form) was symmetrised.
    DualSymmetrised {
        /// max |A_ij − A_ji| / max |A_ij|.
        asymmetry: f64,
    },
    /// K falls apart.
    Parts {
        /// Number of parts that are not connected with each other.
        parts: usize,
    },
    /// Kernel vectors were found.
    KernelFound {
        /// The first dof of the part of K.
        dof: usize,
        /// Number of dofs of the part.
        dofs: usize,
        /// How many.
        vectors: usize,
    },
    /// Rows of B that are zero: no force acts there.
    ZeroRows {
        /// The rows.
        rows: Vec<Row>,
    },
    /// Rows of B that depend on others.
    DependentRows {
        /// The rows, one for each dimension that B lacks.
        rows: Vec<Row>,
    },
    /// Two-component laws in the plane.
    SecondFigureIgnored {
        /// The first pair with one.
        pair: usize,
    },
}

/// At most this many rows are named one by one.
const NAMED: usize = 8;

fn listed(rows: &[Row]) -> String {
    let mut text = rows
        .iter()
        .take(NAMED)
        .map(Row::to_string)
        .collect::<Vec<_>>()
        .join(", ");
    if rows.len() > NAMED {
        text += &format!(" and {} more", rows.len() - NAMED);
    }
    text
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Note::Symmetrised { block, asymmetry } => write!(
                f,
                "block {block} of K had a relative asymmetry of {asymmetry:.1e}; solved with (K + Kᵀ)/2"
            ),
            Note::DualSymmetrised { asymmetry } => write!(
                f,
                "A had a relative asymmetry of {asymmetry:.1e}; solved with one of its triangles for both"
            ),
            Note::Parts { parts } => {
                write!(
                    f,
                    "K falls apart into {parts} parts, which were factored on their own"
                )
            }
            Note::KernelFound { dof, dofs, vectors } => write!(
                f,
                "the part of K with dof {dof} ({dofs} dofs) is singular; {vectors} kernel vector(s) were \
                 found, and contact has to hold them"
            ),
            Note::ZeroRows { rows } => {
                write!(
                    f,
                    "rows of B that are zero carry no force: {}",
                    listed(rows)
                )
            }
            Note::DependentRows { rows } => write!(
                f,
                "rows of B depend on others: {}. The displacements and the energy are unique, the contact \
                 forces are not",
                listed(rows)
            ),
            Note::SecondFigureIgnored { pair } => write!(
                f,
                "there is one tangent per pair: the second figure of the law of pair {pair} (and maybe of \
                 others) is not used"
            ),
        }
    }
}
