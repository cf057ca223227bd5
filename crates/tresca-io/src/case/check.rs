//! From keys to case: names are resolved, values checked (`values`), as far as no mesh is needed.

use std::path::Path;

use toml::Spanned;

use super::error::{CaseError, Fault, FaultKind};
use super::keys::{Body, CaseKeys, ContactKeys, FrictionKeys, Mesh};
use super::source::{CaseSource, Span};
use super::translate::{listed, nearest};
use super::{BRICK_FACES, CaseFile, Clamp, Contact, Friction, SlipBound, Surface, Traction};

/// Longest name of a body, in bytes: it becomes part of names of files.
const MAX_NAME: usize = 64;

/// Names that the files of every run have, beside those of the bodies.
const RESERVED_NAMES: [&str; 3] = ["contact", "history", "summary"];

/// Keys to case, with all checks.
pub(super) fn resolve<S>(keys: CaseKeys<S>, source: CaseSource) -> Result<CaseFile<S>, CaseError> {
    let check = Check { source: &source };
    let bodies = check.bodies(keys.body)?;
    let clamps = keys
        .clamp
        .into_iter()
        .map(|clamp| {
            Ok(Clamp {
                on: check.surfaces(&clamp.on, &bodies)?,
            })
        })
        .collect::<Result<_, CaseError>>()?;
    let tractions = keys
        .traction
        .into_iter()
        .map(|traction| {
            check.finite_triple("the traction", &traction.value)?;
            Ok(Traction {
                on: check.surfaces(&traction.on, &bodies)?,
                value: traction.value,
            })
        })
        .collect::<Result<_, CaseError>>()?;
    let contacts = check.contacts(keys.contact, &bodies)?;
    let title = keys.title.unwrap_or_else(|| {
        Path::new(source.name())
            .file_stem()
            .map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
    });
    Ok(CaseFile {
        title,
        bodies,
        clamps,
        tractions,
        contacts,
        solver: keys.solver,
        source,
    })
}

pub(super) struct Check<'a> {
    source: &'a CaseSource,
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

    fn bodies(&self, list: Option<Spanned<Vec<Body>>>) -> Result<Vec<Body>, CaseError> {
        let (span, bodies) = match list {
            Some(list) => (list.span(), list.into_inner()),
            None => (0..0, Vec::new()),
        };
        if bodies.is_empty() {
            return Err(self
                .fault(
                    FaultKind::MissingKey,
                    span,
                    "the case has no body",
                    "expected at least one [[body]]",
                )
                .with_help("a body is a table [[body]] with the keys `name`, `mesh` and `material`")
                .into());
        }
        for (i, body) in bodies.iter().enumerate() {
            self.body_name(&body.name)?;
            if let Some(other) = bodies[..i].iter().find(|other| same_file_name(other, body)) {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        body.name.span(),
                        format!("two bodies are called `{}`", body.name.get_ref()),
                        "the second one",
                    )
                    .and_at(other.name.span(), "the first one")
                    .with_help("give each body its own name; upper and lower case count as equal, for the names become names of files")
                    .into());
            }
            match body.mesh.get_ref() {
                Mesh::Brick(brick) => self.brick(brick)?,
            }
            self.material(body.material.get_ref())?;
        }
        Ok(bodies)
    }

    fn body_name(&self, name: &Spanned<String>) -> Result<(), CaseError> {
        let text = name.get_ref();
        let allowed = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
        let label = if text.is_empty() {
            "expected a name, found an empty text".to_owned()
        } else if let Some(bad) = text.chars().find(|&c| !allowed(c)) {
            format!(
                "expected letters, digits, `_` and `-`, found `{}`",
                bad.escape_default()
            )
        } else if text.len() > MAX_NAME {
            format!("expected at most {MAX_NAME} bytes, found {}", text.len())
        } else if RESERVED_NAMES.contains(&text.to_lowercase().as_str()) {
            "this name is taken by another file of the results".to_owned()
        } else {
            return Ok(());
        };
        Err(self
            .fault(
                FaultKind::BadValue,
                name.span(),
                "this cannot be the name of a body",
                label,
            )
            .with_help(
                "surfaces are written `body.face`, and the results of a body go to the file \
                 `body.vtu`",
            )
            .into())
    }

    fn contacts(
        &self,
        list: Vec<Spanned<ContactKeys>>,
        bodies: &[Body],
    ) -> Result<Vec<Contact>, CaseError> {
        let mut contacts: Vec<Contact> = Vec::with_capacity(list.len());
        for keys in list {
            let span = keys.span();
            let keys = keys.into_inner();
            let [slave, master] = self.pair(&keys.pair, bodies)?;
            let friction = self.friction(&keys.friction)?;
            let again = contacts.iter().find(|c| {
                (c.slave.is_same(&slave) && c.master.is_same(&master))
                    || (c.slave.is_same(&master) && c.master.is_same(&slave))
            });
            if let Some(first) = again {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        keys.pair.span(),
                        "these two surfaces are already a contact pair",
                        "the second time",
                    )
                    .and_at(first.slave.span.start..first.master.span.end, "the first time")
                    .with_help("a pair stands in one [[contact]] only: a second one would constrain the same points again")
                    .into());
            }
            contacts.push(Contact {
                slave,
                master,
                friction,
                span,
            });
        }
        Ok(contacts)
    }

    fn pair(
        &self,
        pair: &Spanned<Vec<Spanned<String>>>,
        bodies: &[Body],
    ) -> Result<[Surface; 2], CaseError> {
        let [slave, master] = pair.get_ref().as_slice() else {
            return Err(self
                .fault(
                    FaultKind::WrongType,
                    pair.span(),
                    "a contact pair has two surfaces",
                    format!("expected 2 entries, found {}", pair.get_ref().len()),
                )
                .with_help("write `pair = [\"slave.face\", \"master.face\"]`; more pairs get their own [[contact]]")
                .into());
        };
        let (slave, master) = (self.surface(slave, bodies)?, self.surface(master, bodies)?);
        if slave.is_same(&master) {
            return Err(self
                .fault(
                    FaultKind::Duplicate,
                    master.span.clone(),
                    "a surface cannot be in contact with itself",
                    "expected another surface than the first",
                )
                .and_at(slave.span.clone(), "the first")
                .with_help("a pair names the two surfaces that face each other")
                .into());
        }
        Ok([slave, master])
    }

    fn friction(&self, keys: &Spanned<FrictionKeys>) -> Result<Friction, CaseError> {
        // The only law there is: others were refused by `precheck::friction_laws`.
        let law = keys.get_ref().law.get_ref();
        let Some(bound) = &keys.get_ref().bound else {
            return Err(self
                .fault(
                    FaultKind::MissingKey,
                    keys.span(),
                    format!("the friction law `{law}` needs a `bound`"),
                    "expected `bound` in this table",
                )
                .with_help("`bound` is the tangential traction (force per area) at which the pair slides; 0.0 is no friction")
                .into());
        };
        let value = self.finite("the slip bound", bound)?;
        if value < 0.0 {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    bound.span(),
                    "the slip bound must not be negative",
                    format!("expected 0 or more, found {value:?}"),
                )
                .with_help("it is the tangential traction (force per area) at which the pair slides; 0.0 is no friction")
                .into());
        }
        Ok(Friction::Tresca {
            bound: Spanned::new(bound.span(), SlipBound::Constant(value)),
        })
    }

    fn surfaces(
        &self,
        list: &Spanned<Vec<Spanned<String>>>,
        bodies: &[Body],
    ) -> Result<Vec<Surface>, CaseError> {
        if list.get_ref().is_empty() {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    list.span(),
                    "the list of surfaces is empty",
                    "expected at least one `body.face`",
                )
                .with_help("remove the whole table if it is not wanted")
                .into());
        }
        let mut surfaces: Vec<Surface> = Vec::with_capacity(list.get_ref().len());
        for name in list.get_ref() {
            let surface = self.surface(name, bodies)?;
            if let Some(first) = surfaces.iter().find(|other| other.is_same(&surface)) {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        surface.span,
                        "this surface is listed twice",
                        "the second time",
                    )
                    .and_at(first.span.clone(), "the first time")
                    .with_help("remove one of the two, or correct it")
                    .into());
            }
            surfaces.push(surface);
        }
        Ok(surfaces)
    }

    fn surface(&self, name: &Spanned<String>, bodies: &[Body]) -> Result<Surface, CaseError> {
        let span = name.span();
        let fault = |message: String, label: String| {
            self.fault(FaultKind::BadReference, span.clone(), message, label)
        };
        let Some((body_name, face)) = name.get_ref().split_once('.') else {
            return Err(fault(
                format!("`{}` is not the name of a surface", name.get_ref()),
                "expected `body.face`, found no dot".to_owned(),
            )
            .with_help("surfaces are written with body and face, as in `upper.z-`")
            .into());
        };
        let names: Vec<&str> = bodies.iter().map(|b| b.name.get_ref().as_str()).collect();
        let Some(body) = names.iter().position(|&name| name == body_name) else {
            return Err(fault(
                format!("there is no body `{body_name}`"),
                match nearest(body_name, names.iter().copied()) {
                    Some(near) => format!("did you mean `{near}.{face}`?"),
                    None => "expected `body.face` of a body of this file".to_owned(),
                },
            )
            .with_help(format!("the bodies of this case are {}", listed(&names)))
            .into());
        };
        match bodies[body].mesh.get_ref() {
            Mesh::Brick(_) if !BRICK_FACES.contains(&face) => {
                return Err(fault(
                    format!("the body `{body_name}` has no face `{face}`"),
                    match nearest(face, BRICK_FACES) {
                        Some(near) => format!("did you mean `{body_name}.{near}`?"),
                        None => "expected a face of a brick".to_owned(),
                    },
                )
                .with_help(format!("the faces of a brick are {}", listed(&BRICK_FACES)))
                .into());
            }
            Mesh::Brick(_) => {}
        }
        Ok(Surface {
            body,
            face: face.to_owned(),
            span: span.clone(),
        })
    }
}

/// Whether two bodies would share the file of their results, on some file system.
fn same_file_name(a: &Body, b: &Body) -> bool {
    a.name.get_ref().to_lowercase() == b.name.get_ref().to_lowercase()
}
