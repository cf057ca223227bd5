//! Surfaces of bodies, written `body.face`.

use tresca_io::names::{listed, nearest};
use tresca_model::{PlaceName, PlaceNames};

use crate::error::{CaseError, FaultKind};
use crate::reader::Reader;
use crate::text::at::At;

/// `on`: surfaces, each `body.face`.
pub(crate) type SurfaceList = At<Vec<At<String>>>;

/// What a place has to be for something to act on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// Faces, which have an area.
    Faces,
    /// Nodes are enough.
    Nodes,
}

impl Reader<'_> {
    pub(crate) fn surfaces(
        &self,
        list: &SurfaceList,
        wanted: Wanted,
    ) -> Result<Vec<At<PlaceName>>, CaseError> {
        if list.is_empty() {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    list.span(),
                    "the list of surfaces is empty",
                    "expected at least one `body.face`",
                )
                .with_help("remove the whole table if it is not wanted"));
        }
        let mut surfaces: Vec<At<PlaceName>> = Vec::with_capacity(list.len());
        for name in list.iter() {
            let surface = self.place(name, wanted)?;
            if let Some(first) = surfaces.iter().find(|other| **other == surface) {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        surface.span(),
                        "this surface is listed twice",
                        "the second time",
                    )
                    .and_at(first.span(), "the first time")
                    .with_help("remove one of the two, or correct it"));
            }
            surfaces.push(surface);
        }
        Ok(surfaces)
    }

    pub(crate) fn surface(&self, name: &At<String>) -> Result<At<PlaceName>, CaseError> {
        self.place(name, Wanted::Faces)
    }

    fn place(&self, name: &At<String>, wanted: Wanted) -> Result<At<PlaceName>, CaseError> {
        let span = name.span();
        let fault = |message: String, label: String| {
            self.fault(FaultKind::BadReference, span.clone(), message, label)
        };
        let Some((body_name, face)) = name.split_once('.') else {
            return Err(fault(
                format!("`{}` is not the name of a surface", name.value),
                "expected `body.face`, found no dot".to_owned(),
            )
            .with_help("surfaces are written with body and face, as in `upper.z-`"));
        };
        let names = self.origins.body_names();
        let Some(body) = names.iter().position(|&name| name == body_name) else {
            return Err(fault(
                format!("there is no body `{body_name}`"),
                match nearest(body_name, names.iter().copied()) {
                    Some(near) => format!("did you mean `{near}.{face}`?"),
                    None => "expected `body.face` of a body of this file".to_owned(),
                },
            )
            .with_help(format!("the bodies of this case are {}", listed(&names))));
        };
        let body = &self.origins.bodies[body];
        let found = || At::new(span.clone(), PlaceName::from((body_name, face)));
        let among = |names: &[String]| names.iter().any(|name| name == face);
        let is_node_set = among(&body.node_sets);
        if among(&body.faces) || is_node_set && wanted == Wanted::Nodes {
            return Ok(found());
        }
        if let Some(reason) = body.unusable.get(face) {
            return Err(self.bad_mesh(span.clone(), reason));
        }
        if is_node_set {
            return Err(fault(
                format!("`{}` is a set of nodes, not a surface", name.value),
                "expected faces".to_owned(),
            )
            .with_help(faces_help(
                &body.faces,
                &body.mesh,
                "only clamps and supports act on points and curves; ",
            )));
        }
        let known = match wanted {
            Wanted::Faces => &body.faces,
            Wanted::Nodes => &body.node_sets,
        };
        let word = &body.mesh;
        Err(fault(
            format!("the body `{body_name}` has no face `{face}`"),
            match nearest(face, known.iter().map(String::as_str)) {
                Some(near) => format!("did you mean `{body_name}.{near}`?"),
                None => format!("expected a face of {word}"),
            },
        )
        .with_help(faces_help(known, word, "")))
    }

    /// Bodies by name, in the order of the model; all of them without a list.
    pub(crate) fn body_list(
        &self,
        list: Option<&At<Vec<At<String>>>>,
    ) -> Result<PlaceNames, CaseError> {
        let names = self.origins.body_names();
        let Some(list) = list else {
            return Ok(names.into_iter().collect());
        };
        if list.is_empty() {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    list.span(),
                    "the list of bodies is empty",
                    "expected at least one name",
                )
                .with_help("without `bodies` all of them are meant"));
        }
        let mut indices: Vec<usize> = Vec::new();
        for name in list.iter() {
            let wanted = name.as_str();
            let Some(body) = names.iter().position(|&name| name == wanted) else {
                return Err(self
                    .fault(
                        FaultKind::BadReference,
                        name.span(),
                        format!("there is no body `{wanted}`"),
                        match nearest(wanted, names.iter().copied()) {
                            Some(near) => format!("did you mean `{near}`?"),
                            None => "expected the name of a body of this file".to_owned(),
                        },
                    )
                    .with_help(format!("the bodies of this case are {}", listed(&names))));
            };
            if indices.contains(&body) {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        name.span(),
                        "this body is listed twice",
                        "the second time",
                    )
                    .with_help("remove one of the two, or correct it"));
            }
            indices.push(body);
        }
        indices.sort_unstable();
        Ok(indices.into_iter().map(|body| names[body]).collect())
    }
}

fn faces_help(names: &[String], word: &str, ahead: &str) -> String {
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    match names.as_slice() {
        [] => format!("{ahead}{word} has no named faces: give it surface groups and mesh again"),
        _ => format!("{ahead}the faces of {word} are {}", listed(&names)),
    }
}
