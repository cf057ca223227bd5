//! Scalars that may vary over a surface.

use std::fmt;
use std::sync::Arc;

use crate::error::ContactError;

/// A quantity that may vary over the slave surface.
#[derive(Clone)]
pub enum ScalarField {
    /// The same everywhere.
    Constant(f64),
    /// One value per node of the slave surface, by ascending node number.
    Values(Vec<f64>),
    /// A function of the undeformed position.
    Function(Arc<dyn Fn([f64; 3]) -> f64 + Send + Sync>),
}

impl fmt::Debug for ScalarField {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ScalarField::Constant(value) => write!(f, "Constant({value})"),
            ScalarField::Values(values) => write!(f, "Values({} nodes)", values.len()),
            ScalarField::Function(_) => f.write_str("Function"),
        }
    }
}

impl From<f64> for ScalarField {
    fn from(value: f64) -> Self {
        ScalarField::Constant(value)
    }
}

impl ScalarField {
    /// The value at the `index`-th of `count` nodes of the slave surface.
    pub(crate) fn at(
        &self,
        index: usize,
        count: usize,
        point: [f64; 3],
    ) -> Result<f64, ContactError> {
        match self {
            ScalarField::Constant(value) => Ok(*value),
            ScalarField::Values(values) if values.len() == count => Ok(values[index]),
            ScalarField::Values(values) => Err(ContactError::ValueCount {
                expected: count,
                found: values.len(),
            }),
            ScalarField::Function(function) => Ok(function(point)),
        }
    }
}
