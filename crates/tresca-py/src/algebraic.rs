//! Problems made of matrices.

use std::sync::{Mutex, TryLockError};

use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tresca::Settings;
use tresca::algebraic::{self, Conditions, Forces, Kernel, Matrix, MatrixProblem};

use crate::arrays::{self, Parts};
use crate::errors;
use crate::laws::{Laws, friction};
use crate::observer::Observer;
use crate::options::over;
use crate::solution;

/// (normal forces, tangential forces, kernel amounts) to start from.
pub type StartArrays<'py> = (
    PyReadonlyArray1<'py, f64>,
    PyReadonlyArray1<'py, f64>,
    PyReadonlyArray1<'py, f64>,
);

/// The forces of a start.
pub fn forces(start: Option<&StartArrays<'_>>) -> PyResult<Option<Forces>> {
    let Some((normal, tangential, amounts)) = start else {
        return Ok(None);
    };
    Ok(Some(Forces {
        normal: arrays::vector(normal)?,
        tangential: arrays::vector(tangential)?,
        kernel_amounts: arrays::vector(amounts)?,
    }))
}

/// A problem that is checked, factored and posed.
#[pyclass(frozen, module = "tresca._tresca")]
pub struct Prepared {
    // A problem is solved by one thread at a time: what it learns about A is kept in it.
    inner: Mutex<algebraic::PreparedProblem>,
}

#[pymethods]
impl Prepared {
    #[new]
    #[expect(
        clippy::too_many_arguments,
        reason = "the Python half hands over arrays one by one"
    )]
    fn new(
        py: Python<'_>,
        stiffness: Vec<Parts<'_>>,
        normal: Parts<'_>,
        tangential: Option<Parts<'_>>,
        kernel: Option<Vec<PyReadonlyArray1<'_, f64>>>,
        points: Option<PyReadonlyArray2<'_, f64>>,
        many_solves: bool,
        laws: Laws<'_>,
        options: &Bound<'_, PyDict>,
        callback: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let settings = over(&Settings::default(), options)?;
        let stiffness = stiffness.iter().map(|block| block.matrix("K"));
        let stiffness = stiffness.collect::<PyResult<Vec<_>>>()?;
        let dofs = stiffness.iter().map(Matrix::rows).sum();
        let mut problem = MatrixProblem::new(stiffness, normal.matrix("N")?, vec![0.0; dofs])
            .with_friction(friction(&laws)?);
        if let Some(tangential) = tangential {
            problem = problem.with_tangential(tangential.matrix("T")?);
        }
        if let Some(vectors) = kernel {
            let vectors = vectors.iter().map(arrays::vector);
            problem.kernel = Kernel::Given(vectors.collect::<PyResult<_>>()?);
        }
        if let Some(points) = points {
            problem.points = Some(points.as_slice()?.as_chunks::<3>().0.to_vec());
        }
        problem.many_solves = many_solves;
        let mut observer = Observer::new(callback);
        let prepared = py.detach(|| algebraic::prepare(&problem, &settings, &mut observer));
        observer.finish()?;
        let inner = Mutex::new(prepared.map_err(errors::problem)?);
        Ok(Self { inner })
    }

    /// What the user should know about the input.
    #[getter]
    fn notes(&self) -> PyResult<Vec<String>> {
        let inner = self.lock()?;
        Ok(inner.notes().iter().map(ToString::to_string).collect())
    }

    /// Sizes and engine, as JSON.
    #[getter]
    fn description(&self) -> PyResult<String> {
        solution::json(self.lock()?.description())
    }

    #[expect(
        clippy::too_many_arguments,
        reason = "the Python half hands over arrays one by one"
    )]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        load: PyReadonlyArray1<'_, f64>,
        gap: Option<PyReadonlyArray1<'_, f64>>,
        laws: Laws<'_>,
        previous_slip: Option<PyReadonlyArray1<'_, f64>>,
        start: Option<StartArrays<'_>>,
        options: &Bound<'_, PyDict>,
        callback: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let settings = over(&Settings::default(), options)?;
        let conditions = Conditions {
            load: arrays::vector(&load)?,
            gap: arrays::optional(gap.as_ref())?,
            friction: friction(&laws)?,
            previous_slip: arrays::optional(previous_slip.as_ref())?,
            start: forces(start.as_ref())?,
        };
        let mut observer = Observer::new(callback);
        let mut guard = self.lock()?;
        let inner = &mut *guard;
        let solved = py.detach(|| inner.solve(&conditions, &settings, &mut observer));
        drop(guard);
        observer.finish()?;
        solution::algebraic(py, solved.map_err(errors::problem)?)
    }
}

impl Prepared {
    fn lock(&self) -> PyResult<std::sync::MutexGuard<'_, algebraic::PreparedProblem>> {
        match self.inner.try_lock() {
            Ok(guard) => Ok(guard),
            // A panic is a bug, but the problem is posed anew by every solve.
            Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => Err(errors::problem(
                "this problem is being solved already: prepare one for each thread",
            )),
        }
    }
}
