//! What can be wrong with a problem in files.

use std::io;
use std::path::{Path, PathBuf};

/// Why a problem was not read.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum ProblemError {
    /// The operating system refused.
    #[error("cannot read `{}`", path.display())]
    #[diagnostic(code(problem::io))]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the operating system says.
        #[source]
        source: io::Error,
    },
    /// Not a ZIP archive.
    #[error("`{}` is no .npz archive: {reason}", path.display())]
    #[diagnostic(
        code(problem::archive),
        help("write it by `numpy.savez`, or give a folder of Matrix Market files")
    )]
    Archive {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// Something that must be there is not.
    #[error("`{}` has no `{key}`: {meaning}", path.display())]
    #[diagnostic(code(problem::missing), help("docs/problem-files.md lists the keys"))]
    Missing {
        /// The file or folder.
        path: PathBuf,
        /// What is missing.
        key: String,
        /// What it should be.
        meaning: &'static str,
    },
    /// Something that means nothing.
    #[error("`{}` has `{key}`, which means nothing here{}", path.display(), nearest_hint(nearest.as_deref()))]
    #[diagnostic(
        code(problem::unknown),
        help("docs/problem-files.md lists the keys; what stands under `info/` is ignored")
    )]
    Unknown {
        /// The file or folder.
        path: PathBuf,
        /// The key found.
        key: String,
        /// The key that was probably meant.
        nearest: Option<String>,
    },
    /// Something of another kind or size than expected.
    #[error("`{key}` in `{}`: expected {expected}, found {found}", path.display())]
    #[diagnostic(
        code(problem::wrong),
        help("docs/problem-files.md says what belongs there")
    )]
    Wrong {
        /// The file.
        path: PathBuf,
        /// The key.
        key: String,
        /// What it should be.
        expected: String,
        /// What it is.
        found: String,
    },
    /// A line of a Matrix Market file that cannot be read.
    #[error("`{}`, line {line}: expected {expected}, found {found}", path.display())]
    #[diagnostic(code(problem::line))]
    Line {
        /// The file.
        path: PathBuf,
        /// Its line, from 1.
        line: usize,
        /// What it should be.
        expected: String,
        /// What it is.
        found: String,
    },
}

fn nearest_hint(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

impl ProblemError {
    /// For `map_err`.
    pub(super) fn io(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { path, source }
    }
}
