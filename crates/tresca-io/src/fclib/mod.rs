//! Frictional contact problems of the Siconos group: FCLIB (HDF5) and their plain-text `.dat`.
//!
//! | problem | given | sought |
//! |---|---|---|
//! | [`FclibProblem::Local`] | W, q, μ | u = W r + q |
//! | [`FclibProblem::Global`] | M, H, f, w, μ | M v = H r + f, u = Hᵀ v + w |
//!
//! with, for every contact α, the contact force r and the relative velocity u (or displacement)
//!
//! ```text
//! 0 ≤ u_N ⟂ r_N ≥ 0,     ‖r_T‖ ≤ μ r_N,     r_T = −μ r_N u_T/‖u_T‖ where u_T ≠ 0
//! ```
//!
//! Vectors are ordered contact by contact, the normal component first and its one (plane) or two
//! (space) tangential components after it. r_N presses, u_N opens.
//!
//! [`read`] knows a file's format by its content; [`Document::write_dat`] and
//! `Document::write_hdf5` write. Without the feature `fclib` HDF5 files are refused by name.
//!
//! Not taken over are the parts of FCLIB that add linear constraints to a problem (G, b and V, R, s),
//! and Siconos' rolling friction. Both are refused, not ignored.

mod dat;
pub(crate) mod error;
#[cfg(feature = "fclib")]
mod hdf5;
mod matrix;
mod problem;

use std::path::Path;

pub use error::{Defect, FclibError, FclibFault};
pub use matrix::FclibMatrix;
pub use problem::{Document, FclibProblem, GlobalProblem, Info, LocalProblem, State};

/// The first bytes of every HDF5 file without a user block, which FCLIB never writes.
const HDF5_SIGNATURE: &[u8] = b"\x89HDF\r\n\x1a\n";

/// Reads an FCLIB file or a `.dat` file, whichever it is.
///
/// # Errors
/// [`FclibFault::Io`] when the file cannot be read, [`FclibFault::Content`] with the dataset or the
/// line when its content is not in order, [`FclibFault::WithoutHdf5`] for an HDF5 file in a program
/// that was built without the feature `fclib`.
pub fn read(path: &Path) -> Result<Document, FclibError> {
    let bytes =
        std::fs::read(path).map_err(|error| FclibError::new(FclibFault::Io(error), path))?;
    let document = if bytes.starts_with(HDF5_SIGNATURE) {
        read_hdf5(bytes)
    } else {
        dat::read(&String::from_utf8_lossy(&bytes))
    };
    document.map_err(|problem| problem.of_file(path))
}

#[cfg(feature = "fclib")]
fn read_hdf5(bytes: Vec<u8>) -> Result<Document, error::Trouble> {
    hdf5::read(bytes)
}

#[cfg(not(feature = "fclib"))]
fn read_hdf5(_: Vec<u8>) -> Result<Document, error::Trouble> {
    Err(error::Trouble::WithoutHdf5)
}
