//! What a run tells while it goes on, and how it is stopped. Libraries do not print: whoever wants to see
//! something implements [`Progress`].

use std::fmt;
use std::ops::ControlFlow;

use tresca_qcqp::IterationRecord;

use crate::description::Description;

/// The stages of a run, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Meshing has been done; stiffness, loads and contact data are built. Matrices are checked.
    Assembly,
    /// The bodies' stiffness matrices are ordered and factored.
    Factorization,
    /// The dual problem is solved.
    Solve,
    /// Displacements, stresses and the certificate are computed.
    Recovery,
}

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Stage::Assembly => "assembly",
            Stage::Factorization => "factorization",
            Stage::Solve => "solve",
            Stage::Recovery => "recovery",
        })
    }
}

/// The caller stopped the run before there was anything to give back. Once a method iterates, a stop is an
/// outcome instead: [`Status::Interrupted`](tresca_qcqp::Status::Interrupted), with what there is by then.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("stopped before the {0}: there is no result")]
pub struct Stopped(pub Stage);

/// A load step that is about to be solved.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct StepInfo<'a> {
    /// Its number, from 1.
    pub number: usize,
    /// How many there are.
    pub count: usize,
    /// Instant in the time series.
    pub time: f64,
    /// How reports call it.
    pub name: Option<&'a str>,
}

impl<'a> StepInfo<'a> {
    /// The step `number` of `count`, at the instant `time`.
    pub fn new(number: usize, count: usize, time: f64, name: Option<&'a str>) -> Self {
        Self {
            number,
            count,
            time,
            name,
        }
    }
}

/// Receives news from a run and may stop it.
pub trait Progress {
    /// A stage begins. `Break` ends the run before it.
    fn stage(&mut self, stage: Stage) -> ControlFlow<()> {
        let _ = stage;
        ControlFlow::Continue(())
    }

    /// The dual problem stands; its sizes and engine are known.
    fn problem(&mut self, description: &Description) {
        let _ = description;
    }

    /// A load step is about to be solved.
    fn step(&mut self, step: &StepInfo<'_>) {
        let _ = step;
    }

    /// An iteration is done. `Break` stops the method, which then returns what it has.
    fn iteration(&mut self, record: &IterationRecord) -> ControlFlow<()> {
        let _ = record;
        ControlFlow::Continue(())
    }
}

/// Begins a stage.
///
/// # Errors
/// [`Stopped`] when the caller does not want it.
pub fn begin(progress: &mut dyn Progress, stage: Stage) -> Result<(), Stopped> {
    match progress.stage(stage) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(Stopped(stage)),
    }
}

/// Hears nothing, stops nothing.
#[derive(Debug, Default, Clone, Copy)]
pub struct Silent;

impl Progress for Silent {}
