//! Matrices and vectors from NumPy arrays. The Python half makes them contiguous and double precision;
//! the library checks shapes, indices and that every entry is finite.

use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use tresca::algebraic::{AlgebraicError, Index, Matrix, MatrixError};

use crate::errors;

/// A matrix as the Python half hands it over.
#[derive(FromPyObject)]
pub enum Parts<'py> {
    /// (format, shape, first indices, second indices, values) of `csr`, `csc` and `coo`, 32-bit indices.
    Narrow(Compressed<'py, i32>),
    /// The same with 64-bit indices.
    Wide(Compressed<'py, i64>),
    /// A dense matrix.
    Dense(PyReadonlyArray2<'py, f64>),
}

type Compressed<'py, I> = (
    String,
    (usize, usize),
    PyReadonlyArray1<'py, I>,
    PyReadonlyArray1<'py, I>,
    PyReadonlyArray1<'py, f64>,
);

impl Parts<'_> {
    /// The matrix; `what` is its name in messages.
    pub fn matrix(&self, what: &'static str) -> PyResult<Matrix> {
        match self {
            Parts::Narrow(parts) => compressed(what, parts),
            Parts::Wide(parts) => compressed(what, parts),
            Parts::Dense(values) => {
                let shape = (values.shape()[0], values.shape()[1]);
                let matrix = Matrix::from_dense(shape, values.as_slice()?);
                matrix.map_err(|source| refused(what, source))
            }
        }
    }
}

fn compressed<I: Index + numpy::Element>(
    what: &'static str,
    (format, shape, first, second, values): &Compressed<'_, I>,
) -> PyResult<Matrix> {
    let (first, second, values) = (first.as_slice()?, second.as_slice()?, values.as_slice()?);
    let matrix = match format.as_str() {
        "csr" => Matrix::from_csr(*shape, first, second, values),
        "csc" => Matrix::from_csc(*shape, first, second, values),
        "coo" => Matrix::from_triplets(*shape, first, second, values),
        other => {
            return Err(errors::problem(format!(
                "{what} has the format `{other}`: expected csr, csc or coo"
            )));
        }
    };
    matrix.map_err(|source| refused(what, source))
}

fn refused(what: &'static str, source: MatrixError) -> PyErr {
    errors::problem(AlgebraicError::Matrix { what, source })
}

/// A vector that is kept.
pub fn vector(values: &PyReadonlyArray1<'_, f64>) -> PyResult<Vec<f64>> {
    Ok(values.as_slice()?.to_vec())
}

/// The same, if there is one.
pub fn optional(values: Option<&PyReadonlyArray1<'_, f64>>) -> PyResult<Option<Vec<f64>>> {
    values.map(vector).transpose()
}
