//! Contact problems as matrices in files: one `.npz` archive, or a folder of Matrix Market files.
//!
//! Both hold the same arrays under the same keys (docs/problem-files.md). Here they are read and written, and
//! checked as far as a file goes; whether they fit each other is the solver's business.

mod arrays;
mod content;
mod error;
mod matrix_market;
mod npz;

pub use arrays::{DenseArray, Sparse};
pub use content::{Content, KEYS, Words};
pub use error::{ProblemError, ProblemFault};
pub use matrix_market::write_folder;
pub use npz::{Archive, write_npz};

use std::path::Path;

/// Reads a problem: a folder of Matrix Market files or an `.npz` archive.
///
/// # Errors
/// Everything that is wrong with a file, with its name and the key.
pub fn read(path: &Path) -> Result<Content, ProblemError> {
    if path.is_dir() {
        content::collect(&mut matrix_market::Folder::open(path)?)
    } else {
        content::collect(&mut npz::Reader::open(path)?)
    }
}
