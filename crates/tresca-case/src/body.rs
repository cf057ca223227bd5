//! Bodies: their names, meshes and materials.

use toml::Spanned;
use tresca_fem::assembly::Formulation;

use super::check::{Check, fault_of_name};
use super::error::{CaseError, FaultKind};
use super::fields::VectorField;
use super::keys::{BodyKeys, Material};
use super::mesh::Mesh;
use tresca_io::mesh::Placement;

/// An elastic body.
#[derive(Clone, Debug)]
pub struct Body {
    /// How other keys and the written files call the body.
    pub name: Spanned<String>,
    /// Where the mesh comes from; it has as many dimensions as the analysis.
    pub mesh: Spanned<Mesh>,
    /// Where the points of a brick or rectangle go. The mesh of a file is already there.
    pub placement: Placement,
    /// Where the points of the placed mesh go: new coordinates by old ones. Without a map they stay.
    pub map: Option<VectorField>,
    /// What the body is made of.
    pub material: Spanned<Material>,
    /// How strains are made of displacements. Whether it suits the cells and the material is for the
    /// caller to check; the place is that of the material where the key is not given.
    pub formulation: Spanned<Formulation>,
}

/// Names that the files of every run have, beside those of the bodies.
const RESERVED_NAMES: [&str; 3] = ["contact", "history", "summary"];

impl Check<'_> {
    pub(super) fn bodies(
        &self,
        list: Option<Spanned<Vec<BodyKeys>>>,
    ) -> Result<Vec<Body>, CaseError> {
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
        let mut resolved: Vec<Body> = Vec::with_capacity(bodies.len());
        for keys in bodies {
            self.body_name(&keys.name)?;
            if let Some(other) = resolved.iter().find(|other| same_file_name(other, &keys)) {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        keys.name.span(),
                        format!("two bodies are called `{}`", keys.name.get_ref()),
                        "the second one",
                    )
                    .and_at(other.name.span(), "the first one")
                    .with_help("give each body its own name; upper and lower case count as equal, for the names become names of files")
                    .into());
            }
            let (mesh, placement) = self.mesh(keys.mesh, keys.map.is_some())?;
            self.material(keys.material.get_ref())?;
            let map = keys
                .map
                .map(|map| self.vector_field("the map", &map))
                .transpose()?;
            resolved.push(Body {
                name: keys.name,
                mesh,
                placement,
                map,
                formulation: match keys.formulation {
                    Some(word) => Spanned::new(word.span(), word.into_inner().into()),
                    None => Spanned::new(keys.material.span(), Formulation::default()),
                },
                material: keys.material,
            });
        }
        Ok(resolved)
    }

    fn body_name(&self, name: &Spanned<String>) -> Result<(), CaseError> {
        let reserved = RESERVED_NAMES.contains(&name.get_ref().to_lowercase().as_str());
        let label = match fault_of_name(name.get_ref()) {
            Some(label) => label,
            None if reserved => "this name is taken by another file of the results".to_owned(),
            None => return Ok(()),
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
}

/// Whether two bodies would share the file of their results, on some file system.
fn same_file_name(a: &Body, b: &BodyKeys) -> bool {
    a.name.get_ref().to_lowercase() == b.name.get_ref().to_lowercase()
}
