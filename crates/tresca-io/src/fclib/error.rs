//! What can be wrong with a file of a frictional contact problem.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::Path;

use crate::located::{Fault, FilePlace, Located, Position};

/// Why a problem was not read, and where.
pub type FclibError = Located<FclibFault>;

/// Why a problem was not read.
#[derive(Debug)]
#[non_exhaustive]
pub enum FclibFault {
    /// The operating system refused.
    Io(io::Error),
    /// Something in the file is not in order.
    Content(Defect),
    /// HDF5 in a program that cannot read it.
    WithoutHdf5,
}

impl Fault for FclibFault {
    fn code(&self) -> &'static str {
        match self {
            FclibFault::Io(_) => "fclib::io",
            FclibFault::Content(_) => "fclib::content",
            FclibFault::WithoutHdf5 => "fclib::without_hdf5",
        }
    }

    fn tell(&self, place: &FilePlace, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = place.path.display();
        match self {
            FclibFault::Io(_) => write!(f, "cannot read `{path}`"),
            FclibFault::Content(defect) => match &place.position {
                Position::Line(line) => write!(f, "`{path}`, line {line}: {defect}"),
                Position::Part(name) => write!(f, "`{path}`, `{name}`: {defect}"),
                _ => write!(f, "{place}: {defect}"),
            },
            FclibFault::WithoutHdf5 => write!(
                f,
                "`{path}` is an HDF5 file, and this program was built without HDF5"
            ),
        }
    }

    fn help(&self) -> Option<String> {
        let help = "build with the feature `fclib`, which the program has by default";
        matches!(self, FclibFault::WithoutHdf5).then(|| help.to_owned())
    }

    fn cause(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            FclibFault::Io(error) => Some(error),
            FclibFault::Content(defect) => Some(defect),
            FclibFault::WithoutHdf5 => None,
        }
    }
}

/// What is not in order.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Defect {
    /// Something that must be there is not.
    #[error("is missing")]
    Missing,
    /// Neither of the two kinds of problem.
    #[error("the file has neither a group `fclib_local` nor a group `fclib_global`")]
    NoProblem,
    /// A vector of the wrong length.
    #[error("has {found} values, expected {expected}")]
    Length {
        /// What the other parts of the problem ask for.
        expected: usize,
        /// What is there.
        found: usize,
    },
    /// A matrix of the wrong shape.
    #[error("is {} × {}, expected {} × {}", found.0, found.1, expected.0, expected.1)]
    Shape {
        /// Rows and columns that the other parts of the problem ask for.
        expected: (usize, usize),
        /// Rows and columns that it has.
        found: (usize, usize),
    },
    /// NaN or infinity.
    #[error("value {index} is {value}, which is no finite number")]
    NotFinite {
        /// Which value, from 0.
        index: usize,
        /// The value.
        value: f64,
    },
    /// A friction coefficient below 0.
    #[error("the friction coefficient of contact {contact} is {value}, expected a number ≥ 0")]
    Coefficient {
        /// The contact, from 0.
        contact: usize,
        /// Its μ.
        value: f64,
    },
    /// An entry outside of its matrix.
    #[error(
        "there is an entry ({row}, {column}) in a matrix of {rows} × {columns}, counted from 0"
    )]
    Outside {
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// Rows of the matrix.
        rows: usize,
        /// Columns of the matrix.
        columns: usize,
    },
    /// Dimensions other than 2 and 3.
    #[error("problems live in 2 or 3 dimensions, found {0}")]
    Dimension(i64),
    /// A number of rows that is no multiple of the dimension.
    #[error("{rows} rows are no whole number of contacts in {dimension} dimensions")]
    Contacts {
        /// Rows of W or columns of H.
        rows: usize,
        /// The dimension.
        dimension: usize,
    },
    /// Pointers into compressed rows, columns or blocks that lead nowhere.
    #[error("pointers must rise from 0 to at most {entries}, found {found} at {index}")]
    Pointers {
        /// Which of them, from 0.
        index: usize,
        /// Its value.
        found: i64,
        /// Number of entries that there are.
        entries: usize,
    },
    /// A count or an index that is none.
    #[error("expected a count or an index, found {0}")]
    Negative(i64),
    /// A storage scheme that does not exist.
    #[error("the storage scheme {0} of a matrix is not known")]
    Storage(i64),
    /// A word where something else should stand.
    #[error("expected {expected}, found `{found}`")]
    Token {
        /// What should stand there.
        expected: &'static str,
        /// What does.
        found: String,
    },
    /// The text ends too early.
    #[error("the file ends where {expected} should follow")]
    End {
        /// What should follow.
        expected: &'static str,
    },
    /// A part of the format that is not taken over.
    #[error("{0} are not supported")]
    Unsupported(&'static str),
    /// The HDF5 file is damaged, or has a part that cannot be decoded.
    #[error("cannot be read: {0}")]
    Hdf5(Box<dyn Error + Send + Sync>),
}

/// An error whose file is not known yet.
#[derive(Debug)]
pub(super) enum Trouble {
    Content(Position, Defect),
    #[cfg(not(feature = "fclib"))]
    WithoutHdf5,
}

impl Trouble {
    pub fn of_file(self, path: &Path) -> FclibError {
        match self {
            Trouble::Content(position, defect) => {
                let path = path.to_owned();
                Located::new(FclibFault::Content(defect), FilePlace { path, position })
            }
            #[cfg(not(feature = "fclib"))]
            Trouble::WithoutHdf5 => Located::new(FclibFault::WithoutHdf5, path),
        }
    }
}

impl Defect {
    /// In a part of the problem.
    pub(super) fn at(self, name: impl Into<String>) -> Trouble {
        Trouble::Content(Position::Part(name.into()), self)
    }

    /// In a line of a text.
    pub(super) fn on(self, line: usize) -> Trouble {
        Trouble::Content(Position::Line(line), self)
    }
}
