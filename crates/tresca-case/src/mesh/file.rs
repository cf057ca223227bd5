//! Meshes out of files, for bodies and for rigid surfaces.

use std::rc::Rc;

use tresca_io::located::Span;
use tresca_io::mesh::{MeshFault, MeshFile, MeshFileError, Placement};

use super::NamedMesh;
use crate::error::{CaseError, FaultKind};
use crate::reader::Reader;
use crate::text::at::At;

impl Reader<'_> {
    /// The mesh of a body.
    pub(super) fn file_mesh(
        &mut self,
        file: &At<String>,
        part: Option<&At<String>>,
        placement: &Placement,
    ) -> Result<NamedMesh, CaseError> {
        let read = self.mesh_file(file)?;
        let name = part.map(|part| part.as_str());
        let body = read.body(self.analysis.space(), name, placement);
        let body = body.map_err(|error| self.bad_part(file, part, &error))?;
        Ok(NamedMesh {
            mesh: body.mesh,
            word: format!("the mesh of `{}`", file.value),
            unusable: body.unusable,
            notes: body.notes,
        })
    }

    /// Reads a mesh file, each only once.
    pub(crate) fn mesh_file(&mut self, file: &At<String>) -> Result<Rc<MeshFile>, CaseError> {
        let path = self.beside(file);
        if let Some(known) = self.mesh_files.get(&path) {
            return Ok(Rc::clone(known));
        }
        let read =
            tresca_io::mesh::read(&path).map_err(|error| self.bad_mesh(file.span(), &error))?;
        let read = Rc::new(read);
        self.mesh_files.insert(path, Rc::clone(&read));
        Ok(read)
    }

    /// An error of a mesh file, at the key of the part where that is at fault.
    pub(crate) fn bad_part(
        &self,
        file: &At<String>,
        part: Option<&At<String>>,
        error: &MeshFileError,
    ) -> CaseError {
        let span = match (error.fault(), part) {
            (MeshFault::UnknownGroup { .. } | MeshFault::GroupDimension { .. }, Some(part)) => {
                part.span()
            }
            _ => file.span(),
        };
        self.bad_mesh(span, error)
    }

    /// An error of a mesh file, at the place that names the file or a part of it.
    pub(crate) fn bad_mesh(&self, span: Span, error: &MeshFileError) -> CaseError {
        let fault = self.fault(
            FaultKind::BadFile,
            span,
            error.to_string(),
            "this mesh cannot be used",
        );
        match (error.fault(), miette::Diagnostic::help(error)) {
            (MeshFault::Unreadable { .. }, _) => fault.with_help(
                "paths that do not start at the root count from the directory of the case file",
            ),
            (_, Some(help)) => fault.with_help(help.to_string()),
            (_, None) => fault,
        }
    }
}
