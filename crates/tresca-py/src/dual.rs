//! The pure dual form: A as an array or as a Python function.

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tresca::Settings;
use tresca::algebraic::{Dual, Operator, solve_dual};

use crate::algebraic::{StartArrays, forces};
use crate::arrays;
use crate::errors;
use crate::laws::{Laws, friction};
use crate::observer::Observer;
use crate::options::over;
use crate::solution;

/// What stands beside A.
type Rest<'py> = (
    PyReadonlyArray1<'py, f64>,
    usize,
    Laws<'py>,
    Option<StartArrays<'py>>,
);

/// A is a square array.
#[pyfunction]
pub fn solve_dual_dense<'py>(
    py: Python<'py>,
    a: PyReadonlyArray2<'_, f64>,
    rest: Rest<'_>,
    options: &Bound<'_, PyDict>,
    callback: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let [rows, columns] = [a.shape()[0], a.shape()[1]];
    if rows != columns {
        return Err(errors::problem(format!(
            "A is {rows} × {columns}: it must be square"
        )));
    }
    let values = a.as_slice()?;
    let operator = py
        .detach(|| Operator::dense(rows, values))
        .map_err(errors::problem)?;
    solve(py, operator, &rest, options, callback)
}

/// A is a function of a vector.
#[pyfunction]
pub fn solve_dual_product<'py>(
    py: Python<'py>,
    product: Py<PyAny>,
    diagonal: Option<PyReadonlyArray1<'_, f64>>,
    rest: Rest<'_>,
    options: &Bound<'_, PyDict>,
    callback: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let failure = Arc::new(Mutex::new(None));
    let seen = Arc::clone(&failure);
    let apply = move |x: &[f64], y: &mut [f64]| {
        let mut failure = seen.lock().unwrap_or_else(PoisonError::into_inner);
        if failure.is_none() {
            *failure = Python::attach(|py| apply(py, &product, x, y)).err();
        }
        if failure.is_some() {
            // Ends the run; what was raised is raised again.
            y.fill(f64::NAN);
        }
    };
    let operator = Operator::Product {
        order: rest.0.len(),
        apply: Box::new(apply),
        diagonal: arrays::optional(diagonal.as_ref())?,
    };
    let solved = solve(py, operator, &rest, options, callback);
    let failure = failure
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .take();
    failure.map_or(solved, Err)
}

fn apply(py: Python<'_>, product: &Py<PyAny>, x: &[f64], y: &mut [f64]) -> PyResult<()> {
    let result = product.bind(py).call1((PyArray1::from_slice(py, x),))?;
    let result: PyReadonlyArray1<'_, f64> = result.extract()?;
    let result = result.as_slice()?;
    if result.len() != y.len() {
        return Err(PyValueError::new_err(format!(
            "the product A x has length {}, expected {}",
            result.len(),
            y.len()
        )));
    }
    y.copy_from_slice(result);
    Ok(())
}

fn solve<'py>(
    py: Python<'py>,
    operator: Operator,
    (rhs, tangents, laws, start): &Rest<'_>,
    options: &Bound<'_, PyDict>,
    callback: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let settings = over(&Settings::default(), options)?;
    let mut dual = Dual::new(operator, arrays::vector(rhs)?, *tangents, friction(laws)?);
    dual.start = forces(start.as_ref())?;
    let mut observer = Observer::new(callback);
    let solved = py.detach(|| solve_dual(dual, &settings, &mut observer));
    observer.finish()?;
    solution::algebraic(py, solved.map_err(errors::problem)?)
}
