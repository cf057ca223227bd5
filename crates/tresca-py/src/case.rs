//! Case files.

use std::path::PathBuf;
use std::sync::Arc;

use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use tresca::output::Destination;
use tresca::{PairState, RunReport, StepOutcome};

use crate::errors::{self, OutputError};
use crate::observer::Observer;
use crate::options::over;
use crate::solution::{bounds, history, json, rows};

/// A case file, read and checked.
#[pyclass(frozen, module = "tresca._tresca")]
pub struct Case {
    inner: Arc<tresca::case::Case>,
}

#[pymethods]
impl Case {
    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        Self::read(tresca::case::Case::load(path))
    }

    #[staticmethod]
    fn parse(name: &str, text: &str) -> PyResult<Self> {
        Self::read(tresca::case::Case::parse(name, text))
    }

    #[getter]
    fn title(&self) -> &str {
        self.inner.model.title()
    }

    /// The solver settings of the file, as JSON.
    #[getter]
    fn settings(&self) -> PyResult<String> {
        json(self.inner.settings())
    }

    /// Runs the case.
    fn solve(
        &self,
        py: Python<'_>,
        options: &Bound<'_, PyDict>,
        callback: Option<Py<PyAny>>,
    ) -> PyResult<CaseOutcome> {
        let settings = over(self.inner.settings(), options)?;
        let model = &self.inner.model;
        let mut observer = Observer::new(callback);
        let outcome = py.detach(|| tresca::solve_with(model, &settings, &mut observer));
        // A signal has stopped the run, or a callback: that is what is raised.
        observer.finish()?;
        let outcome =
            outcome.map_err(|error| errors::case(tresca::case::locate(&self.inner, &error)))?;
        Ok(CaseOutcome {
            case: Arc::clone(&self.inner),
            outcome,
        })
    }
}

impl Case {
    fn read(case: Result<tresca::case::Case, impl miette::Diagnostic>) -> PyResult<Self> {
        let inner = Arc::new(case.map_err(errors::case)?);
        Ok(Self { inner })
    }
}

/// The result of a case.
#[pyclass(frozen, module = "tresca._tresca", name = "Outcome")]
pub struct CaseOutcome {
    case: Arc<tresca::case::Case>,
    outcome: tresca::Outcome,
}

#[pymethods]
impl CaseOutcome {
    /// What `summary.json` holds.
    fn summary(&self) -> PyResult<String> {
        json(&RunReport::of_model(&self.case.model, &self.outcome))
    }

    /// The result files of the command line.
    fn write(&self, py: Python<'_>, directory: PathBuf, name: &str) -> PyResult<()> {
        py.detach(|| Destination::new(&directory)?.write(name, &self.case.model, &self.outcome))
            .map(drop)
            .map_err(|error| OutputError::new_err(error.to_string()))
    }

    /// Name, dimension and node coordinates of the bodies.
    fn bodies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let list = PyList::empty(py);
        for body in self.case.model.bodies() {
            list.append((&body.name, rows(py, body.mesh.points.iter().copied())?))?;
        }
        Ok(list)
    }

    /// The arrays of every step.
    fn steps<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let list = PyList::empty(py);
        for step in &self.outcome.steps {
            list.append(self.step(py, step)?)?;
        }
        Ok(list)
    }
}

impl CaseOutcome {
    fn step<'py>(&self, py: Python<'py>, step: &StepOutcome) -> PyResult<Bound<'py, PyDict>> {
        let model = &self.case.model;
        let result = PyDict::new(py);
        let displacements = PyDict::new(py);
        for (body, u) in model.bodies().iter().zip(&step.displacements) {
            let components = body.mesh.dimension();
            let u = u
                .clone()
                .into_pyarray(py)
                .reshape([u.len() / components, components])?;
            displacements.set_item(&body.name, u)?;
        }
        result.set_item("displacements", displacements)?;
        result.set_item("history", history(py, &step.solution.records)?)?;
        let contacts = PyList::empty(py);
        for (contact, pairs) in model.contacts().iter().zip(&step.contacts) {
            let arrays = contact_arrays(py, pairs)?;
            arrays.set_item("slave", model.surface_name(&contact.slave))?;
            arrays.set_item("master", model.partner_name(&contact.master))?;
            contacts.append(arrays)?;
        }
        result.set_item("contacts", contacts)?;
        Ok(result)
    }
}

fn contact_arrays<'py>(py: Python<'py>, pairs: &[PairState]) -> PyResult<Bound<'py, PyDict>> {
    let arrays = PyDict::new(py);
    let numbers =
        |pick: fn(&PairState) -> f64| pairs.iter().map(pick).collect::<Vec<_>>().into_pyarray(py);
    let states =
        |pick: fn(&PairState) -> bool| pairs.iter().map(pick).collect::<Vec<_>>().into_pyarray(py);
    let vectors = |pick: fn(&PairState) -> [f64; 3]| rows(py, pairs.iter().map(pick));
    arrays.set_item("points", vectors(|p| p.pair.point)?)?;
    arrays.set_item("normals", vectors(|p| p.pair.frame.normal)?)?;
    arrays.set_item("areas", numbers(|p| p.pair.area))?;
    arrays.set_item("closed", states(|p| p.closed))?;
    arrays.set_item("stick", states(|p| p.stick))?;
    arrays.set_item("normal_force", numbers(|p| p.normal_force))?;
    arrays.set_item("pressure", numbers(PairState::pressure))?;
    arrays.set_item("friction_force", vectors(|p| p.friction_force)?)?;
    arrays.set_item(
        "slip_bounds",
        bounds(py, pairs.iter().map(|p| p.slip_bounds))?,
    )?;
    arrays.set_item("gap", numbers(|p| p.gap))?;
    arrays.set_item("slip", vectors(|p| p.slip)?)?;
    Ok(arrays)
}
