//! Meshes of Abaqus and CalculiX decks (`.inp`).
//!
//! Source: the Abaqus Keywords Reference Guide and the CalculiX CrunchiX user's manual. A deck is a
//! sequence of keyword lines `*KEYWORD, PARAMETER=VALUE, …`, each with lines of data behind it. Of
//! the keywords only those that describe a mesh are read; those that would make nodes or elements
//! by a rule are refused, all others skipped.

mod assembly;
mod deck;
mod kinds;
mod part;
mod sets;
mod surfaces;

use std::path::Path;

use super::file::MeshFile;
use crate::mesh::error::MeshFileError;
use deck::Deck;

/// Reads a file that begins with `*`.
pub(super) fn parse(path: &Path, bytes: &[u8]) -> Result<MeshFile, MeshFileError> {
    let deck = Deck::new(path, bytes)?;
    assembly::read(&deck)
}
