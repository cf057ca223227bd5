//! The case file: a TOML text that describes bodies, supports, loads and contact pairs.
//!
//! ```
//! #[derive(Default, serde::Deserialize)]
//! #[serde(deny_unknown_fields)]
//! struct Solver {
//!     tolerance: Option<f64>,
//! }
//!
//! let text = r#"
//!     [[body]]
//!     name = "block"
//!     mesh = { brick = { min = [0, 0, 0], max = [2, 1, 1], nodes = [5, 3, 3] } }
//!     material = { young = 5.0e4, poisson = 0.3 }
//!
//!     [[clamp]]
//!     on = ["block.z-"]
//! "#;
//! let case = tresca_case::parse::<Solver>("block.toml", text)?;
//! assert_eq!(case.bodies[0].material.get_ref().poisson.get_ref(), &0.3);
//! assert_eq!(case.clamps[0].on[0].face, "z-");
//! # Ok::<(), tresca_case::CaseError>(())
//! ```
//!
//! Reading goes in three steps, each with its own sort of error, all of them a [`CaseError`]: text to
//! TOML, TOML to keys (the `keys` module, where every key is documented), and the checks that need no stiffness.
//! Mesh files are read for them. What needs a stiffness or the list of solver settings is checked by whoever has it, and
//! reported through [`CaseError::semantic`] with a span kept here or found by [`CaseSource::locate`].

mod amounts;
mod body;
mod build;
mod case;
mod check;
mod contact;
mod entries;
mod error;
pub mod expression;
mod fields;
mod friction;
mod keys;
mod loading;
mod loads;
mod mesh;
mod obstacle;
mod placement;
mod precheck;
mod samples;
mod source;
mod steps;
mod surface;
mod translate;
mod values;

use std::io;
use std::path::Path;

use serde::Deserialize;
use serde::de::{DeserializeOwned, IntoDeserializer};
use toml::de::DeTable;

pub use amounts::{Amount, Amounts, Quantity};
pub use body::Body;
pub use case::Case;
pub use contact::{Contact, Partners};
pub use entries::{Components, Pair, Triple};
pub use error::{CaseError, Fault, FaultKind};
pub use fields::{Field, VectorField};
pub use friction::{Friction, LAWS};
pub use keys::{Analysis, Brick, BrickCells, Coupling, Material, PlaneCells, Rectangle};
pub use loads::{BodyForce, Clamp, Gravity, Pressure, Support, Traction};
pub use mesh::{FileMesh, Mesh};
pub use obstacle::{Obstacle, ObstacleShape};
pub use samples::Samples;
pub use source::{CaseSource, Span};
pub use steps::{MAX_INCREMENTS, Step};
pub use surface::Surface;
pub use toml::Spanned;
pub use tresca_fem::assembly::Formulation;
pub use values::MAX_NODES;

/// A case file whose names are resolved and whose values are possible. `S` holds the solver's
/// settings: the caller's type, so that no solver key is known here; it should refuse unknown keys
/// (`#[serde(deny_unknown_fields)]`), which are then reported like all others.
#[derive(Clone, Debug)]
pub struct CaseFile<S> {
    /// Headline; the file's name without extension where none was given.
    pub title: String,
    /// What the coordinates mean, and how many there are.
    pub analysis: Analysis,
    /// At least one; names differ, also when case is ignored, for they become names of files.
    pub bodies: Vec<Body>,
    /// Surfaces with zero displacement.
    pub clamps: Vec<Clamp>,
    /// Prescribed components of the displacement, none of them twice on a surface. Whether two
    /// surfaces contradict each other at a node they share is for the caller to check.
    pub supports: Vec<Support>,
    /// Forces per area. A surface may stand in several of them: they add up.
    pub tractions: Vec<Traction>,
    /// Forces per area along the normal, added to the tractions.
    pub pressures: Vec<Pressure>,
    /// Forces per volume; they add up.
    pub body_forces: Vec<BodyForce>,
    /// Accelerations that act on masses; they add up.
    pub gravities: Vec<Gravity>,
    /// Rigid bodies that the others may touch; their names differ from those of the bodies, too.
    pub obstacles: Vec<Obstacle>,
    /// Surfaces that may touch; may be empty.
    pub contacts: Vec<Contact>,
    /// The history of loading, increment after increment; at least one.
    pub steps: Vec<Step>,
    /// The `[solver]` table; `S::default()` without one.
    pub solver: S,
    /// Name and text, for reports of later checks.
    pub source: CaseSource,
}

/// Reads and checks a case file.
///
/// # Errors
/// Whatever is wrong with the file, see [`CaseError`].
pub fn read<S: DeserializeOwned + Default>(
    path: impl AsRef<Path>,
) -> Result<CaseFile<S>, CaseError> {
    let path = path.as_ref();
    let bytes = std::fs::read(path).map_err(|error| unreadable(path, error))?;
    let text = String::from_utf8(bytes).map_err(|error| not_text(path, &error))?;
    parse(&path.display().to_string(), &text)
}

/// Checks the text of a case file; `name` is what reports call it. Files that the text refers to
/// are read, and count from the directory of `name`.
///
/// # Errors
/// As [`read`], without those of reading the case file itself.
pub fn parse<S: DeserializeOwned + Default>(
    name: &str,
    text: &str,
) -> Result<CaseFile<S>, CaseError> {
    let source = CaseSource::new(name, text);
    let table =
        DeTable::parse(source.text()).map_err(|error| translate::syntax_error(&source, &error))?;
    precheck::friction_laws(&source, table.get_ref())?;
    precheck::lists_for_tables(&source, table.get_ref())?;
    let keys = keys::CaseKeys::deserialize(table.into_deserializer())
        .map_err(|error| translate::shape_error(&source, &error))?;
    check::resolve(keys, source)
}

fn unreadable(path: &Path, error: io::Error) -> CaseError {
    let (reason, help, source) = if path.is_dir() {
        let help = "name the case file inside it, such as `case.toml`";
        ("it is a directory", Some(help.to_owned()), None)
    } else if error.kind() == io::ErrorKind::NotFound {
        ("there is no such file", Some(missing_file(path)), None)
    } else {
        ("the system refuses", None, Some(error))
    };
    CaseError::Unreadable {
        path: path.to_owned(),
        reason,
        help,
        source,
    }
}

/// The likely cause of a missing file: another name in the same directory, or a missing directory.
fn missing_file(path: &Path) -> String {
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let Ok(entries) = std::fs::read_dir(directory) else {
        return format!("there is no directory `{}` either", directory.display());
    };
    let names: Vec<String> = entries
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name.ends_with(".toml"))
        .collect();
    let wanted = path.file_name().unwrap_or_default().to_string_lossy();
    match tresca_io::names::nearest(&wanted, names.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{}`?", path.with_file_name(near).display()),
        None => {
            "a path that does not start at the root counts from the current directory".to_owned()
        }
    }
}

fn not_text(path: &Path, error: &std::string::FromUtf8Error) -> CaseError {
    let bad = error.utf8_error().valid_up_to();
    let good = String::from_utf8_lossy(&error.as_bytes()[..bad]).into_owned();
    let (line, column) = CaseSource::new("", good).line_column(bad);
    CaseError::NotText {
        path: path.to_owned(),
        line,
        column,
        byte: error.as_bytes()[bad],
    }
}
