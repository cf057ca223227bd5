//! Problems of matrices alone: see [`tresca_system::matrices`], whose names these are; with the files that hold such
//! problems, and the matrices of a model.

mod assembly;
mod files;

pub use assembly::Assembly;
pub use files::{ExportError, FileError, read};
pub use tresca_system::matrices::*;

/// The examples of the page are compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../../../docs/bring-your-own-matrices.md")]
struct Page;
