//! What can be wrong with a problem from a file, or with one that shall become one.

use tresca_io::fclib::Defect;
use tresca_la::{FactorError, OrderingError};
use tresca_qcqp::QcqpError;
use tresca_system::matrices::AlgebraicError;
use tresca_system::progress::Stopped;

/// Why a problem was not solved, or not exported.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FclibProblemError {
    /// Parts that do not fit together.
    #[error("`{part}` {defect}")]
    Part {
        /// The part, by its name in FCLIB.
        part: &'static str,
        /// What is wrong.
        #[source]
        defect: Defect,
    },
    /// A matrix that is not symmetric.
    #[error(
        "{name} is not symmetric: entries differ from their mirror images by up to {asymmetry:.1e} of \
         the largest entry (allowed: {allowed:.0e}, which is then averaged away)"
    )]
    Asymmetric {
        /// W or M.
        name: &'static str,
        /// max |A − Aᵀ| / (2 max |A|).
        asymmetry: f64,
        /// The largest one accepted.
        allowed: f64,
    },
    /// More contacts than a dense W allows.
    #[error("{unknowns} unknowns at the contacts: W is kept dense, at most {allowed} are possible")]
    TooLarge {
        /// Order of W.
        unknowns: usize,
        /// The largest order accepted.
        allowed: usize,
    },
    /// A slip bound that is none.
    #[error("the slip bound must be a number ≥ 0, found {0}")]
    Bound(f64),
    /// M cannot be factored.
    #[error("M: {0}")]
    Mass(#[from] FactorError),
    /// M cannot be ordered.
    #[error("M: {0}")]
    Ordering(#[from] OrderingError),
    /// The solver refused.
    #[error(transparent)]
    Dual(#[from] QcqpError),
    /// The dual form was refused.
    #[error(transparent)]
    Algebraic(AlgebraicError),
    /// The caller stopped the run before its first iteration.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// A dual problem that FCLIB has no words for.
    #[error("FCLIB cannot express {0}")]
    Inexpressible(&'static str),
}

impl From<AlgebraicError> for FclibProblemError {
    fn from(error: AlgebraicError) -> Self {
        match error {
            AlgebraicError::Stopped(stopped) => FclibProblemError::Stopped(stopped),
            AlgebraicError::Dual(error) => FclibProblemError::Dual(error),
            error => FclibProblemError::Algebraic(error),
        }
    }
}
