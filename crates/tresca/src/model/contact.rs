//! Contacts: which surfaces may touch what, and how they rub.

use tresca_contact::{CouplingMethod, Field, FrictionLaw};

use super::{Surface, SurfaceRef};

/// A rigid partner of bodies.
#[derive(Debug, Clone)]
pub struct Obstacle {
    /// Name, unique among bodies and obstacles.
    pub name: String,
    /// Where its surface is.
    pub shape: tresca_contact::Obstacle,
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
    pub gap: Field,
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
    pub gap: Field,
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
            gap: Field::Constant(0.0),
            coupling: CouplingMethod::Auto,
            search: None,
        }
    }
}
