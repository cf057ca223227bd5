//! The mesh of a body: where it comes from, and where it goes.

mod block;
mod file;

use std::collections::BTreeMap;

use serde::Deserialize;
use tresca_fem::FemError;
use tresca_fem::mesh::Mesh;
use tresca_io::mesh::{MeshFileError, MeshNote};
use tresca_io::names::listed;

use crate::error::{CaseError, FaultKind, semantic};
use crate::placement::RotateKeys;
use crate::reader::Reader;
use crate::text::at::At;
use block::{BrickKeys, RectangleKeys};
use tresca_io::located::Span;

pub use block::MAX_NODES;

/// `mesh`: where the mesh comes from, and where it goes. One of `brick`, `rectangle` and `file` is
/// given, which is checked afterwards, so that the report can say so.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ brick = { … } }`, `{ rectangle = { … } }` or `{ file = \"….msh\" }`"
)]
pub(crate) struct MeshKeys {
    /// A box.
    pub brick: Option<At<BrickKeys>>,
    /// A rectangle.
    pub rectangle: Option<At<RectangleKeys>>,
    /// Path of a mesh file, relative to the case file.
    pub file: Option<At<String>>,
    /// The group of the file that is the body. Default: all of it.
    pub part: Option<At<String>>,
    /// Factor of all coordinates, positive. Default: 1.
    pub scale: Option<At<f64>>,
    /// A rotation, behind the scale.
    pub rotate: Option<At<RotateKeys>>,
    /// A translation (length), behind the rotation.
    pub translate: Option<At<Vec<At<f64>>>>,
}

/// A mesh, and what reports say about it.
pub(crate) struct NamedMesh {
    pub mesh: Mesh,
    /// What it is called, with an article.
    pub word: String,
    /// Names that its file has for surfaces that cannot be used, with the reason.
    pub unusable: BTreeMap<String, MeshFileError>,
    /// What may be a mistake.
    pub notes: Vec<MeshNote>,
}

impl Reader<'_> {
    /// The mesh of a body, placed. `mapped`: its coordinates are not yet those of the body.
    pub(crate) fn mesh(
        &mut self,
        keys: At<MeshKeys>,
        mapped: bool,
    ) -> Result<NamedMesh, CaseError> {
        let span = keys.span();
        let keys = keys.value;
        self.one_mesh(&keys, &span)?;
        let placement = self.placement(
            keys.scale.as_ref(),
            keys.rotate.as_ref(),
            keys.translate.as_ref(),
        )?;
        if let (Some(part), None) = (&keys.part, &keys.file) {
            return Err(self
                .fault(
                    FaultKind::UnknownKey,
                    part.span(),
                    "only the mesh of a file has parts",
                    "expected `file` along with it",
                )
                .with_help("remove the key `part`"));
        }
        let (mesh, word) = if let Some(brick) = &keys.brick {
            (self.brick(brick)?, "a brick")
        } else if let Some(rectangle) = &keys.rectangle {
            let placed = mapped || !placement.is_identity();
            (self.rectangle(rectangle, placed)?, "a rectangle")
        } else if let Some(file) = &keys.file {
            return self.file_mesh(file, keys.part.as_ref(), &placement);
        } else {
            return Err(self
                .fault(
                    FaultKind::MissingKey,
                    span,
                    "the body has no mesh",
                    "expected `brick`, `rectangle` or `file`",
                )
                .with_help("meshes of Gmsh, Abaqus and CalculiX are given as in `mesh = { file = \"part.msh\" }`")
                );
        };
        let mesh = mesh.and_then(|mesh| match placement.is_identity() {
            true => Ok(mesh),
            false => mesh.mapped(|point| placement.apply(point)),
        });
        let mesh = mesh.and_then(|mesh| match mapped {
            true => Ok(mesh),
            false => self.in_its_space(mesh),
        });
        Ok(NamedMesh {
            mesh: mesh.map_err(|error| {
                let help = "a brick or a rectangle is given by its corners `min` < `max` and by 2 or more \
                            `nodes` per axis; in the plane it is turned about z only";
                semantic(self.source, span, error.to_string(), "this mesh", help)
            })?,
            word: word.to_owned(),
            unusable: BTreeMap::new(),
            notes: Vec::new(),
        })
    }

    /// The mesh in the space of the analysis: rectangles are made and moved in the plane.
    pub(crate) fn in_its_space(&self, mut mesh: Mesh) -> Result<Mesh, FemError> {
        mesh.space = self.analysis.space();
        mesh.validate()?;
        Ok(mesh)
    }

    fn one_mesh(&self, keys: &MeshKeys, span: &Span) -> Result<(), CaseError> {
        let given: Vec<&str> = [
            ("brick", keys.brick.is_some()),
            ("rectangle", keys.rectangle.is_some()),
            ("file", keys.file.is_some()),
        ]
        .into_iter()
        .filter_map(|(key, given)| given.then_some(key))
        .collect();
        if given.len() < 2 {
            return Ok(());
        }
        Err(self
            .fault(
                FaultKind::Duplicate,
                span.clone(),
                format!("{} exclude each other", listed(&given)),
                "expected one of them",
            )
            .with_help("each body has its own [[body]]"))
    }
}
