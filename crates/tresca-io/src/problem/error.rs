//! What can be wrong with a problem in files.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::Path;

use crate::located::{Fault, FilePlace, Located, Position};

/// Why a problem was not read, and where.
pub type ProblemError = Located<ProblemFault>;

/// Why a problem was not read.
#[derive(Debug)]
#[non_exhaustive]
pub enum ProblemFault {
    /// The operating system refused.
    Io(io::Error),
    /// Not a ZIP archive; what is wrong with it.
    Archive(String),
    /// The array at the place, which must be there, is not.
    Missing {
        /// What it should be.
        meaning: &'static str,
    },
    /// The array at the place means nothing.
    Unknown {
        /// The key that was probably meant.
        nearest: Option<String>,
    },
    /// A line of a Matrix Market file that cannot be read.
    Line {
        /// What it should be.
        expected: String,
        /// What it is.
        found: String,
    },
    /// Something of another kind or size than expected.
    Wrong {
        /// What it should be.
        expected: String,
        /// What it is.
        found: String,
    },
}

impl Fault for ProblemFault {
    fn code(&self) -> &'static str {
        match self {
            ProblemFault::Io(_) => "problem::io",
            ProblemFault::Archive(_) => "problem::archive",
            ProblemFault::Missing { .. } => "problem::missing",
            ProblemFault::Unknown { .. } => "problem::unknown",
            ProblemFault::Line { .. } => "problem::line",
            ProblemFault::Wrong { .. } => "problem::wrong",
        }
    }

    fn tell(&self, place: &FilePlace, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = place.path.display();
        let (key, line) = match &place.position {
            Position::Part(key) => (key.as_str(), 0),
            Position::Line(line) => ("", *line),
            _ => ("", 0),
        };
        match self {
            ProblemFault::Io(_) => write!(f, "cannot read `{path}`"),
            ProblemFault::Archive(reason) => write!(f, "`{path}` is no .npz archive: {reason}"),
            ProblemFault::Missing { meaning } => write!(f, "`{path}` has no `{key}`: {meaning}"),
            ProblemFault::Unknown { nearest } => {
                write!(f, "`{path}` has `{key}`, which means nothing here")?;
                match nearest {
                    Some(name) => write!(f, "; did you mean `{name}`?"),
                    None => Ok(()),
                }
            }
            ProblemFault::Line { expected, found } => write!(
                f,
                "`{path}`, line {line}: expected {expected}, found {found}"
            ),
            ProblemFault::Wrong { expected, found } => {
                write!(f, "`{key}` in `{path}`: expected {expected}, found {found}")
            }
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            ProblemFault::Archive(_) => {
                "write it by `numpy.savez`, or give a folder of Matrix Market files"
            }
            ProblemFault::Missing { .. } => "docs/problem-files.md lists the keys",
            ProblemFault::Unknown { .. } => {
                "docs/problem-files.md lists the keys; what stands under `info/` is ignored"
            }
            ProblemFault::Wrong { .. } => "docs/problem-files.md says what belongs there",
            ProblemFault::Io(_) | ProblemFault::Line { .. } => return None,
        };
        Some(help.to_owned())
    }

    fn cause(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            ProblemFault::Io(error) => Some(error),
            _ => None,
        }
    }
}

impl ProblemFault {
    /// In an array, or a key of a table.
    pub fn at(self, path: impl AsRef<Path>, key: impl Into<String>) -> ProblemError {
        let (path, position) = (path.as_ref().to_owned(), Position::Part(key.into()));
        Located::new(self, FilePlace { path, position })
    }

    /// On a line of a text.
    pub(super) fn on(self, path: &Path, line: usize) -> ProblemError {
        let (path, position) = (path.to_owned(), Position::Line(line));
        Located::new(self, FilePlace { path, position })
    }

    /// For `map_err`.
    pub(super) fn io(path: &Path) -> impl FnOnce(io::Error) -> ProblemError {
        let path = path.to_owned();
        move |error| Located::new(Self::Io(error), path)
    }
}
