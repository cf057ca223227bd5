//! The mechanical model: bodies, supports, loads and contacts, by name.

use tresca_contact::FrictionLaw;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{Face, Mesh};

use crate::ModelError;

/// A body: a mesh and what it is made of.
#[derive(Debug, Clone)]
pub struct Body {
    /// Name, unique in the model.
    pub name: String,
    /// Mesh with named sets of boundary faces.
    pub mesh: Mesh,
    /// Linear elastic, isotropic.
    pub material: Isotropic,
}

/// A named set of faces of a body, written `body.faces` in case files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SurfaceRef<'a> {
    /// Name of the body.
    pub body: &'a str,
    /// Name of the face set in the body's mesh.
    pub faces: &'a str,
}

/// A surface of the model, resolved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Surface {
    /// Index of the body in [`Model::bodies`].
    pub body: usize,
    /// Name of the face set.
    pub faces: String,
}

/// A surface traction, constant over its surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Traction {
    /// Where it acts.
    pub on: Vec<Surface>,
    /// Force per area, global components.
    pub value: [f64; 3],
}

/// Two surfaces that may touch, and how they rub.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// The slave surface; contact normals point out of it.
    pub slave: Surface,
    /// The master surface.
    pub master: Surface,
    /// The friction law.
    pub friction: FrictionLaw,
}

/// Bodies with supports, loads and contacts, every name resolved.
///
/// Built step by step; each step checks what it is given. Units are the user's: any
/// consistent system (mm, N, MPa or m, MN, MPa, …).
#[derive(Debug, Clone, Default)]
pub struct Model {
    title: String,
    bodies: Vec<Body>,
    clamps: Vec<Surface>,
    tractions: Vec<Traction>,
    contacts: Vec<Contact>,
}

impl Model {
    /// An empty model.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            ..Self::default()
        }
    }

    /// Adds a body.
    ///
    /// # Errors
    /// [`ModelError::DuplicateBody`] when the name is taken.
    pub fn add_body(
        &mut self,
        name: impl Into<String>,
        mesh: Mesh,
        material: Isotropic,
    ) -> Result<&mut Self, ModelError> {
        let name = name.into();
        if self.bodies.iter().any(|body| body.name == name) {
            return Err(ModelError::DuplicateBody { name });
        }
        self.bodies.push(Body {
            name,
            mesh,
            material,
        });
        Ok(self)
    }

    /// Clamps a surface: all displacement components of its nodes are zero.
    ///
    /// # Errors
    /// When the body or the face set does not exist.
    pub fn clamp(&mut self, on: SurfaceRef<'_>) -> Result<&mut Self, ModelError> {
        let surface = self.resolve(on)?;
        self.clamps.push(surface);
        Ok(self)
    }

    /// Puts a constant traction (force per area, global components) on surfaces.
    ///
    /// # Errors
    /// When a body or a face set does not exist, or a component is not finite.
    pub fn add_traction(
        &mut self,
        on: &[SurfaceRef<'_>],
        value: [f64; 3],
    ) -> Result<&mut Self, ModelError> {
        if !value.iter().all(|component| component.is_finite()) {
            return Err(ModelError::NonFiniteTraction { value });
        }
        let on = on
            .iter()
            .map(|&surface| self.resolve(surface))
            .collect::<Result<_, _>>()?;
        self.tractions.push(Traction { on, value });
        Ok(self)
    }

    /// Lets two surfaces of different bodies touch.
    ///
    /// # Errors
    /// When a surface does not exist, both lie on one body, or the slip bound is not a number ≥ 0.
    pub fn add_contact(
        &mut self,
        slave: SurfaceRef<'_>,
        master: SurfaceRef<'_>,
        friction: FrictionLaw,
    ) -> Result<&mut Self, ModelError> {
        friction.slip_bound(1.0)?;
        let (slave, master) = (self.resolve(slave)?, self.resolve(master)?);
        if slave.body == master.body {
            return Err(ModelError::SelfContact {
                body: self.bodies[slave.body].name.clone(),
            });
        }
        self.contacts.push(Contact {
            slave,
            master,
            friction,
        });
        Ok(self)
    }

    fn resolve(&self, surface: SurfaceRef<'_>) -> Result<Surface, ModelError> {
        let body = self
            .bodies
            .iter()
            .position(|body| body.name == surface.body)
            .ok_or_else(|| ModelError::UnknownBody {
                name: surface.body.to_owned(),
                known: self.bodies.iter().map(|body| body.name.clone()).collect(),
            })?;
        let sets = &self.bodies[body].mesh.face_sets;
        if !sets.contains_key(surface.faces) {
            return Err(ModelError::UnknownSurface {
                body: surface.body.to_owned(),
                faces: surface.faces.to_owned(),
                known: sets.keys().cloned().collect(),
            });
        }
        Ok(Surface {
            body,
            faces: surface.faces.to_owned(),
        })
    }

    /// The title.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The bodies, in the order in which they were added.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The clamped surfaces.
    pub fn clamps(&self) -> &[Surface] {
        &self.clamps
    }

    /// The tractions.
    pub fn tractions(&self) -> &[Traction] {
        &self.tractions
    }

    /// The contacts.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The faces of a surface.
    pub fn faces(&self, surface: &Surface) -> &[Face] {
        &self.bodies[surface.body].mesh.face_sets[&surface.faces]
    }

    /// The surface as `body.faces`.
    pub fn surface_name(&self, surface: &Surface) -> String {
        format!("{}.{}", self.bodies[surface.body].name, surface.faces)
    }
}
