//! Gmsh's MSH format, versions 2.2 and 4.1, as text and binary.
//!
//! Source: the Gmsh reference manual, chapter "Gmsh file formats". A file is a sequence of sections
//! `$Name … $EndName`; binary files have their numbers as bytes, in the byte order of the
//! machine that wrote them, but section names and the header stay text.

mod elements;
mod input;
mod kinds;
mod v2;
mod v4;

use std::path::Path;

use super::file::{MeshFile, note_skipped};
use crate::mesh::error::{MeshFault, MeshFileError};
use elements::{Draft, Names};
use input::{Encoding, Input};

/// Versions of the format that differ for a reader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Version {
    Two,
    Four,
}

/// Reads a file that begins with `$`.
pub(super) fn parse(path: &Path, bytes: &[u8]) -> Result<MeshFile, MeshFileError> {
    let mut input = Input::new(path, bytes);
    let (version, format) = header(&mut input)?;
    let mut names = Names::new();
    let mut draft = Draft::new(path, format);
    let mut entities = v4::Entities::default();
    while let Some(section) = input.next_section()? {
        match (section, version) {
            ("$PhysicalNames", _) => names = physical_names(&mut input)?,
            ("$Nodes", Version::Two) => v2::nodes(&mut input, &mut draft)?,
            ("$Elements", Version::Two) => v2::elements(&mut input, &mut draft, &names)?,
            ("$Entities", Version::Four) => entities = v4::entities(&mut input)?,
            ("$Nodes", Version::Four) => v4::nodes(&mut input, &mut draft)?,
            ("$Elements", Version::Four) => {
                v4::elements(&mut input, &mut draft, &entities, &names)?;
            }
            ("$PartitionedEntities", _) => {
                return Err(MeshFault::Unsupported {
                    what: "a mesh in partitions".to_owned(),
                }
                .at(input.place())
                .with_help("save it in one piece: without `-part`, or behind `UnpartitionMesh;`"));
            }
            ("$ParametricNodes", _) => {
                return Err(MeshFault::Unsupported {
                    what: "a mesh with parametric nodes in version 2".to_owned(),
                }
                .at(input.place())
                .with_help("save it with `Mesh.SaveParametric = 0`, or as version 4.1"));
            }
            (other, _) => {
                note_skipped(&mut draft.skipped, other);
                input.skip_section(other)?;
                continue;
            }
        }
        input.end_section(section)?;
    }
    draft.finish(&input)
}

/// `$MeshFormat`: version, encoding, width of sizes.
fn header(input: &mut Input<'_>) -> Result<(Version, String), MeshFileError> {
    let first = input.next_section()?.unwrap_or_default();
    if first != "$MeshFormat" {
        let found = match first {
            // Version 1 has no header.
            "$NOD" => "1".to_owned(),
            _ => return Err(MeshFault::syntax(input.place(), "`$MeshFormat`", first)),
        };
        return Err(MeshFault::Version { found }.at(input.place()));
    }
    let place = input.place();
    let text = input.word("the version of the format")?;
    let version = match text.split_once('.').unwrap_or((text, "0")) {
        ("2", "0" | "1" | "2") => Version::Two,
        ("4", "1") => Version::Four,
        _ => {
            return Err(MeshFault::Version {
                found: text.to_owned(),
            }
            .at(place));
        }
    };
    let place = input.place();
    let binary = match input.word("0 for text or 1 for binary")? {
        "0" => false,
        "1" => true,
        other => {
            return Err(MeshFault::syntax(
                place,
                "0 for text or 1 for binary",
                other,
            ));
        }
    };
    let place = input.place();
    let width = match input.word("the width of a size in bytes")? {
        "8" => 8,
        "4" if version == Version::Four => 4,
        other => {
            return Err(MeshFault::syntax(
                place,
                "8, the width of a number in bytes",
                other,
            ));
        }
    };
    if binary {
        input.detect_byte_order(width)?;
    }
    input.end_section("$MeshFormat")?;
    let encoding = match input.encoding() {
        Encoding::Text => "text",
        Encoding::Binary { .. } => "binary",
    };
    Ok((version, format!("Gmsh MSH {text}, {encoding}")))
}

/// `$PhysicalNames`: always text.
fn physical_names(input: &mut Input<'_>) -> Result<Names, MeshFileError> {
    let count: usize = input.number_in_text("the number of names")?;
    let mut names = Names::new();
    for _ in 0..count {
        let dimension: usize = input.number_in_text("the dimension of a physical group")?;
        let number: i32 = input.number_in_text("the number of a physical group")?;
        names.insert(
            (dimension, number),
            input.quoted("the name of a physical group")?,
        );
    }
    Ok(names)
}
