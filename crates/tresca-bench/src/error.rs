//! What can go wrong on the bench.

use tresca::{ModelError, SolveError};
use tresca_io::WriteError;

/// Why an experiment has no result. How its solves ended is part of the result.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BenchError {
    /// The model, or a setting, is wrong.
    #[error(transparent)]
    Model(#[from] SolveError),
    /// The results of the timed run cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// There is no place for the results of the timed run.
    #[error("cannot make a directory for the results of the timed run")]
    Directory(#[source] std::io::Error),
    /// An experiment that runs for several tolerances was given none.
    #[error("at least one tolerance is needed")]
    NoTolerance,
}

impl From<ModelError> for BenchError {
    fn from(error: ModelError) -> Self {
        BenchError::Model(error.into())
    }
}
