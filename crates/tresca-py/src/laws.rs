//! Friction laws from a code and three figures per pair.

use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use tresca::FrictionLaw;
use tresca::algebraic::{Friction, PairLaw};

use crate::errors;

/// The names of the laws; a code is a place in this list.
pub const LAWS: [&str; 6] = FrictionLaw::NAMES;

/// (codes, figures, one law for each pair?): one row of three figures for each code. Bounds or coefficients
/// come first, the limit of Coulomb's law last; what a law does not use is not looked at.
pub type Laws<'py> = (PyReadonlyArray1<'py, u8>, PyReadonlyArray2<'py, f64>, bool);

/// The friction of a problem.
pub fn friction((codes, figures, per_pair): &Laws<'_>) -> PyResult<Friction> {
    let figures = figures.as_slice()?.as_chunks::<3>().0;
    let laws = codes.as_slice()?.iter().zip(figures);
    let laws = laws
        .map(|(&code, figures)| law(code, *figures))
        .collect::<PyResult<Vec<_>>>()?;
    match laws[..] {
        [law] if !per_pair => Ok(Friction::Same(law)),
        _ => Ok(Friction::PerPair(laws)),
    }
}

fn law(code: u8, [first, second, limit]: [f64; 3]) -> PyResult<PairLaw> {
    let name = LAWS.get(usize::from(code)).copied();
    Ok(match name {
        Some("frictionless") => PairLaw::Frictionless,
        Some("tresca") => PairLaw::Tresca { bound: first },
        Some("orthotropic") => PairLaw::Orthotropic {
            bounds: [first, second],
        },
        Some("coulomb") => PairLaw::Coulomb {
            coefficients: [first, second],
            limit,
        },
        Some("tied") => PairLaw::Tied,
        Some("bilateral") => PairLaw::Bilateral { bound: first },
        _ => return Err(errors::problem(format!("there is no law with code {code}"))),
    })
}
