//! Where the mesh of a body comes from, and where it goes.

use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

use toml::Spanned;
use tresca_fem::mesh::Space;

use super::check::Check;
use super::error::{CaseError, FaultKind};
use super::keys::{Analysis, Brick, MeshKeys, Rectangle};
use super::source::Span;
use tresca_io::mesh::{BodyMesh, MeshFile, MeshFileError, Placement};
use tresca_io::names::listed;

/// Where the mesh of a body comes from.
#[derive(Clone, Debug)]
pub enum Mesh {
    /// A box.
    Brick(Brick),
    /// A rectangle, in the plane.
    Rectangle(Rectangle),
    /// A part of a mesh file.
    File(FileMesh),
}

/// A mesh out of a file.
#[derive(Clone, Debug)]
pub struct FileMesh {
    /// The path as the case file gives it.
    pub file: Spanned<String>,
    /// The group of the file that is the body, if not all of it.
    pub part: Option<Spanned<String>>,
    /// The mesh, placed.
    pub body: Arc<BodyMesh>,
}

impl Mesh {
    /// Number of coordinates of its points.
    pub fn dimension(&self) -> usize {
        match self {
            Mesh::Brick(_) => 3,
            Mesh::Rectangle(_) => 2,
            Mesh::File(file) => file.body.mesh.dimension(),
        }
    }

    /// Names of its faces. Of a box: axis, then `-` for the side of `min` and `+` for that of `max`.
    pub fn faces(&self) -> Vec<&str> {
        match self {
            Mesh::Brick(_) => BRICK_FACES.to_vec(),
            Mesh::Rectangle(_) => BRICK_FACES[..4].to_vec(),
            Mesh::File(file) => {
                let sets = file.body.mesh.face_sets.keys();
                sets.map(String::as_str).collect()
            }
        }
    }

    /// Names of its sets of nodes, those of its faces among them.
    pub fn node_sets(&self) -> Vec<&str> {
        match self {
            Mesh::Brick(_) | Mesh::Rectangle(_) => self.faces(),
            Mesh::File(file) => {
                let sets = file.body.mesh.node_sets.keys();
                sets.map(String::as_str).collect()
            }
        }
    }

    /// What reports call it, with its article.
    pub(super) fn word(&self) -> String {
        match self {
            Mesh::Brick(_) => "a brick".to_owned(),
            Mesh::Rectangle(_) => "a rectangle".to_owned(),
            Mesh::File(file) => format!("the mesh of `{}`", file.file.get_ref()),
        }
    }

    /// Why a name that a file has for a surface is none of [`Mesh::faces`].
    pub(super) fn refusal(&self, face: &str) -> Option<&MeshFileError> {
        match self {
            Mesh::File(file) => file.body.unusable.get(face),
            Mesh::Brick(_) | Mesh::Rectangle(_) => None,
        }
    }
}

/// Names of the faces of a brick; the first four are those of a rectangle.
const BRICK_FACES: [&str; 6] = ["x-", "x+", "y-", "y+", "z-", "z+"];

impl Check<'_> {
    /// `mapped`: the coordinates of the mesh are not yet those of the body.
    pub(super) fn mesh(
        &self,
        keys: Spanned<MeshKeys>,
        mapped: bool,
    ) -> Result<(Spanned<Mesh>, Placement), CaseError> {
        let span = keys.span();
        let keys = keys.into_inner();
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
                .with_help("remove the key `part`")
                .into());
        }
        let mesh = if let Some(brick) = keys.brick {
            self.right_dimension(3, &brick.span())?;
            let brick = brick.into_inner();
            self.block("brick", &brick.min, &brick.max, &brick.nodes)?;
            Mesh::Brick(brick)
        } else if let Some(rectangle) = keys.rectangle {
            self.right_dimension(2, &rectangle.span())?;
            let rectangle = rectangle.into_inner();
            self.block(
                "rectangle",
                &rectangle.min,
                &rectangle.max,
                &rectangle.nodes,
            )?;
            if !mapped && placement.is_identity() {
                self.right_of_axis(&rectangle)?;
            }
            Mesh::Rectangle(rectangle)
        } else if let Some(file) = keys.file {
            Mesh::File(self.file_mesh(file, keys.part, &placement)?)
        } else {
            return Err(self
                .fault(
                    FaultKind::MissingKey,
                    span,
                    "the body has no mesh",
                    "expected `brick`, `rectangle` or `file`",
                )
                .with_help("meshes of Gmsh, Abaqus and CalculiX are given as in `mesh = { file = \"part.msh\" }`")
                .into());
        };
        Ok((Spanned::new(span, mesh), placement))
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
            .with_help("each body has its own [[body]]")
            .into())
    }

    fn right_dimension(&self, dimension: usize, span: &Span) -> Result<(), CaseError> {
        if dimension == self.analysis.dimension() {
            return Ok(());
        }
        let (word, other, help) = match dimension {
            3 => (
                "brick",
                "rectangle",
                "without the key `analysis` a case is about bodies in space",
            ),
            _ => (
                "rectangle",
                "brick",
                "plane cases have the key `analysis` at the top of the file: `plane_strain`, \
                 `plane_stress` or `axisymmetric`",
            ),
        };
        let analysis = self.analysis.word();
        let fault = self
            .fault(
                FaultKind::BadValue,
                span.clone(),
                format!("a {word} does not belong in a case with `analysis = \"{analysis}\"`"),
                format!("expected `{other}`"),
            )
            .with_help(help);
        Err(match &self.analysis_span {
            Some(span) => fault.and_at(span.clone(), "the analysis"),
            None => fault,
        }
        .into())
    }

    fn right_of_axis(&self, rectangle: &Rectangle) -> Result<(), CaseError> {
        let radius = &rectangle.min.get_ref().0[0];
        if self.analysis != Analysis::Axisymmetric || *radius.get_ref() >= 0.0 {
            return Ok(());
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                radius.span(),
                "the body crosses the axis of revolution",
                format!(
                    "expected a radius of 0 or more, found {:?}",
                    radius.get_ref()
                ),
            )
            .with_help("in an axisymmetric case x is the radius and y runs along the axis")
            .into())
    }

    fn file_mesh(
        &self,
        file: Spanned<String>,
        part: Option<Spanned<String>>,
        placement: &Placement,
    ) -> Result<FileMesh, CaseError> {
        let space = match self.analysis {
            Analysis::Solid => Space::Solid,
            Analysis::PlaneStrain | Analysis::PlaneStress => Space::Plane,
            Analysis::Axisymmetric => Space::Axisymmetric,
        };
        let read = self.mesh_file(&file)?;
        let name = part.as_ref().map(|part| part.get_ref().as_str());
        let body = read.body(space, name, placement).map_err(|error| {
            let span = match (&error, &part) {
                (
                    MeshFileError::UnknownGroup { .. } | MeshFileError::GroupDimension { .. },
                    Some(part),
                ) => part.span(),
                _ => file.span(),
            };
            self.bad_mesh(span, &error)
        })?;
        let body = Arc::new(body);
        Ok(FileMesh { file, part, body })
    }

    /// Reads a mesh file, each only once.
    pub(super) fn mesh_file(&self, file: &Spanned<String>) -> Result<Rc<MeshFile>, CaseError> {
        let path = self.beside(file.get_ref());
        if let Some(known) = self.mesh_files.borrow().get(&path) {
            return Ok(Rc::clone(known));
        }
        let read =
            tresca_io::mesh::read(&path).map_err(|error| self.bad_mesh(file.span(), &error))?;
        let read = Rc::new(read);
        self.mesh_files.borrow_mut().insert(path, Rc::clone(&read));
        Ok(read)
    }

    /// A path of the case file; one that does not start at the root counts from its directory.
    pub(super) fn beside(&self, name: &str) -> PathBuf {
        let directory = Path::new(self.source.name()).parent();
        directory.unwrap_or(Path::new("")).join(name)
    }

    /// An error of a mesh file, at the place that names the file or a part of it.
    pub(super) fn bad_mesh(&self, span: Span, error: &MeshFileError) -> CaseError {
        let fault = self.fault(
            FaultKind::BadFile,
            span,
            error.to_string(),
            "this mesh cannot be used",
        );
        match (error, miette::Diagnostic::help(error)) {
            (MeshFileError::Unreadable { .. }, _) => fault.with_help(
                "paths that do not start at the root count from the directory of the case file",
            ),
            (_, Some(help)) => fault.with_help(help.to_string()),
            (_, None) => fault,
        }
        .into()
    }
}
