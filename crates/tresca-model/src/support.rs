//! Supports.

use crate::amount::Amount;
use crate::place::{Place, PlaceName, PlaceNames};

/// Prescribed displacements of surfaces or sets of nodes, component by component. `P` is how places are called: by
/// name as long as the support is not part of a model.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Support<P = Place> {
    /// How load steps call it.
    pub name: Option<String>,
    /// Where.
    pub on: Vec<P>,
    /// The displacement (a length) along x, y, z; `None` where it is free. In the plane the last is `None`.
    pub components: [Option<f64>; 3],
}

impl Support<PlaceName> {
    /// Prescribes displacement components: 0 for a symmetry plane or a roller.
    pub fn new(on: impl Into<PlaceNames>, components: [Option<f64>; 3]) -> Self {
        Self {
            name: None,
            on: on.into().0,
            components,
        }
    }

    /// Holds all components. In the plane that along z does not count.
    pub fn clamp(on: impl Into<PlaceNames>) -> Self {
        Self::new(on, [Some(0.0); 3])
    }

    /// Prescribes the first component.
    pub fn x(on: impl Into<PlaceNames>, displacement: f64) -> Self {
        Self::new(on, [Some(displacement), None, None])
    }

    /// Prescribes the second component.
    pub fn y(on: impl Into<PlaceNames>, displacement: f64) -> Self {
        Self::new(on, [None, Some(displacement), None])
    }

    /// Prescribes the third component.
    pub fn z(on: impl Into<PlaceNames>, displacement: f64) -> Self {
        Self::new(on, [None, None, Some(displacement)])
    }

    /// With a name, by which reports call it.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }
}

impl Support {
    /// The prescribed displacements as a vector, 0 where they are free.
    pub fn vector(&self) -> [f64; 3] {
        self.components.map(|value| value.unwrap_or(0.0))
    }

    /// What it prescribes in a step.
    pub fn components_by(&self, amount: Amount) -> [Option<f64>; 3] {
        let values = amount.of_vector(self.vector());
        std::array::from_fn(|k| self.components[k].map(|_| values[k]))
    }
}
