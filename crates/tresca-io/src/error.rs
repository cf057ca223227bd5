//! What can go wrong when results are written.

use std::io;
use std::path::PathBuf;

/// Why results were not written.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum WriteError {
    /// The operating system refused.
    #[error("cannot {action} `{}`", path.display())]
    #[diagnostic(code(write::io))]
    Io {
        /// What was tried, as a verb.
        action: &'static str,
        /// The file or directory.
        path: PathBuf,
        /// What the operating system says.
        #[source]
        source: io::Error,
    },

    /// The stream given to a writer refused.
    #[error("cannot write the stream")]
    #[diagnostic(code(write::io))]
    Stream(#[from] io::Error),

    /// A name of a file or field that cannot be: no plain file name, or given twice.
    #[error("the name `{name}` cannot be used: {reason}")]
    #[diagnostic(code(write::name))]
    Name {
        /// The name as given.
        name: String,
        /// What is wrong with it.
        reason: &'static str,
    },

    /// NaN or infinity where results are expected: something failed earlier, and must not look
    /// like a result.
    #[error("`{field}` is not a finite number at {place}: {value}")]
    #[diagnostic(code(write::not_finite))]
    NotFinite {
        /// Name of the field or column.
        field: String,
        /// Which of its values, such as "node 17, component 2" or "row 3".
        place: String,
        /// The value.
        value: f64,
    },

    /// A summary contains a null: an absent value is left out, a non-finite one is an error.
    #[error("the summary has no finite number at `{path}`")]
    #[diagnostic(code(write::not_finite))]
    Null {
        /// Keys from the root, joined by dots.
        path: String,
    },

    /// A field has another number of values than there are points, cells or columns.
    #[error("`{field}` has {found} values, expected {expected}")]
    #[diagnostic(code(write::length))]
    Length {
        /// Name of the field.
        field: String,
        /// What the grid or table asks for.
        expected: usize,
        /// What was given.
        found: usize,
    },

    /// Cells refer to a point that is not there.
    #[error("cell {cell} refers to point {point}, but there are {points} points")]
    #[diagnostic(code(write::connectivity))]
    Connectivity {
        /// Number of the cell, counted through all blocks.
        cell: usize,
        /// The point it names.
        point: usize,
        /// How many there are.
        points: usize,
    },

    /// A frictional contact problem whose parts do not fit together.
    #[error("the problem cannot be written: `{part}` {defect}")]
    #[diagnostic(code(write::problem))]
    Problem {
        /// The part, by its name in FCLIB.
        part: String,
        /// What is wrong with it.
        #[source]
        defect: crate::fclib::error::Defect,
    },

    /// A file that HDF5 cannot hold.
    #[error("cannot be written as HDF5: {0}")]
    #[diagnostic(code(write::hdf5))]
    Hdf5(Box<dyn std::error::Error + Send + Sync>),

    /// The summary cannot be expressed in JSON, for instance because a key of a map is no text.
    #[error("the summary cannot be written as JSON")]
    #[diagnostic(code(write::json))]
    Json(#[from] serde_json::Error),
}

impl WriteError {
    /// For `map_err`: what was tried, and with what.
    pub(crate) fn io(
        action: &'static str,
        path: impl Into<PathBuf>,
    ) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::Io {
            action,
            path: path.into(),
            source,
        }
    }
}

impl From<csv::Error> for WriteError {
    fn from(error: csv::Error) -> Self {
        match error.into_kind() {
            csv::ErrorKind::Io(error) => WriteError::Stream(error),
            other => WriteError::Stream(io::Error::other(format!("{other:?}"))),
        }
    }
}
