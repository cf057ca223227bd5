//! What a run tells while it goes on. Libraries do not print: whoever wants to see something
//! implements [`Progress`].

use std::ops::ControlFlow;

use tresca_qcqp::IterationRecord;

use crate::model::Step;

/// The stages of a run, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Meshing has been done; stiffness, loads and contact data are built.
    Assembly,
    /// The bodies' stiffness matrices are ordered and factored.
    Factorization,
    /// The dual problem is solved.
    Solve,
    /// Displacements, stresses and the certificate are computed.
    Recovery,
}

/// Receives news from a run and may stop it.
pub trait Progress {
    /// A stage begins. `Break` ends the run before it.
    fn stage(&mut self, stage: Stage) -> ControlFlow<()> {
        let _ = stage;
        ControlFlow::Continue(())
    }

    /// The dual problem stands; its sizes and engine are known.
    fn problem(&mut self, description: &crate::Description) {
        let _ = description;
    }

    /// A load step, `number` of `count`, is about to be solved.
    fn step(&mut self, number: usize, count: usize, step: &Step) {
        let _ = (number, count, step);
    }

    /// An iteration is done. `Break` stops the method, which then returns what it has.
    fn iteration(&mut self, record: &IterationRecord) -> ControlFlow<()> {
        let _ = record;
        ControlFlow::Continue(())
    }
}

/// Hears nothing, stops nothing.
#[derive(Debug, Default, Clone, Copy)]
pub struct Silent;

impl Progress for Silent {}
