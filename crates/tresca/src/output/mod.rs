//! The result files of a run.

mod check;
mod fclib;
mod history;
mod matrices;
mod model;

use std::io::Write;
use std::path::{Path, PathBuf};

use tresca_io::WriteError;
use tresca_io::atomic::OutputSet;

use tresca_model::Body;

/// Name of the file with the contact fields.
const CONTACT: &str = "contact";
/// Name of the file with the report.
const SUMMARY: &str = "summary.json";

/// A directory that result files can be written to. Made before a run, so that a run does not
/// find out at its end that it has no place for its results.
#[derive(Debug)]
pub struct Destination {
    directory: PathBuf,
}

impl Destination {
    /// A directory that exists or can be made; nothing is made yet.
    ///
    /// # Errors
    /// When a file stands where the directory, or one of its parents, should be.
    pub fn new(directory: &Path) -> Result<Self, WriteError> {
        let existing = directory.ancestors().find(|path| path.exists());
        if let Some(obstacle) = existing.filter(|path| !path.is_dir()) {
            return Err(WriteError::Io {
                action: "create the directory",
                path: directory.to_owned(),
                source: std::io::Error::new(
                    std::io::ErrorKind::NotADirectory,
                    format!("`{}` is a file", obstacle.display()),
                ),
            });
        }
        Ok(Self {
            directory: directory.to_owned(),
        })
    }
}

/// Writes a single file, whole or not at all, replacing an earlier one.
///
/// # Errors
/// Those of `write` and of the file system.
pub fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>,
) -> Result<(), WriteError> {
    let directory = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    let mut files = OutputSet::new(directory.unwrap_or(Path::new(".")))?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    files.stage(&name, write)?;
    files.commit()?;
    Ok(())
}

/// A field over the full dofs as vectors at the nodes; VTK's vectors have three components in the plane, too.
fn node_vectors(body: &Body, values: &[f64]) -> Vec<[f64; 3]> {
    let of_node = |u: &[f64]| [u[0], u[1], u.get(2).copied().unwrap_or(0.0)];
    let nodes = values.chunks_exact(body.mesh.dimension());
    nodes.map(of_node).collect()
}
