//! Friction of contact pairs whose bounds are forces: there is no area to multiply with.

use tresca_contact::{FrictionLaw, Opening, Sliding};

use super::error::AlgebraicError;

/// What resists sliding, and opening, of a contact pair. The two figures of a law belong to the two rows
/// of T, in the plane the first to the one there is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum PairLaw {
    /// Nothing resists sliding.
    Frictionless,
    /// ‖λτ‖ ≤ `bound`, whatever the normal force.
    Tresca {
        /// The slip bound, a force ≥ 0.
        bound: f64,
    },
    /// (λ1/g1)² + (λ2/g2)² ≤ 1. Slip is normal to the ellipse. A bound of 0 leaves its direction without
    /// friction.
    Orthotropic {
        /// g1, g2: forces ≥ 0.
        bounds: [f64; 2],
    },
    /// As `Orthotropic` with the bounds min(λν, limit/F)·(F1, F2), F the larger coefficient.
    Coulomb {
        /// F1, F2 ≥ 0; equal for isotropic friction.
        coefficients: [f64; 2],
        /// Upper limit of the larger bound, a force ≥ 0, or ∞.
        limit: f64,
    },
    /// Neither opening nor slip.
    Tied,
    /// No opening; slip resisted below a bound, as by Tresca's law.
    Bilateral {
        /// The slip bound, a force ≥ 0; 0 for free slip.
        bound: f64,
    },
}

impl PairLaw {
    /// Tresca's law with a slip bound (a force).
    pub fn tresca(bound: f64) -> Self {
        PairLaw::Tresca { bound }
    }

    /// Isotropic Coulomb friction without a limit.
    pub fn coulomb(coefficient: f64) -> Self {
        PairLaw::Coulomb {
            coefficients: [coefficient; 2],
            limit: f64::INFINITY,
        }
    }

    /// The word for it, as everywhere.
    pub fn name(&self) -> &'static str {
        let number = match self {
            PairLaw::Frictionless => 0,
            PairLaw::Tresca { .. } => 1,
            PairLaw::Orthotropic { .. } => 2,
            PairLaw::Coulomb { .. } => 3,
            PairLaw::Tied => 4,
            PairLaw::Bilateral { .. } => 5,
        };
        FrictionLaw::NAMES[number]
    }

    pub(crate) fn opening(&self) -> Opening {
        match self {
            PairLaw::Tied | PairLaw::Bilateral { .. } => Opening::Never,
            _ => Opening::Unilateral,
        }
    }

    pub(crate) fn sliding(&self) -> Sliding {
        match *self {
            PairLaw::Frictionless => Sliding::Bounded([0.0; 2]),
            PairLaw::Tresca { bound } | PairLaw::Bilateral { bound } => {
                Sliding::Bounded([bound; 2])
            }
            PairLaw::Orthotropic { bounds } => Sliding::Bounded(bounds),
            PairLaw::Coulomb {
                coefficients,
                limit,
            } => Sliding::Coulomb {
                coefficients,
                limit,
            },
            PairLaw::Tied => Sliding::Never,
        }
    }

    fn check(&self, pair: usize) -> Result<(), AlgebraicError> {
        let number = |what, value: f64, allowed: bool| {
            if allowed && value >= 0.0 {
                Ok(())
            } else {
                Err(AlgebraicError::Friction { pair, what, value })
            }
        };
        let finite = |what, value: f64| number(what, value, value.is_finite());
        match *self {
            PairLaw::Frictionless | PairLaw::Tied => Ok(()),
            PairLaw::Tresca { bound } | PairLaw::Bilateral { bound } => finite("slip bound", bound),
            PairLaw::Orthotropic { bounds } => bounds
                .into_iter()
                .try_for_each(|bound| finite("slip bound", bound)),
            PairLaw::Coulomb {
                coefficients,
                limit,
            } => {
                let mut both = coefficients.into_iter();
                both.try_for_each(|f| finite("friction coefficient", f))?;
                number("limit of the slip bound", limit, !limit.is_nan())
            }
        }
    }
}

/// The laws of all pairs.
#[derive(Debug, Clone, PartialEq)]
pub enum Friction {
    /// One law for all.
    Same(PairLaw),
    /// One law for each pair.
    PerPair(Vec<PairLaw>),
}

impl From<PairLaw> for Friction {
    fn from(law: PairLaw) -> Self {
        Friction::Same(law)
    }
}

impl From<Vec<PairLaw>> for Friction {
    fn from(laws: Vec<PairLaw>) -> Self {
        Friction::PerPair(laws)
    }
}

impl Friction {
    /// Tresca's law with a slip bound (a force) for each pair.
    pub fn tresca(bounds: &[f64]) -> Self {
        Friction::PerPair(bounds.iter().map(|&bound| PairLaw::tresca(bound)).collect())
    }

    /// The law of each of `pairs` pairs, checked. In the plane a law with two figures is one whose second
    /// is never looked at.
    ///
    /// # Errors
    /// For another number of laws, and figures that are no numbers ≥ 0.
    pub fn laws(&self, pairs: usize) -> Result<Vec<PairLaw>, AlgebraicError> {
        let laws = match self {
            Friction::Same(law) => vec![*law; pairs],
            Friction::PerPair(laws) if laws.len() == pairs => laws.clone(),
            Friction::PerPair(laws) => {
                return Err(AlgebraicError::Length {
                    what: "the list of friction laws",
                    expected: pairs,
                    meaning: "one per contact pair",
                    found: laws.len(),
                });
            }
        };
        for (pair, law) in laws.iter().enumerate() {
            law.check(pair)?;
        }
        Ok(laws)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_of_forces_are_called_as_those_of_tractions() {
        let bound = || tresca_contact::ScalarField::Constant(1.0);
        let tractions = FrictionLaw::Bilateral {
            bound: Some(bound()),
        };
        assert_eq!(PairLaw::Bilateral { bound: 1.0 }.name(), tractions.name());
        let tractions = FrictionLaw::Orthotropic {
            bounds: [bound(), bound()],
            axis: [1.0, 0.0, 0.0],
        };
        let forces = PairLaw::Orthotropic { bounds: [1.0; 2] };
        assert_eq!(forces.name(), tractions.name());
        assert_eq!(PairLaw::tresca(1.0).name(), FrictionLaw::tresca(1.0).name());
        assert_eq!(
            PairLaw::coulomb(0.3).name(),
            FrictionLaw::coulomb(0.3).name()
        );
        assert_eq!(PairLaw::Tied.name(), FrictionLaw::Tied.name());
        assert_eq!(
            PairLaw::Frictionless.name(),
            FrictionLaw::Frictionless.name()
        );
    }
}
