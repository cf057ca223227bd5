//! Results as dictionaries of arrays, in the caller's order.

use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;
use tresca::algebraic::Solution;
use tresca::record::Entry;
use tresca::{IterationRecord, RunReport};

use crate::errors;

/// The result of a problem made of matrices.
pub fn algebraic<'py>(py: Python<'py>, solution: Solution) -> PyResult<Bound<'py, PyDict>> {
    let result = PyDict::new(py);
    let pairs = solution.normal_force.len();
    let tangents = solution.tangential_force.len() / pairs.max(1);
    result.set_item("summary", json(&RunReport::of_matrices(&solution))?)?;
    result.set_item("history", history(py, &solution.records)?)?;
    result.set_item(
        "slip_bounds",
        bounds(py, solution.slip_bounds.iter().copied())?,
    )?;
    result.set_item("u", solution.displacement.into_pyarray(py))?;
    result.set_item("normal_force", solution.normal_force.into_pyarray(py))?;
    let tangential = |values: Vec<f64>| values.into_pyarray(py).reshape([pairs, tangents]);
    result.set_item("tangential_force", tangential(solution.tangential_force)?)?;
    result.set_item("slip", tangential(solution.slip)?)?;
    result.set_item("closed", solution.closed.into_pyarray(py))?;
    result.set_item("stick", solution.stick.into_pyarray(py))?;
    result.set_item("gap", solution.gap.into_pyarray(py))?;
    result.set_item("kernel_amounts", solution.kernel_amounts.into_pyarray(py))?;
    let motion = solution
        .unresisted_motion
        .map(|motion| motion.into_pyarray(py));
    result.set_item("unresisted_motion", motion)?;
    Ok(result)
}

/// The iteration table, column by column.
pub fn history<'py>(py: Python<'py>, records: &[IterationRecord]) -> PyResult<Bound<'py, PyDict>> {
    let table = PyDict::new(py);
    for column in IterationRecord::COLUMNS {
        let (mut counts, mut figures) = (Vec::new(), Vec::new());
        for record in records {
            match (column.entry)(record) {
                Entry::Count(count) => counts.push(i64::try_from(count).unwrap_or(i64::MAX)),
                Entry::Real(figure) => figures.push(figure),
            }
        }
        // A column is of one kind.
        match figures.is_empty() {
            true => table.set_item(column.key, counts.into_pyarray(py))?,
            false => table.set_item(column.key, figures.into_pyarray(py))?,
        }
    }
    Ok(table)
}

/// Two bounds per pair; infinite where nothing slides.
pub fn bounds<'py>(
    py: Python<'py>,
    bounds: impl Iterator<Item = Option<[f64; 2]>>,
) -> PyResult<Bound<'py, PyAny>> {
    rows(
        py,
        bounds.map(|bounds| bounds.unwrap_or([f64::INFINITY; 2])),
    )
}

/// An array with K columns.
pub fn rows<'py, const K: usize>(
    py: Python<'py>,
    rows: impl Iterator<Item = [f64; K]>,
) -> PyResult<Bound<'py, PyAny>> {
    let values: Vec<f64> = rows.flatten().collect();
    let count = values.len() / K;
    Ok(values.into_pyarray(py).reshape([count, K])?.into_any())
}

/// Figures that are no arrays.
pub fn json(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(errors::problem)
}
