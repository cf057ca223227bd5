//! Supports and loads, and how they vary from load step to load step.

use std::fmt;
use std::sync::Arc;

use tresca_contact::ScalarField;

use super::Surface;

/// Prescribed displacements of surfaces or sets of nodes, component by component.
#[derive(Debug, Clone, PartialEq)]
pub struct Support {
    /// How load steps call it.
    pub name: Option<String>,
    /// Where.
    pub on: Vec<Surface>,
    /// The displacement (a length) of each component, `None` where it is free. In the plane the third
    /// entry is `None`.
    pub components: [Option<f64>; 3],
}

/// A vector that may vary in space.
#[derive(Clone)]
pub enum VectorField {
    /// The same everywhere.
    Constant([f64; 3]),
    /// A function of the undeformed position.
    Function(Arc<dyn Fn([f64; 3]) -> [f64; 3] + Send + Sync>),
}

impl fmt::Debug for VectorField {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VectorField::Constant(value) => write!(f, "Constant({value:?})"),
            VectorField::Function(_) => f.write_str("Function"),
        }
    }
}

/// A load.
#[derive(Debug, Clone)]
pub struct Load {
    /// How load steps call it.
    pub name: Option<String>,
    /// What acts where.
    pub kind: LoadKind,
}

/// What acts where.
#[derive(Debug, Clone)]
pub enum LoadKind {
    /// A force per area of the undeformed surface, global components.
    Traction {
        /// Where it acts.
        on: Vec<Surface>,
        /// The traction.
        value: VectorField,
    },
    /// A force per area against the surface; positive presses on the body.
    Pressure {
        /// Where it acts.
        on: Vec<Surface>,
        /// The pressure, a constant or a function.
        value: ScalarField,
    },
    /// A force per volume, global components.
    BodyForce {
        /// Indices of the bodies.
        bodies: Vec<usize>,
        /// The force per volume.
        value: [f64; 3],
    },
    /// Weight: density × acceleration.
    Gravity {
        /// Indices of the bodies, each with a density.
        bodies: Vec<usize>,
        /// The acceleration, global components.
        value: [f64; 3],
    },
}

/// What a load step makes of a figure of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount<T> {
    /// The model's own figure times this.
    Factor(f64),
    /// This instead of the model's figure.
    Value(T),
}

/// A state of supports, loads and slip bounds. Friction acts on the slip from one step to the next.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Instant in the time series; has no influence on the answer.
    pub time: f64,
    /// How reports call it.
    pub name: Option<String>,
    /// One per support of the model.
    pub supports: Vec<Amount<[Option<f64>; 3]>>,
    /// One per load; a pressure's new value stands in the first entry.
    pub loads: Vec<Amount<[f64; 3]>>,
    /// One per obstacle: its motion.
    pub obstacles: Vec<Amount<[f64; 3]>>,
    /// One per contact; for the slip bounds of laws that have any.
    pub bounds: Vec<Amount<f64>>,
}
