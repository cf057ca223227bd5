//! Callbacks and Ctrl-C.

use std::ops::ControlFlow;

use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyCFunction, PyDict, PyTuple};
use tresca::record::{Column, Entry};
use tresca::{IterationRecord, Progress, Stage};

/// One line of the iteration table.
#[pyclass(frozen, module = "tresca")]
pub struct Iteration(IterationRecord);

impl Iteration {
    /// Gives the class a property for each column of the table.
    pub fn describe(py: Python<'_>) -> PyResult<()> {
        let class = py.get_type::<Self>();
        let property = py.import("builtins")?.getattr("property")?;
        for column in IterationRecord::COLUMNS {
            let get = PyCFunction::new_closure(
                py,
                None,
                None,
                move |arguments: &Bound<'_, PyTuple>, _: Option<&Bound<'_, PyDict>>| {
                    let own = arguments.get_item(0)?.cast_into::<Self>()?;
                    entry(&column, &own.get().0, arguments.py())
                },
            )?;
            let none = py.None();
            class.setattr(column.key, property.call1((get, &none, &none, column.doc))?)?;
        }
        Ok(())
    }
}

fn entry(column: &Column, record: &IterationRecord, py: Python<'_>) -> PyResult<Py<PyAny>> {
    match (column.entry)(record) {
        Entry::Count(value) => value.into_py_any(py),
        Entry::Real(value) => value.into_py_any(py),
    }
}

#[pymethods]
impl Iteration {
    fn __repr__(&self) -> String {
        let record = &self.0;
        format!(
            "Iteration(iteration={}, relative_reduced_gradient={:.3e}, closed={}, stick={}, n_a={})",
            record.iteration,
            record.relative_reduced_gradient,
            record.counts.closed,
            record.counts.stick,
            record.n_a
        )
    }
}

/// Hands iterations to a Python function and looks for signals. Called without being attached to the
/// interpreter.
pub struct Observer {
    callback: Option<Py<PyAny>>,
    failure: Option<PyErr>,
}

impl Observer {
    /// Calls `callback(iteration)`; when that returns something true, the run stops.
    pub fn new(callback: Option<Py<PyAny>>) -> Self {
        Self {
            callback,
            failure: None,
        }
    }

    /// # Errors
    /// What the callback raised, or `KeyboardInterrupt`.
    pub fn finish(self) -> PyResult<()> {
        self.failure.map_or(Ok(()), Err)
    }

    fn tell(&mut self, record: Option<&IterationRecord>) -> ControlFlow<()> {
        if self.failure.is_some() {
            return ControlFlow::Break(());
        }
        let stop = Python::attach(|py| {
            py.check_signals()?;
            match (&self.callback, record) {
                (Some(callback), Some(record)) => callback
                    .bind(py)
                    .call1((Iteration(record.clone()),))?
                    .is_truthy(),
                _ => Ok(false),
            }
        });
        match stop {
            Ok(false) => ControlFlow::Continue(()),
            Ok(true) => ControlFlow::Break(()),
            Err(failure) => {
                self.failure = Some(failure);
                ControlFlow::Break(())
            }
        }
    }
}

impl Progress for Observer {
    fn stage(&mut self, _: Stage) -> ControlFlow<()> {
        self.tell(None)
    }

    fn iteration(&mut self, record: &IterationRecord) -> ControlFlow<()> {
        self.tell(Some(record))
    }
}
