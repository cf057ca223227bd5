//! Contacts: which surfaces may touch what, and how they rub.

use tresca_contact::{CouplingMethod, FrictionLaw, ScalarField, facing_surfaces};

use super::{Model, Surface, SurfaceRef};
use crate::ModelError;

/// A rigid partner of bodies.
#[derive(Debug, Clone)]
pub struct Obstacle {
    /// Name, unique among bodies and obstacles.
    pub name: String,
    /// Where its surface is.
    pub shape: tresca_contact::RigidShape,
    /// Its displacement (a length); load steps scale or replace it. Small, as all displacements are:
    /// the surface is looked at where it was.
    pub motion: [f64; 3],
}

/// Who faces a slave surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Partner {
    /// A surface of another body.
    Surface(Surface),
    /// An obstacle, by its index in [`Model::obstacles`](super::Model::obstacles).
    Obstacle(usize),
}

impl Partner {
    /// The surface of a body, if it is one.
    pub fn surface(&self) -> Option<&Surface> {
        match self {
            Partner::Surface(surface) => Some(surface),
            Partner::Obstacle(_) => None,
        }
    }
}

/// A slave surface and its partner, and how they rub.
#[derive(Debug, Clone)]
pub struct Contact {
    /// How load steps call it.
    pub name: Option<String>,
    /// The slave surface; contact normals point out of it.
    pub slave: Surface,
    /// The master surface or the obstacle.
    pub master: Partner,
    /// The friction law.
    pub friction: FrictionLaw,
    /// Added to the gap between the surfaces (a length); negative for an interference.
    pub gap: ScalarField,
    /// How the two surfaces are coupled.
    pub coupling: CouplingMethod,
    /// Largest distance (a length) at which they are coupled; `None`: by the size of their faces.
    pub search: Option<f64>,
}

/// Who faces a slave surface, by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartnerRef<'a> {
    /// A surface of another body.
    Surface(SurfaceRef<'a>),
    /// An obstacle.
    Obstacle(&'a str),
}

impl<'a> From<SurfaceRef<'a>> for PartnerRef<'a> {
    fn from(surface: SurfaceRef<'a>) -> Self {
        PartnerRef::Surface(surface)
    }
}

/// A contact as it is added to a model: [`Contact`] with names for indices.
#[derive(Debug, Clone)]
pub struct ContactSpec<'a> {
    /// How load steps call it.
    pub name: Option<&'a str>,
    /// The slave surface.
    pub slave: SurfaceRef<'a>,
    /// Its partner.
    pub master: PartnerRef<'a>,
    /// The friction law.
    pub friction: FrictionLaw,
    /// Added to the gap between the surfaces.
    pub gap: ScalarField,
    /// How the two surfaces are coupled.
    pub coupling: CouplingMethod,
    /// Largest distance at which they are coupled.
    pub search: Option<f64>,
}

impl<'a> ContactSpec<'a> {
    /// Without a name, with the gap that the surfaces have, coupled as suits them.
    pub fn new(
        slave: SurfaceRef<'a>,
        master: impl Into<PartnerRef<'a>>,
        friction: FrictionLaw,
    ) -> Self {
        Self {
            name: None,
            slave,
            master: master.into(),
            friction,
            gap: ScalarField::Constant(0.0),
            coupling: CouplingMethod::Auto,
            search: None,
        }
    }
}

impl Model {
    /// Adds a rigid obstacle that bodies may touch.
    ///
    /// # Errors
    /// When the name is taken, or its motion is not finite or leaves the plane.
    pub fn add_obstacle(
        &mut self,
        name: impl Into<String>,
        shape: tresca_contact::RigidShape,
        motion: [f64; 3],
    ) -> Result<&mut Self, ModelError> {
        let name = name.into();
        self.check_new_name(&name)?;
        self.check_components(&motion)?;
        self.obstacles.push(Obstacle {
            name,
            shape,
            motion,
        });
        Ok(self)
    }

    /// Lets a surface touch that of another body, or an obstacle.
    ///
    /// # Errors
    /// As [`Model::add_contact_as`].
    pub fn add_contact<'a>(
        &mut self,
        slave: SurfaceRef<'a>,
        master: impl Into<PartnerRef<'a>>,
        friction: FrictionLaw,
    ) -> Result<&mut Self, ModelError> {
        self.add_contact_as(ContactSpec::new(slave, master, friction))
    }

    /// The same with everything that may be said of a contact.
    ///
    /// # Errors
    /// When a surface or the obstacle does not exist, both sides lie on one body, or the law has
    /// impossible figures.
    pub fn add_contact_as(&mut self, spec: ContactSpec<'_>) -> Result<&mut Self, ModelError> {
        spec.friction.validate()?;
        if self.dimension() == 2 && matches!(spec.friction, FrictionLaw::Orthotropic { .. }) {
            return Err(ModelError::OrthotropicInThePlane);
        }
        let slave = self.resolve(spec.slave)?;
        let master = match spec.master {
            PartnerRef::Surface(surface) => Partner::Surface(self.resolve(surface)?),
            PartnerRef::Obstacle(name) => Partner::Obstacle(self.obstacle(name)?),
        };
        if master
            .surface()
            .is_some_and(|master| master.body == slave.body)
        {
            return Err(ModelError::SelfContact {
                body: self.bodies[slave.body].name.clone(),
            });
        }
        self.contacts.push(Contact {
            name: spec.name.map(str::to_owned),
            slave,
            master,
            friction: spec.friction,
            gap: spec.gap,
            coupling: spec.coupling,
            search: spec.search,
        });
        Ok(self)
    }

    /// Lets the exterior surfaces of bodies touch where they face one another within a distance (a length):
    /// one contact for each two of the named bodies (of all without names) that come so close. The
    /// faces become face sets of the two bodies, each named `near` and the other body's name with a colon
    /// between; the body added first is the slave. Returns the number of contacts.
    ///
    /// # Errors
    /// When a body does not exist, no two bodies come so close, or as [`Model::add_contact_as`].
    pub fn add_contacts_within(
        &mut self,
        distance: f64,
        bodies: &[&str],
        name: Option<&str>,
        friction: &FrictionLaw,
        gap: &ScalarField,
        coupling: CouplingMethod,
    ) -> Result<usize, ModelError> {
        let chosen: Vec<usize> = if bodies.is_empty() {
            (0..self.bodies.len()).collect()
        } else {
            let mut chosen = bodies
                .iter()
                .map(|name| self.body(name))
                .collect::<Result<Vec<_>, _>>()?;
            chosen.sort_unstable();
            chosen.dedup();
            chosen
        };
        let mut found = Vec::new();
        for (k, &slave) in chosen.iter().enumerate() {
            for &master in &chosen[k + 1..] {
                let meshes = [slave, master].map(|body| &self.bodies[body].mesh);
                let faces = facing_surfaces(meshes[0], meshes[1], distance)?;
                if !faces.0.is_empty() {
                    found.push(([slave, master], faces));
                }
            }
        }
        if found.is_empty() {
            return Err(ModelError::NothingWithin { distance });
        }
        let count = found.len();
        for ([slave, master], (slave_faces, master_faces)) in found {
            let set_name = |other: usize| format!("near:{}", self.bodies[other].name);
            let names = [set_name(master), set_name(slave)];
            for (body, (name, faces)) in [slave, master]
                .into_iter()
                .zip(names.iter().zip([slave_faces, master_faces]))
            {
                self.bodies[body].mesh.face_sets.insert(name.clone(), faces);
            }
            let body_names = [slave, master].map(|body| self.bodies[body].name.clone());
            let [slave, master] = std::array::from_fn(|side| SurfaceRef {
                body: &body_names[side],
                faces: &names[side],
            });
            self.add_contact_as(ContactSpec {
                name,
                gap: gap.clone(),
                coupling,
                search: Some(distance),
                ..ContactSpec::new(slave, master, friction.clone())
            })?;
        }
        Ok(count)
    }
}
