//! Results as dictionaries of arrays, in the caller's order.

use numpy::{IntoPyArray, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;
use tresca::IterationRecord;
use tresca::algebraic::{Solution, Summary};

use crate::errors;

/// The result of a problem made of matrices.
pub fn algebraic<'py>(py: Python<'py>, solution: Solution) -> PyResult<Bound<'py, PyDict>> {
    let result = PyDict::new(py);
    let pairs = solution.normal_force.len();
    let tangents = solution.tangential_force.len() / pairs.max(1);
    result.set_item("summary", json(&Summary::new("", &solution))?)?;
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
    let columns = PyDict::new(py);
    let counts = |pick: fn(&IterationRecord) -> usize| -> Bound<'py, PyArray1<i64>> {
        let column = records
            .iter()
            .map(|record| i64::try_from(pick(record)).unwrap_or(i64::MAX));
        column.collect::<Vec<_>>().into_pyarray(py)
    };
    let numbers = |pick: fn(&IterationRecord) -> f64| -> Bound<'py, PyArray1<f64>> {
        records
            .iter()
            .map(pick)
            .collect::<Vec<_>>()
            .into_pyarray(py)
    };
    columns.set_item("iteration", counts(|r| r.iteration))?;
    columns.set_item("outer", counts(|r| r.outer))?;
    columns.set_item(
        "relative_reduced_gradient",
        numbers(|r| r.relative_reduced_gradient),
    )?;
    columns.set_item("objective", numbers(|r| r.objective))?;
    columns.set_item("decrease", numbers(|r| r.decrease))?;
    columns.set_item("open", counts(|r| r.counts.open))?;
    columns.set_item("closed", counts(|r| r.counts.closed))?;
    columns.set_item("stick", counts(|r| r.counts.stick))?;
    columns.set_item("slip", counts(|r| r.counts.slip))?;
    columns.set_item("set_changes", counts(|r| r.set_changes))?;
    columns.set_item("inner_iterations", counts(|r| r.inner_iterations))?;
    columns.set_item("n_a", counts(|r| r.n_a))?;
    columns.set_item("step_length", numbers(|r| r.step_length))?;
    Ok(columns)
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
