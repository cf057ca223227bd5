//! Lengths, shapes, finiteness, at the door.

use tresca_contact::Mobility;

use super::error::AlgebraicError;
use super::friction::PairLaw;
use super::matrix::Matrix;
use super::note::{Note, Row};
use crate::layout::Layout;

/// Checks a vector.
pub(super) fn vector(
    what: &'static str,
    values: &[f64],
    expected: usize,
    meaning: &'static str,
) -> Result<(), AlgebraicError> {
    if values.len() != expected {
        return Err(AlgebraicError::Length {
            what,
            expected,
            meaning,
            found: values.len(),
        });
    }
    match values.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(AlgebraicError::NotFinite {
            what,
            index,
            value: values[index],
        }),
        None => Ok(()),
    }
}

/// B = \[N; T\], shapes checked, and the number of tangents per pair.
pub(super) fn contact_rows(
    normal: &Matrix,
    tangential: Option<&Matrix>,
    dofs: usize,
) -> Result<(Matrix, usize), AlgebraicError> {
    let m = normal.rows();
    if m == 0 {
        return Err(AlgebraicError::NoPairs);
    }
    let refuse = |what, matrix: &Matrix, expected| {
        Err(AlgebraicError::Shape {
            what,
            rows: matrix.rows(),
            columns: matrix.columns(),
            expected,
        })
    };
    if normal.columns() != dofs {
        return refuse("N", normal, format!("m × {dofs}, K having {dofs} dofs"));
    }
    let mut b = normal.clone();
    let mut tangents = 0;
    if let Some(t) = tangential {
        if t.columns() != dofs || t.rows() != m && t.rows() != 2 * m {
            let expected = format!("{m} × {dofs} in the plane or {} × {dofs} in space", 2 * m);
            return refuse("T", t, expected);
        }
        tangents = t.rows() / m;
        (0..t.rows()).for_each(|i| b.push_row(t.row(i)));
    }
    Ok((b, tangents))
}

/// How the pairs can move: not along rows of B that are zero.
pub(super) fn mobility(
    b: &Matrix,
    pairs: usize,
    tangents: usize,
    notes: &mut Vec<Note>,
) -> Result<Vec<Mobility>, AlgebraicError> {
    let is_zero = |row: usize| b.row(row).all(|(_, value)| value == 0.0);
    let rows: Vec<Row> = (0..b.rows())
        .filter(|&row| is_zero(row))
        .map(|row| named(row, pairs))
        .collect();
    if rows.len() == b.rows() {
        return Err(AlgebraicError::NothingTouches);
    }
    if !rows.is_empty() {
        notes.push(Note::ZeroRows { rows });
    }
    let of_pair = |pair: usize| Mobility {
        normal: !is_zero(pair),
        tangents: std::array::from_fn(|t| t >= tangents || !is_zero(pairs + tangents * pair + t)),
    };
    Ok((0..pairs).map(of_pair).collect())
}

/// A row of B in the caller's words.
pub(super) fn named(row: usize, pairs: usize) -> Row {
    if row < pairs {
        Row::N(row)
    } else {
        Row::T(row - pairs)
    }
}

/// Where the pairs stand in λ.
pub(super) fn layout(
    laws: &[PairLaw],
    mobility: &[Mobility],
    tangents: usize,
) -> Result<Layout, AlgebraicError> {
    let needs_tangents = |law: &PairLaw| {
        !matches!(
            law,
            PairLaw::Frictionless | PairLaw::Bilateral { bound: 0.0 }
        )
    };
    if tangents == 0
        && let Some(pair) = laws.iter().position(needs_tangents)
    {
        return Err(AlgebraicError::NoTangents {
            pair,
            law: laws[pair].name(),
        });
    }
    let pairs = laws.iter().zip(mobility);
    let pairs = pairs.map(|(law, &mobility)| (law.opening(), mobility, law.sliding()));
    Ok(Layout::new(tangents + 1, pairs))
}

/// Says so when a law has two figures that differ, and there is one tangent.
pub(super) fn note_ignored_figures(laws: &[PairLaw], tangents: usize, notes: &mut Vec<Note>) {
    let differ = |law: &PairLaw| match law {
        PairLaw::Orthotropic { bounds: [a, b] } => a != b,
        PairLaw::Coulomb {
            coefficients: [a, b],
            ..
        } => a != b,
        _ => false,
    };
    if tangents == 1
        && let Some(pair) = laws.iter().position(differ)
    {
        notes.push(Note::SecondFigureIgnored { pair });
    }
}
