//! From keys to case: names are resolved, values checked, as far as no stiffness is needed.

use std::cell::RefCell;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use toml::Spanned;

use super::CaseFile;
use super::error::{CaseError, Fault, FaultKind};
use super::keys::{Analysis, CaseKeys};
use super::loading::Loading;
use super::loads::Clamp;
use super::source::{CaseSource, Span};
use super::surface::Wanted;
use tresca_io::mesh::MeshFile;

/// Longest name of anything, in bytes: names become parts of names of files.
const MAX_NAME: usize = 64;

/// Keys to case, with all checks.
pub(super) fn resolve<S>(keys: CaseKeys<S>, source: CaseSource) -> Result<CaseFile<S>, CaseError> {
    let check = Check {
        source: &source,
        analysis: keys
            .analysis
            .as_ref()
            .map_or_else(Analysis::default, |a| *a.get_ref()),
        analysis_span: keys.analysis.as_ref().map(Spanned::span),
        mesh_files: RefCell::default(),
    };
    let analysis = check.analysis;
    let bodies = check.bodies(keys.body)?;
    let clamps = all(keys.clamp, |clamp| {
        Ok(Clamp {
            on: check.surfaces(&clamp.on, &bodies, Wanted::Nodes)?,
        })
    })?;
    let supports = all(keys.support, |keys| check.support(keys, &bodies))?;
    check.held_once(&clamps, &supports)?;
    let tractions = all(keys.traction, |keys| check.traction(keys, &bodies))?;
    let pressures = all(keys.pressure, |keys| check.pressure(keys, &bodies))?;
    let body_forces = all(keys.body_force, |keys| check.body_force(keys, &bodies))?;
    let gravities = all(keys.gravity, |keys| check.gravity(keys, &bodies))?;
    let obstacles = check.obstacles(keys.obstacle, &bodies)?;
    let contacts = check.contacts(keys.contact, &bodies, &obstacles)?;
    let steps = check.steps(
        keys.step,
        &Loading {
            supports: &supports,
            tractions: &tractions,
            pressures: &pressures,
            body_forces: &body_forces,
            gravities: &gravities,
            contacts: &contacts,
            obstacles: &obstacles,
        },
    )?;
    let title = keys.title.unwrap_or_else(|| {
        Path::new(source.name())
            .file_stem()
            .map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
    });
    Ok(CaseFile {
        title,
        analysis,
        bodies,
        clamps,
        supports,
        tractions,
        pressures,
        body_forces,
        gravities,
        obstacles,
        contacts,
        steps,
        solver: keys.solver,
        source,
    })
}

fn all<K, T>(
    list: Vec<K>,
    check: impl FnMut(K) -> Result<T, CaseError>,
) -> Result<Vec<T>, CaseError> {
    list.into_iter().map(check).collect()
}

/// What every check needs to know.
pub(super) struct Check<'a> {
    pub source: &'a CaseSource,
    pub analysis: Analysis,
    /// Where the analysis stands, if it does.
    pub analysis_span: Option<Span>,
    /// The mesh files that were read, by path: several bodies may come out of one.
    pub mesh_files: RefCell<HashMap<PathBuf, Rc<MeshFile>>>,
}

impl Check<'_> {
    pub(super) fn fault(
        &self,
        kind: FaultKind,
        span: Span,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> Fault {
        Fault::new(kind, self.source, span, message, label)
    }

    /// The name of a support, load, contact or step.
    pub(super) fn item_name(
        &self,
        name: Option<Spanned<String>>,
    ) -> Result<Option<Spanned<String>>, CaseError> {
        if let Some(name) = &name
            && let Some(label) = fault_of_name(name.get_ref())
        {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    name.span(),
                    "this cannot be a name",
                    label,
                )
                .with_help("names are written as in `left_end` or `step-2`")
                .into());
        }
        Ok(name)
    }
}

/// What keeps a text from being a name.
pub(super) fn fault_of_name(text: &str) -> Option<String> {
    let allowed = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    if text.is_empty() {
        Some("expected a name, found an empty text".to_owned())
    } else if let Some(bad) = text.chars().find(|&c| !allowed(c)) {
        Some(format!(
            "expected letters, digits, `_` and `-`, found `{}`",
            bad.escape_default()
        ))
    } else if text.len() > MAX_NAME {
        Some(format!(
            "expected at most {MAX_NAME} bytes, found {}",
            text.len()
        ))
    } else {
        None
    }
}
