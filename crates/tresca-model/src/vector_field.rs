//! Vectors that may vary in space.

use std::fmt;
use std::sync::Arc;

/// A vector that may vary in space.
#[derive(Clone)]
pub enum VectorField {
    /// The same everywhere.
    Constant([f64; 3]),
    /// A function of the undeformed position.
    Function(Arc<dyn Fn([f64; 3]) -> [f64; 3] + Send + Sync>),
}

impl VectorField {
    /// The vector at a point of the undeformed body.
    pub fn at(&self, point: [f64; 3]) -> [f64; 3] {
        match self {
            VectorField::Constant(value) => *value,
            VectorField::Function(function) => function(point),
        }
    }

    /// The vector, where it is the same everywhere.
    pub fn constant(&self) -> Option<[f64; 3]> {
        match self {
            VectorField::Constant(value) => Some(*value),
            VectorField::Function(_) => None,
        }
    }
}

impl From<[f64; 3]> for VectorField {
    fn from(value: [f64; 3]) -> Self {
        VectorField::Constant(value)
    }
}

impl fmt::Debug for VectorField {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VectorField::Constant(value) => write!(f, "Constant({value:?})"),
            VectorField::Function(_) => f.write_str("Function"),
        }
    }
}
