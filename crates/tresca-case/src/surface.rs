//! Surfaces of bodies, written `body.face`.

use toml::Spanned;

use super::body::Body;
use super::check::Check;
use super::error::{CaseError, FaultKind};
use super::source::Span;
use tresca_io::names::{listed, nearest};

/// A surface of a body, or a set of its nodes, written `body.face`.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Index into [`CaseFile::bodies`](super::CaseFile::bodies).
    pub body: usize,
    /// Its name: one of [`Mesh::faces`](super::Mesh::faces), or of
    /// [`Mesh::node_sets`](super::Mesh::node_sets).
    pub face: String,
    /// The name is that of a set of nodes and of no face: only clamps and supports have such.
    pub nodes_only: bool,
    /// Where it stands.
    pub span: Span,
}

impl Surface {
    pub(super) fn is_same(&self, other: &Surface) -> bool {
        self.body == other.body && self.face == other.face
    }
}

/// What a place has to be for something to act on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// Faces, which have an area.
    Faces,
    /// Nodes are enough.
    Nodes,
}

impl Check<'_> {
    pub(super) fn surfaces(
        &self,
        list: &Spanned<Vec<Spanned<String>>>,
        bodies: &[Body],
        wanted: Wanted,
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
            let surface = self.place(name, bodies, wanted)?;
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
        self.place(name, bodies, Wanted::Faces)
    }

    fn place(
        &self,
        name: &Spanned<String>,
        bodies: &[Body],
        wanted: Wanted,
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
        let found = |nodes_only| Surface {
            body,
            face: face.to_owned(),
            nodes_only,
            span: span.clone(),
        };
        if mesh.faces().contains(&face) {
            return Ok(found(false));
        }
        let is_node_set = mesh.node_sets().contains(&face);
        if is_node_set && wanted == Wanted::Nodes {
            return Ok(found(true));
        }
        if let Some(reason) = mesh.refusal(face) {
            return Err(self.bad_mesh(span.clone(), reason));
        }
        if is_node_set {
            return Err(fault(
                format!("`{}` is a set of nodes, not a surface", name.get_ref()),
                "expected faces".to_owned(),
            )
            .with_help(faces_help(
                &mesh.faces(),
                &mesh.word(),
                "only clamps and supports act on points and curves; ",
            ))
            .into());
        }
        let mut known = mesh.faces();
        if wanted == Wanted::Nodes {
            known = mesh.node_sets();
        }
        let word = mesh.word();
        Err(fault(
            format!("the body `{body_name}` has no face `{face}`"),
            match nearest(face, known.iter().copied()) {
                Some(near) => format!("did you mean `{body_name}.{near}`?"),
                None => format!("expected a face of {word}"),
            },
        )
        .with_help(faces_help(&known, &word, ""))
        .into())
    }
}

fn faces_help(names: &[&str], word: &str, ahead: &str) -> String {
    match names {
        [] => format!("{ahead}{word} has no named faces: give it surface groups and mesh again"),
        _ => format!("{ahead}the faces of {word} are {}", listed(names)),
    }
}
