//! ParaView collections (`.pvd`): one file to open for all files of a run.

use std::io::Write;

use crate::error::WriteError;
use crate::xml::escape;

/// One file of a collection.
#[derive(Clone, Debug, PartialEq)]
pub struct PvdPart<'a> {
    /// What ParaView calls the part.
    pub name: &'a str,
    /// The file, as a path relative to the collection's, with `/` between directories.
    pub file: &'a str,
    /// The instant it belongs to; parts of the same instant are shown together.
    pub time: f64,
}

/// Writes a collection. Parts are numbered within their instant, in the order given.
///
/// # Errors
/// [`WriteError::NotFinite`] for such an instant; those of the stream.
pub fn write(out: &mut dyn Write, parts: &[PvdPart<'_>]) -> Result<(), WriteError> {
    writeln!(out, "<?xml version=\"1.0\"?>")?;
    writeln!(out, "<VTKFile type=\"Collection\" version=\"0.1\">")?;
    writeln!(out, "  <Collection>")?;
    for (i, part) in parts.iter().enumerate() {
        if !part.time.is_finite() {
            return Err(WriteError::NotFinite {
                field: "time".to_owned(),
                place: format!("part `{}`", part.name),
                value: part.time,
            });
        }
        let number = parts[..i]
            .iter()
            .filter(|other| other.time == part.time)
            .count();
        writeln!(
            out,
            "    <DataSet timestep=\"{:?}\" part=\"{number}\" name=\"{}\" file=\"{}\"/>",
            part.time,
            escape(part.name),
            escape(part.file),
        )?;
    }
    writeln!(out, "  </Collection>")?;
    writeln!(out, "</VTKFile>")?;
    Ok(())
}
