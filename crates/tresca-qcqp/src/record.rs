//! What is known of one iteration, and the table that iterations make.

use crate::active_set::StateCounts;
use serde::{Deserialize, Serialize};

/// One line of the iteration table: the feasible iterate λ_k and the step that
/// led to it. Iteration 0 is the start. Outer iterations (Coulomb's bounds, the multiplier of an
/// equality constraint) begin with a record of their own for their start: there `decrease`,
/// `set_changes`, `inner_iterations` and `step_length` are 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct IterationRecord {
    /// k, which runs on over outer iterations.
    pub iteration: usize,
    /// Number of the outer iteration, from 0: of the problem with bounds and multiplier held fixed.
    pub outer: usize,
    /// ‖r̃(λ_k)‖/‖r̃(0)‖ with ρ = 1/σmax, for the bounds and the multiplier of this outer iteration.
    pub relative_reduced_gradient: f64,
    /// q(λ_k), less αᵀGλ_k under an equality constraint.
    pub objective: f64,
    /// q(λ_{k−1}) − q(λ_k), computed without cancellation; 0 for k = 0.
    pub decrease: f64,
    /// How many blocks are open, closed, sticking, slipping at λ_k.
    pub counts: StateCounts,
    /// Blocks whose state differs from that at λ_{k−1}; 0 for k = 0.
    pub set_changes: usize,
    /// Iterations of the inner solver in this step (1 for a direct solve).
    pub inner_iterations: usize,
    /// Multiplications by A so far, those for σmax included.
    pub n_a: usize,
    /// Length α of the Newton step that was accepted; 0 when the method fell
    /// back to the projected gradient step, 1 for methods without a search.
    pub step_length: f64,
}

/// An entry of the iteration table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Entry {
    /// How many.
    Count(usize),
    /// How much.
    Real(f64),
}

/// How a terminal shows the entries of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// A count.
    Plain,
    /// So many digits after the point.
    Fixed(usize),
    /// So many digits after the point of the mantissa.
    Scientific(usize),
}

/// A column of the iteration table.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Column {
    /// Its name in files and in Python.
    pub key: &'static str,
    /// What it says.
    pub doc: &'static str,
    /// Its name where room is scarce.
    pub title: &'static str,
    /// Characters that a terminal gives it.
    pub width: usize,
    /// How a terminal shows it.
    pub notation: Notation,
    /// Its entry in the line of a record.
    pub entry: fn(&IterationRecord) -> Entry,
}

/// The columns, one line each: key, title, width, notation, entry, meaning.
macro_rules! columns {
    ($($key:literal $title:literal $width:literal $notation:expr, |$r:ident| $entry:expr, $doc:literal;)*) => {
        [$(Column { key: $key, doc: $doc, title: $title, width: $width, notation: $notation, entry: |$r| $entry }),*]
    };
}

impl IterationRecord {
    /// The columns of the iteration table, in their order: files, terminals and Python show these.
    pub const COLUMNS: [Column; 13] = {
        use Entry::{Count, Real};
        use Notation::{Fixed, Plain, Scientific};
        columns! {
            "iteration" "k" 4 Plain, |r| Count(r.iteration),
                "Its number; 0 is the start.";
            "outer" "outer" 5 Plain, |r| Count(r.outer),
                "Number of the outer iteration (Coulomb's bounds, motions of floating parts), from 0.";
            "relative_reduced_gradient" "rel. grad." 12 Scientific(4), |r| Real(r.relative_reduced_gradient),
                "What the tolerance is on.";
            "objective" "q" 16 Scientific(9), |r| Real(r.objective),
                "q(λ).";
            "decrease" "decrease" 10 Scientific(2), |r| Real(r.decrease),
                "By how much q fell.";
            "open" "open" 6 Plain, |r| Count(r.counts.open),
                "Pairs without normal force.";
            "closed" "closed" 6 Plain, |r| Count(r.counts.closed),
                "Pairs with.";
            "stick" "stick" 6 Plain, |r| Count(r.counts.stick),
                "Pairs (with separate tangents: directions) below their slip bound.";
            "slip" "slip" 6 Plain, |r| Count(r.counts.slip),
                "The others.";
            "set_changes" "changes" 7 Plain, |r| Count(r.set_changes),
                "How many changed their state.";
            "inner_iterations" "inner" 5 Plain, |r| Count(r.inner_iterations),
                "Iterations of the inner solver.";
            "n_a" "n_A" 6 Plain, |r| Count(r.n_a),
                "Multiplications by A so far.";
            "step_length" "step" 6 Fixed(3), |r| Real(r.step_length),
                "Length of the Newton step; 0 for a projected gradient step instead.";
        }
    };
}
