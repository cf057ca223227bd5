//! Iteration records as rows of a table.

use tresca_io::history::Value;
use tresca_qcqp::IterationRecord;

/// What every table of iterations has.
pub(crate) const COLUMNS: [&str; 13] = [
    "iteration",
    "outer",
    "relative_reduced_gradient",
    "dual_objective",
    "decrease",
    "open",
    "closed",
    "stick",
    "slip",
    "set_changes",
    "inner_iterations",
    "n_a",
    "step_length",
];

/// The values of one iteration, in the order of [`COLUMNS`].
pub(crate) fn row(record: &IterationRecord) -> [Value; COLUMNS.len()] {
    let counts = record.counts;
    [
        record.iteration.into(),
        record.outer.into(),
        record.relative_reduced_gradient.into(),
        record.objective.into(),
        record.decrease.into(),
        counts.open.into(),
        counts.closed.into(),
        counts.stick.into(),
        counts.slip.into(),
        record.set_changes.into(),
        record.inner_iterations.into(),
        record.n_a.into(),
        record.step_length.into(),
    ]
}
