//! Problems of matrices alone: see [`tresca_system::matrices`], whose names these are; with the files that hold such
//! problems, and the matrices of a model.

mod assembly;
mod files;
mod summary;

pub use assembly::Assembly;
pub use files::{ExportError, FileError, read, write};
pub use summary::{ContactFigures, Summary, TimeFigures};
pub use tresca_system::matrices::*;

/// The examples of the page are compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../../../docs/bring-your-own-matrices.md")]
struct Page;
