//! A run with a result.

use tresca::output::Destination;
use tresca::{RunReport, Status};

/// What writes the result files of a run into a directory, under the run's name.
pub type Write<'a> = Box<dyn FnOnce(Destination, &str) -> miette::Result<RunReport> + 'a>;

/// A run with a result.
pub struct Finished<'a> {
    /// How it ended.
    pub status: Status,
    /// Iterations of all steps.
    pub iterations: usize,
    /// Writes the result files.
    pub write: Write<'a>,
}

impl Finished<'_> {
    /// Writes the result files.
    pub fn write(self, destination: Destination, name: &str) -> miette::Result<RunReport> {
        (self.write)(destination, name)
    }
}
