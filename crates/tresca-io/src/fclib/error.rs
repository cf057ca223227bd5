//! What can be wrong with a file of a frictional contact problem.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Why a problem was not read.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum FclibError {
    /// The operating system refused.
    #[error("cannot read `{}`", path.display())]
    #[diagnostic(code(fclib::io))]
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        #[source]
        source: io::Error,
    },
    /// Something in the file is not in order.
    #[error("`{}`, {place}: {defect}", path.display())]
    #[diagnostic(code(fclib::content))]
    Content {
        /// The file.
        path: PathBuf,
        /// Where in it.
        place: Place,
        /// What.
        #[source]
        defect: Defect,
    },
    /// HDF5 in a program that cannot read it.
    #[error("`{}` is an HDF5 file, and this program was built without HDF5", path.display())]
    #[diagnostic(
        code(fclib::without_hdf5),
        help("build with the feature `fclib`, which the program has by default")
    )]
    WithoutHdf5 {
        /// The file.
        path: PathBuf,
    },
}

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// A dataset or group of an HDF5 file, or a vector or matrix of any problem, by its name.
    Dataset(String),
    /// A line of a text file, counted from 1.
    Line(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Dataset(name) => write!(f, "`{name}`"),
            Place::Line(number) => write!(f, "line {number}"),
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
    Hdf5(Box<dyn std::error::Error + Send + Sync>),
}

/// An error whose file is not known yet.
#[derive(Debug)]
pub(super) enum Trouble {
    Content(Place, Defect),
    #[cfg(not(feature = "fclib"))]
    WithoutHdf5,
}

impl Trouble {
    pub fn of_file(self, path: &Path) -> FclibError {
        let path = path.to_owned();
        match self {
            Trouble::Content(place, defect) => FclibError::Content {
                path,
                place,
                defect,
            },
            #[cfg(not(feature = "fclib"))]
            Trouble::WithoutHdf5 => FclibError::WithoutHdf5 { path },
        }
    }
}

impl Defect {
    /// In a part of the problem.
    pub(super) fn at(self, name: impl Into<String>) -> Trouble {
        Trouble::Content(Place::Dataset(name.into()), self)
    }

    /// In a line of a text.
    pub(super) fn on(self, line: usize) -> Trouble {
        Trouble::Content(Place::Line(line), self)
    }
}
