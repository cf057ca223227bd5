//! What can be wrong with the input.

/// Wrong input to the solver. How a run *ended* is not an error but a
/// [`Status`](crate::Status).
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QcqpError {
    /// Two parts of the problem have different sizes.
    #[error("{what} has length {found}, but the dual operator has order {expected}")]
    Dimension {
        /// Which part.
        what: &'static str,
        /// Order of the operator.
        expected: usize,
        /// Length found.
        found: usize,
    },
    /// Two parts of the equality constraint have different sizes.
    #[error("{what} has length {found}, but the equality constraint has {expected} rows")]
    Rows {
        /// Which part.
        what: &'static str,
        /// Number of rows of G.
        expected: usize,
        /// Length found.
        found: usize,
    },
    /// A NaN or an infinity in the input.
    #[error("{what} holds {value} at index {index}: every entry must be finite")]
    NotFinite {
        /// Which part.
        what: &'static str,
        /// Position, counted from 0.
        index: usize,
        /// The entry.
        value: f64,
    },
    /// The blocks of a product set leave an unknown out or claim it twice.
    #[error("unknown {index} belongs to {found} blocks of the feasible set: exactly one is needed")]
    Cover {
        /// The unknown, counted from 0.
        index: usize,
        /// How many blocks claim it.
        found: usize,
    },
    /// A block reaches beyond the last unknown.
    #[error("block {block} of the feasible set reaches beyond the last of {dimension} unknowns")]
    BlockRange {
        /// The block, counted from 0.
        block: usize,
        /// Number of unknowns.
        dimension: usize,
    },
    /// A bound (slip bound of a disc or an interval) is negative or not finite.
    #[error("the bound of block {block} is {value}: it must be finite and not negative")]
    Bound {
        /// The block, counted from 0.
        block: usize,
        /// The bound.
        value: f64,
    },
    /// A bound for a block that has none.
    #[error("block {block} of the feasible set is no interval and no disc: it has no bound")]
    NoBound {
        /// The block, counted from 0.
        block: usize,
    },
    /// Coulomb's law for a block that does not fit, or with data out of range.
    #[error("coulomb bound {bound}: {what}")]
    Coulomb {
        /// Which one, counted from 0.
        bound: usize,
        /// What is wrong with it.
        what: &'static str,
    },
    /// The metric of the equality constraint is no symmetric positive definite matrix.
    #[error("the metric of the equality constraint is not symmetric positive definite")]
    Metric,
    /// A setting outside its range.
    #[error("setting `{name}` is {value}, allowed is {allowed}")]
    Setting {
        /// Key of the setting.
        name: &'static str,
        /// Its value.
        value: String,
        /// What is allowed.
        allowed: String,
    },
    /// A word that names no choice.
    #[error("`{found}` is no {what}: expected one of {allowed}")]
    Choice {
        /// What is chosen.
        what: &'static str,
        /// The word.
        found: String,
        /// The known words.
        allowed: String,
    },
    /// The operator is the zero matrix.
    #[error(
        "the dual operator maps a random vector to zero: no constraint row touches an elastic body"
    )]
    ZeroOperator,
    /// The operator is not symmetric.
    #[error(
        "the dual operator is not symmetric: relative asymmetry {asymmetry:.1e} in its products"
    )]
    NotSymmetric {
        /// max |xᵀAy − yᵀAx| over the products seen, relative to σmax.
        asymmetry: f64,
    },
    /// The operator has a negative eigenvalue.
    #[error(
        "the dual operator is not positive semidefinite: xᵀAx = {curvature:.3e} σmax for a unit vector x"
    )]
    NotPositive {
        /// The negative Rayleigh quotient relative to σmax.
        curvature: f64,
    },
    /// The operator returned a NaN or an infinity for a finite vector.
    #[error("the dual operator returned {value} at index {index} for a finite vector")]
    OperatorNotFinite {
        /// Position, counted from 0.
        index: usize,
        /// The entry.
        value: f64,
    },
    /// The engine works on the trailing block of every body's factor, and a solver has none.
    #[error(
        "the solver of a body has no factor to take a trailing block from, which this engine needs"
    )]
    NoTrailingBlock,
    /// The system of a [`Tangent`](crate::Tangent) could not be solved as well as was asked for.
    #[error("the tangent system was solved to a relative residual of {residual:.1e} only")]
    Tangent {
        /// The residual, relative to the right-hand side.
        residual: f64,
    },
}

/// Checks that `values` has length `expected` and holds finite numbers only.
pub(crate) fn check_vector(
    what: &'static str,
    values: &[f64],
    expected: usize,
) -> Result<(), QcqpError> {
    if values.len() != expected {
        let found = values.len();
        return Err(QcqpError::Dimension {
            what,
            expected,
            found,
        });
    }
    match values.iter().position(|v| !v.is_finite()) {
        Some(index) => Err(QcqpError::NotFinite {
            what,
            index,
            value: values[index],
        }),
        None => Ok(()),
    }
}

/// Checks the length of something that has one entry per row of G.
pub(crate) fn check_rows(
    what: &'static str,
    found: usize,
    expected: usize,
) -> Result<(), QcqpError> {
    if found == expected {
        Ok(())
    } else {
        Err(QcqpError::Rows {
            what,
            expected,
            found,
        })
    }
}
