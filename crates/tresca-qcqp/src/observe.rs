//! Being told about iterations.

use crate::record::IterationRecord;
use std::ops::ControlFlow;

/// Is told about every iteration and may ask to stop.
pub trait Observer {
    /// Called once per record, the start (iteration 0) included.
    /// [`ControlFlow::Break`] ends the run with
    /// [`Status::Interrupted`](crate::Status::Interrupted), unless it has just converged.
    fn iteration(&mut self, record: &IterationRecord) -> ControlFlow<()>;
}

impl<F: FnMut(&IterationRecord) -> ControlFlow<()>> Observer for F {
    fn iteration(&mut self, record: &IterationRecord) -> ControlFlow<()> {
        self(record)
    }
}

/// The observer that looks away.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unobserved;

impl Observer for Unobserved {
    fn iteration(&mut self, _: &IterationRecord) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}
