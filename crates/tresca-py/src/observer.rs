//! Callbacks and Ctrl-C.

use std::ops::ControlFlow;

use pyo3::prelude::*;
use tresca::{IterationRecord, Progress, Stage};

/// One line of the iteration table.
#[pyclass(frozen, get_all, module = "tresca")]
pub struct Iteration {
    /// Its number; 0 is the start.
    iteration: usize,
    /// Number of the outer iteration (Coulomb's bounds, motions of floating parts), from 0.
    outer: usize,
    /// What the tolerance is on.
    relative_reduced_gradient: f64,
    /// q(λ).
    objective: f64,
    /// By how much q fell.
    decrease: f64,
    /// Pairs without normal force.
    open: usize,
    /// Pairs with.
    closed: usize,
    /// Pairs (with separate tangents: directions) below their slip bound.
    stick: usize,
    /// The others.
    slip: usize,
    /// How many changed their state.
    set_changes: usize,
    /// Iterations of the inner solver.
    inner_iterations: usize,
    /// Multiplications by A so far.
    n_a: usize,
    /// Length of the Newton step; 0 for a projected gradient step instead.
    step_length: f64,
}

impl From<&IterationRecord> for Iteration {
    fn from(record: &IterationRecord) -> Self {
        let counts = &record.counts;
        Self {
            iteration: record.iteration,
            outer: record.outer,
            relative_reduced_gradient: record.relative_reduced_gradient,
            objective: record.objective,
            decrease: record.decrease,
            open: counts.open,
            closed: counts.closed,
            stick: counts.stick,
            slip: counts.slip,
            set_changes: record.set_changes,
            inner_iterations: record.inner_iterations,
            n_a: record.n_a,
            step_length: record.step_length,
        }
    }
}

#[pymethods]
impl Iteration {
    fn __repr__(&self) -> String {
        format!(
            "Iteration(iteration={}, relative_reduced_gradient={:.3e}, closed={}, stick={}, n_a={})",
            self.iteration, self.relative_reduced_gradient, self.closed, self.stick, self.n_a
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
                    .call1((Iteration::from(record),))?
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
