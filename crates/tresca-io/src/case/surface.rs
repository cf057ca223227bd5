//! Surfaces of bodies, written `body.face`.

use toml::Spanned;

use super::body::Body;
use super::check::Check;
use super::error::{CaseError, FaultKind};
use super::source::Span;
use crate::names::{listed, nearest};

/// A surface of a body, written `body.face`.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Index into [`CaseFile::bodies`](super::CaseFile::bodies).
    pub body: usize,
    /// Name of the face, one of [`Mesh::faces`](super::Mesh::faces).
    pub face: String,
    /// Where it stands.
    pub span: Span,
}

impl Surface {
    pub(super) fn is_same(&self, other: &Surface) -> bool {
        self.body == other.body && self.face == other.face
    }
}

impl Check<'_> {
    pub(super) fn surfaces(
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

    pub(super) fn surface(
        &self,
        name: &Spanned<String>,
        bodies: &[Body],
    ) -> Result<Surface, CaseError> {
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
        let mesh = bodies[body].mesh.get_ref();
        if !mesh.faces().contains(&face) {
            let word = mesh.word();
            return Err(fault(
                format!("the body `{body_name}` has no face `{face}`"),
                match nearest(face, mesh.faces().iter().copied()) {
                    Some(near) => format!("did you mean `{body_name}.{near}`?"),
                    None => format!("expected a face of a {word}"),
                },
            )
            .with_help(format!(
                "the faces of a {word} are {}",
                listed(mesh.faces())
            ))
            .into());
        }
        Ok(Surface {
            body,
            face: face.to_owned(),
            span: span.clone(),
        })
    }
}
