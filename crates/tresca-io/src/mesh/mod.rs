//! Mesh files: Gmsh's MSH 2.2 and 4.1, in text and binary, and decks of Abaqus and CalculiX.
//!
//! ```
//! use tresca_fem::mesh::Space;
//! use tresca_io::mesh::{Placement, parse};
//!
//! let deck = "*NODE
//! 1, 0, 0\n2, 2, 0\n3, 2, 1\n4, 0, 1
//! *ELEMENT, TYPE=CPS4, ELSET=plate
//! 1, 1, 2, 3, 4
//! *SURFACE, NAME=left
//! plate, S4
//! ";
//! let file = parse("plate.inp", deck.as_bytes())?;
//! let body = file.body(Space::Plane, Some("plate"), &Placement::default())?;
//! assert!((body.mesh.volume() - 2.0).abs() < 1e-14);
//! assert_eq!(body.mesh.nodes_of_set("left")?, [0, 3]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`MeshFile`] is what the file says, in our numbering of the nodes of an element (VTK's):
//! points, cells of every dimension, groups by name. [`MeshFile::body`] makes a body of a part of
//! it, with checks; [`MeshFile::surface`] a rigid surface. `docs/meshes.md` tells users the same.
//!
//! The readers are our own because no crate reads both versions of Gmsh's format, or decks at all:
//! see `docs/adr/0010-own-mesh-readers.md`.

mod abaqus;
mod body;
mod cells;
mod error;
mod faces;
mod file;
mod flat;
mod gmsh;
mod numbering;
mod order;
mod placement;
mod surface;

use std::path::Path;

pub use body::{BodyMesh, note::MeshNote};
pub use cells::FileCells;
pub use error::{MeshFault, MeshFileError};
pub use file::{Group, MeshFile};
pub use placement::{Placement, Rotation};
pub use surface::SurfaceMesh;

/// Reads a mesh file. What it is decides its content, not its name.
///
/// # Errors
/// Whatever keeps the file from being understood; what keeps its mesh from being used is found by
/// [`MeshFile::body`] and [`MeshFile::surface`].
pub fn read(path: impl AsRef<Path>) -> Result<MeshFile, MeshFileError> {
    let path = path.as_ref();
    let bytes = std::fs::read(path).map_err(MeshFault::unreadable(path))?;
    parse(path, &bytes)
}

/// As [`read`], from memory; `path` is what errors call it.
///
/// # Errors
/// As [`read`].
pub fn parse(path: impl AsRef<Path>, bytes: &[u8]) -> Result<MeshFile, MeshFileError> {
    let path = path.as_ref();
    // Some editors put a byte order mark ahead of the text.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match bytes.iter().find(|byte| !byte.is_ascii_whitespace()) {
        Some(b'$') => gmsh::parse(path, bytes),
        Some(b'*') => abaqus::parse(path, bytes),
        _ => {
            let start = &bytes[..bytes.len().min(24)];
            let text = String::from_utf8_lossy(start);
            Err(MeshFault::Format {
                found: text.escape_debug().to_string(),
            }
            .at(path.to_owned()))
        }
    }
}
