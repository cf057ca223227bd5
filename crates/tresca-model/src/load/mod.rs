//! Loads. A new kind is a file beside this one, which implements [`ActsAsLoad`], and a line in the list below.

pub(crate) mod kind;
mod region;

use std::ops::Deref;

pub use kind::{ActsAsLoad, Share, Traits};
pub use region::{Region, Target};

use crate::amount::Amount;
use crate::body::Bodies;
use crate::error::ModelError;
use crate::place::PlaceNames;

macro_rules! kinds {
    ($($(#[$doc:meta])* $module:ident::$kind:ident,)*) => {
        $(
            mod $module;
            pub use $module::$kind;

            impl $kind {
                /// As a load on these places.
                pub fn on(self, places: impl Into<PlaceNames>) -> Load<PlaceNames> {
                    Load { name: None, on: places.into(), kind: LoadKind::$kind(self) }
                }
            }

            impl From<$kind> for LoadKind {
                fn from(kind: $kind) -> Self {
                    LoadKind::$kind(kind)
                }
            }
        )*

        /// What acts, apart from where.
        #[derive(Debug, Clone)]
        #[non_exhaustive]
        pub enum LoadKind {
            $($(#[$doc])* $kind($kind),)*
        }

        impl Deref for LoadKind {
            type Target = dyn ActsAsLoad;

            fn deref(&self) -> &Self::Target {
                match self {
                    $(LoadKind::$kind(kind) => kind,)*
                }
            }
        }
    };
}

kinds! {
    /// A force per area.
    traction::Traction,
    /// A force per area against the surface.
    pressure::Pressure,
    /// A force per volume.
    body_force::BodyForce,
    /// Weight.
    gravity::Gravity,
    /// A total force.
    force::Force,
}

/// A load. `W` is how the places are called where it acts: by name as long as it is not part of a model.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Load<W = Region> {
    /// How load steps call it.
    pub name: Option<String>,
    /// Where it acts.
    pub on: W,
    /// What acts.
    pub kind: LoadKind,
}

impl Load<PlaceNames> {
    /// With a name, by which reports call it.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }

    /// Its places found, and its figures checked.
    pub(crate) fn found(self, bodies: &Bodies) -> Result<Load, ModelError> {
        let on = Region::find(self.kind.traits().target, &self.on, bodies)?;
        if let Some(value) = self.kind.constant() {
            bodies.check_vector(&match value {
                Amount::Vector(vector) => vector,
                number => [number.of_scalar(0.0), 0.0, 0.0],
            })?;
        }
        self.kind.check(&on, bodies)?;
        Ok(Load {
            name: self.name,
            on,
            kind: self.kind,
        })
    }
}
