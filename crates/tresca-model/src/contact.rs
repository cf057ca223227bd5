//! Contacts: which surfaces may touch what, and how they rub.

use tresca_contact::{CouplingMethod, FrictionLaw, ScalarField};

use crate::amount::{Amount, Shape};
use crate::identity::ObstacleId;
use crate::place::{Place, PlaceName, PlaceNames};

/// Who faces a slave surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Partner {
    /// A surface of another body.
    Surface(Place),
    /// An obstacle.
    Obstacle(ObstacleId),
}

impl Partner {
    /// The surface of a body, if it is one.
    pub fn surface(&self) -> Option<&Place> {
        match self {
            Partner::Surface(surface) => Some(surface),
            Partner::Obstacle(_) => None,
        }
    }
}

/// A slave surface and its partner, and how they rub. `S` and `M` are how the two are called: by name as long as the
/// contact is not part of a model.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Contact<S = Place, M = Partner> {
    /// How load steps call it.
    pub name: Option<String>,
    /// The slave surface; contact normals point out of it.
    pub slave: S,
    /// The master surface or the obstacle.
    pub master: M,
    /// The friction law.
    pub friction: FrictionLaw,
    /// Added to the gap between the surfaces (a length); negative for an interference.
    pub gap: ScalarField,
    /// How the two surfaces are coupled.
    pub coupling: CouplingMethod,
    /// Largest distance (a length) at which they are coupled; `None`: by the size of their faces.
    pub search: Option<f64>,
}

impl Contact<PlaceName, PlaceName> {
    /// A surface and its partner, a surface of another body or an obstacle, with the gap that they have, coupled as
    /// suits them.
    pub fn new(
        slave: impl Into<PlaceName>,
        master: impl Into<PlaceName>,
        friction: FrictionLaw,
    ) -> Self {
        Self {
            name: None,
            slave: slave.into(),
            master: master.into(),
            friction,
            gap: ScalarField::Constant(0.0),
            coupling: CouplingMethod::Auto,
            search: None,
        }
    }
}

impl<S, M> Contact<S, M> {
    /// With a name, by which reports call it.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }

    /// With a length that is added to the gap; negative for an interference.
    #[must_use]
    pub fn gap(mut self, gap: impl Into<ScalarField>) -> Self {
        self.gap = gap.into();
        self
    }

    /// Coupled in another way than suits the surfaces.
    #[must_use]
    pub fn coupling(mut self, coupling: CouplingMethod) -> Self {
        self.coupling = coupling;
        self
    }

    /// Coupled up to another distance (a length, positive) than by the size of faces.
    #[must_use]
    pub fn search(mut self, distance: f64) -> Self {
        self.search = Some(distance);
        self
    }

    /// The same with other sides.
    pub(crate) fn between<T, N>(self, slave: T, master: N) -> Contact<T, N> {
        Contact {
            name: self.name,
            slave,
            master,
            friction: self.friction,
            gap: self.gap,
            coupling: self.coupling,
            search: self.search,
        }
    }

    /// The slip bound that load steps can replace: `None` where the law has none, or several. Inside: its value where
    /// that is the same everywhere.
    fn single_bound(&self) -> Option<Option<f64>> {
        match &self.friction {
            FrictionLaw::Tresca { bound } | FrictionLaw::Bilateral { bound: Some(bound) } => {
                Some(match bound {
                    ScalarField::Constant(value) => Some(*value),
                    _ => None,
                })
            }
            _ => None,
        }
    }

    /// Whether load steps can scale its slip bounds.
    pub fn has_bounds(&self) -> bool {
        self.shape().is_some() || matches!(self.friction, FrictionLaw::Orthotropic { .. })
    }

    /// What load steps can put in the place of its slip bound.
    pub fn shape(&self) -> Option<Shape> {
        self.single_bound().map(|_| Shape::Scalar)
    }

    /// The slip bound where it is single, and the same everywhere.
    pub fn constant(&self) -> Option<Amount> {
        self.single_bound().flatten().map(Amount::Scalar)
    }
}

/// The outer surfaces of bodies where they face one another within a distance.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Nearby {
    /// Largest distance (a length).
    pub distance: f64,
    /// The bodies; all without names.
    pub bodies: PlaceNames,
}

/// A contact of whatever is near: one contact for each two bodies that come so close.
pub type ContactWithin = Contact<Nearby, ()>;

impl ContactWithin {
    /// Of all bodies that come as near as a distance (a length).
    pub fn within(distance: f64, friction: FrictionLaw) -> Self {
        let nothing = PlaceName::from("");
        let bodies = PlaceNames::default();
        Contact::new(nothing.clone(), nothing, friction).between(Nearby { distance, bodies }, ())
    }

    /// Of these bodies alone.
    #[must_use]
    pub fn bodies(mut self, bodies: impl Into<PlaceNames>) -> Self {
        self.slave.bodies = bodies.into();
        self
    }
}
