//! Bodies: their names, meshes and materials.

use serde::Deserialize;
use tresca_fem::FemError;
use tresca_fem::assembly::Formulation;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::Mesh;
use tresca_model::{Body, Subject};

use crate::analysis::Analysis;
use crate::error::{CaseError, FaultKind, semantic};
use crate::field::FieldKeys;
use crate::mesh::MeshKeys;
use crate::origins::BodyOrigin;
use crate::reader::{Reader, fault_of_name};
use crate::text::at::At;

/// `[[body]]`: an elastic body.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[body]]")]
pub(crate) struct BodyKeys {
    /// How other keys and the written files call the body: letters, digits, `_` and `-`.
    pub name: At<String>,
    /// Where the mesh comes from.
    pub mesh: At<MeshKeys>,
    /// Where the points of that mesh go.
    pub map: Option<At<Vec<At<FieldKeys>>>>,
    /// What the body is made of.
    pub material: At<MaterialKeys>,
    /// How its stiffness is integrated. Default: `full`.
    pub formulation: Option<At<FormulationWord>>,
}

/// `formulation`: how strains are made of displacements.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case", expecting = "the name of a formulation")]
pub(crate) enum FormulationWord {
    /// The strain as it is.
    Full,
    /// The volumetric strain as its mean over the cell.
    BBar,
}

impl From<FormulationWord> for Formulation {
    fn from(word: FormulationWord) -> Self {
        match word {
            FormulationWord::Full => Formulation::Full,
            FormulationWord::BBar => Formulation::BBar,
        }
    }
}

/// `material`: isotropic linear elasticity.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ young = …, poisson = … }`"
)]
pub(crate) struct MaterialKeys {
    /// Young's modulus (force per area), positive.
    pub young: At<f64>,
    /// Poisson's ratio, above -1 and below 0.5.
    pub poisson: At<f64>,
    /// Mass per volume, 0 or more; needed where gravity acts.
    pub density: Option<At<f64>>,
}

/// Names that the files of every run have, beside those of the bodies.
const RESERVED_NAMES: [&str; 3] = ["contact", "history", "summary"];

/// Names of the faces of a brick as documentation lists them; the first four are those of a rectangle.
const BLOCK_FACES: [&str; 6] = ["x-", "x+", "y-", "y+", "z-", "z+"];

impl Reader<'_> {
    pub(crate) fn bodies(&mut self, list: Option<At<Vec<BodyKeys>>>) -> Result<(), CaseError> {
        let (span, bodies) = match list {
            Some(list) => (list.span(), list.value),
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
                .with_help(
                    "a body is a table [[body]] with the keys `name`, `mesh` and `material`",
                ));
        }
        bodies.into_iter().try_for_each(|keys| self.body(keys))
    }

    fn body(&mut self, keys: BodyKeys) -> Result<(), CaseError> {
        self.body_name(&keys.name)?;
        // The names become names of files, on some systems regardless of case.
        let name = keys.name.to_lowercase();
        let mut others = self.origins.bodies.iter().map(|other| &other.name);
        if let Some(other) = others.find(|other| other.to_lowercase() == name) {
            return Err(self
                .fault(
                    FaultKind::Duplicate,
                    keys.name.span(),
                    format!("two bodies are called `{}`", keys.name.value),
                    "the second one",
                )
                .and_at(other.span(), "the first one")
                .with_help("give each body its own name; upper and lower case count as equal, for the names become names of files")
                );
        }
        let made = self.mesh(keys.mesh, keys.map.is_some())?;
        let material = self.material(&keys.material)?;
        let (faces, node_sets) = set_names(&made.mesh);
        let mesh = match keys.map {
            Some(map) => self.mapped(made.mesh, &map)?,
            None => made.mesh,
        };
        let mut body = Body::new(keys.name.as_str(), mesh, material);
        if let Some(density) = &keys.material.density {
            body = body.density(density.value);
        }
        if let Some(word) = keys.formulation {
            body = body.formulation(word.value.into());
        }
        let added = self.model.add_body(body);
        let index = added.map_err(|error| {
            let (span, fact) = (keys.name.span(), error.to_string());
            semantic(self.source, span, fact, "this body", "")
        })?;
        self.origins
            .places
            .insert(Subject::Body(index), keys.name.span());
        let notes = made.notes.iter();
        self.origins.bodies.push(BodyOrigin {
            notes: notes
                .map(|note| format!("body `{}`: {note}", keys.name.value))
                .collect(),
            name: keys.name,
            material: keys.material.span(),
            mesh: made.word,
            faces,
            node_sets,
            unusable: made.unusable,
        });
        Ok(())
    }

    /// The mesh with its nodes where a map takes them.
    fn mapped(&self, mesh: Mesh, map: &At<Vec<At<FieldKeys>>>) -> Result<Mesh, CaseError> {
        let field = self.vector_field("the map", map)?;
        let refuse = |error: FemError| {
            let help = "the map must give finite coordinates, keep a radius at 0 or more, and turn no \
                        cell inside out";
            let fact = error.to_string();
            semantic(self.source, map.span(), fact, "this map", help)
        };
        let mesh = mesh.mapped(|point| field.at(point));
        let mesh = mesh.and_then(|mesh| self.in_its_space(mesh));
        let mesh = mesh.map_err(refuse)?;
        mesh.check_cells().map_err(refuse)?;
        Ok(mesh)
    }

    fn body_name(&self, name: &At<String>) -> Result<(), CaseError> {
        let reserved = RESERVED_NAMES.contains(&name.value.to_lowercase().as_str());
        let label = match fault_of_name(name) {
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
            ))
    }

    fn material(&self, keys: &At<MaterialKeys>) -> Result<Isotropic, CaseError> {
        let young = self.finite("Young's modulus", &keys.young)?;
        if young <= 0.0 {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    keys.young.span(),
                    "Young's modulus must be positive",
                    format!("expected more than 0, found {young:?}"),
                )
                .with_help("it is the stiffness of the material, a force per area"));
        }
        if let Some(density) = &keys.density {
            self.not_negative("the density", density, "it is the mass per volume")?;
        }
        let poisson = self.finite("Poisson's ratio", &keys.poisson)?;
        if poisson > -1.0 && poisson < 0.5 {
            let material = Isotropic::new(young, poisson).map_err(|error| {
                let help = "a material needs `young` > 0 and −1 < `poisson` < 0.5";
                let fact = error.to_string();
                semantic(self.source, keys.span(), fact, "this material", help)
            })?;
            return Ok(match self.analysis {
                Analysis::PlaneStress => material.plane_stress(),
                Analysis::Solid | Analysis::PlaneStrain | Analysis::Axisymmetric => material,
            });
        }
        let help = if poisson == 0.5 {
            "0.5 is an incompressible material, which needs another formulation; rubber is often \
             taken as 0.49"
        } else if poisson > 1.0 {
            "is this Young's modulus? most metals have 0.25 to 0.35"
        } else {
            "no stable isotropic material has it; most metals have 0.25 to 0.35"
        };
        Err(self
            .fault(
                FaultKind::BadValue,
                keys.poisson.span(),
                "Poisson's ratio must lie between -1 and 0.5",
                format!("expected -1 < poisson < 0.5, found {poisson:?}"),
            )
            .with_help(help))
    }
}

/// Names of the faces of a mesh, and of its sets of nodes, those of the faces among them.
fn set_names(mesh: &Mesh) -> (Vec<String>, Vec<String>) {
    let rank = |name: &str| BLOCK_FACES.iter().position(|face| *face == name);
    let mut faces: Vec<String> = mesh.face_sets.keys().cloned().collect();
    faces.sort_by_key(|name| rank(name));
    // Of a block, whose faces have no node sets beside them.
    let node_sets = match mesh.node_sets.is_empty() {
        true => faces.clone(),
        false => mesh.node_sets.keys().cloned().collect(),
    };
    (faces, node_sets)
}
