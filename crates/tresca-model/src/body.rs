//! Bodies, and how their names and those of their places are found.

use std::ops::Deref;

use tresca_fem::assembly::Formulation;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{Face, Mesh, Space};

use crate::error::ModelError;
use crate::place::{Place, PlaceName};

/// A body: a mesh and what it is made of.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Body {
    /// Name, unique among bodies and obstacles.
    pub name: String,
    /// Mesh with named sets of boundary faces and of nodes.
    pub mesh: Mesh,
    /// Linear elastic, isotropic.
    pub material: Isotropic,
    /// How strains are integrated: in full, or with a remedy against locking.
    pub formulation: Formulation,
    /// Mass per volume (≥ 0), for gravity.
    pub density: Option<f64>,
}

impl Body {
    /// A body without density, its strains integrated in full.
    pub fn new(name: impl Into<String>, mesh: Mesh, material: Isotropic) -> Self {
        Self {
            name: name.into(),
            mesh,
            material,
            formulation: Formulation::default(),
            density: None,
        }
    }

    /// With a mass per volume (≥ 0).
    #[must_use]
    pub fn density(mut self, density: f64) -> Self {
        self.density = Some(density);
        self
    }

    /// With another integration of strains; one that the elements do not have is found at assembly.
    #[must_use]
    pub fn formulation(mut self, formulation: Formulation) -> Self {
        self.formulation = formulation;
        self
    }
}

/// The bodies of a model, in the order in which they were added.
#[derive(Debug, Clone, Default)]
pub struct Bodies(pub(crate) Vec<Body>);

impl Deref for Bodies {
    type Target = [Body];

    fn deref(&self) -> &[Body] {
        &self.0
    }
}

impl<'a> IntoIterator for &'a Bodies {
    type Item = &'a Body;
    type IntoIter = std::slice::Iter<'a, Body>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

impl Bodies {
    /// The space that the bodies live in; [`Space::Solid`] as long as there is none.
    pub fn space(&self) -> Space {
        self.first().map_or(Space::Solid, |body| body.mesh.space)
    }

    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        self.space().dimension()
    }

    /// The index of a body.
    ///
    /// # Errors
    /// When it does not exist.
    pub fn index(&self, name: &str) -> Result<usize, ModelError> {
        let index = self.iter().position(|body| body.name == name);
        index.ok_or_else(|| ModelError::UnknownBody {
            name: name.to_owned(),
            known: self.iter().map(|body| body.name.clone()).collect(),
        })
    }

    /// The set of faces of that name.
    ///
    /// # Errors
    /// When the body or the set does not exist.
    pub fn surface(&self, name: &PlaceName) -> Result<Place, ModelError> {
        self.find(name, |mesh| mesh.face_sets.keys().collect())
    }

    /// The set of faces or nodes of that name.
    ///
    /// # Errors
    /// When the body or the set does not exist.
    pub fn place(&self, name: &PlaceName) -> Result<Place, ModelError> {
        self.find(name, |mesh| {
            mesh.face_sets.keys().chain(mesh.node_sets.keys()).collect()
        })
    }

    fn find(
        &self,
        name: &PlaceName,
        known: impl Fn(&Mesh) -> Vec<&String>,
    ) -> Result<Place, ModelError> {
        let body = self.index(&name.owner)?;
        let set = name.set.as_deref().unwrap_or_default();
        let known = known(&self[body].mesh);
        if !known.iter().any(|known| *known == set) {
            return Err(ModelError::UnknownSurface {
                body: name.owner.clone(),
                surface: set.to_owned(),
                known: known.into_iter().cloned().collect(),
            });
        }
        let set = set.to_owned();
        Ok(Place { body, set })
    }

    /// The faces of a surface.
    pub fn faces(&self, surface: &Place) -> &[Face] {
        &self[surface.body].mesh.face_sets[&surface.set]
    }

    /// The nodes of a set of faces or nodes, ascending.
    pub fn nodes(&self, place: &Place) -> Vec<usize> {
        let mesh = &self[place.body].mesh;
        match mesh.face_sets.get(&place.set) {
            Some(faces) => mesh.nodes_of_faces(faces),
            None => mesh.node_sets[&place.set].clone(),
        }
    }

    /// Refuses a vector that is not finite or leaves the plane.
    pub(crate) fn check_vector(&self, value: &[f64; 3]) -> Result<(), ModelError> {
        if !value.iter().all(|component| component.is_finite()) {
            return Err(ModelError::NonFiniteValue { value: *value });
        }
        if self.dimension() == 2 && value[2] != 0.0 {
            return Err(ModelError::OutOfPlane);
        }
        Ok(())
    }
}
