//! The columns of the iteration table: of `history.csv`, the terminal and Python.

use tresca_qcqp::IterationRecord;

/// A column of the iteration table.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    /// Its name in files and in Python.
    pub name: &'static str,
    /// Its heading where there is little room.
    pub heading: &'static str,
    /// What it says.
    pub doc: &'static str,
    /// The entry of a record.
    pub value: Entry,
    /// Digits that are worth showing behind the point.
    pub digits: usize,
}

/// What a column holds.
#[derive(Debug, Clone, Copy)]
pub enum Entry {
    /// A count.
    Count(fn(&IterationRecord) -> usize),
    /// A figure of any size.
    Figure(fn(&IterationRecord) -> f64),
    /// A figure between 0 and 1.
    Share(fn(&IterationRecord) -> f64),
}

/// All of them, in order.
pub const COLUMNS: [Column; 13] = [
    Column {
        name: "iteration",
        heading: "k",
        doc: "Its number; 0 is the start.",
        value: Entry::Count(|r| r.iteration),
        digits: 0,
    },
    Column {
        name: "outer",
        heading: "outer",
        doc: "Number of the outer iteration (Coulomb's bounds, motions of floating parts), from 0.",
        value: Entry::Count(|r| r.outer),
        digits: 0,
    },
    Column {
        name: "relative_reduced_gradient",
        heading: "rel. grad.",
        doc: "What the tolerance is on.",
        value: Entry::Figure(|r| r.relative_reduced_gradient),
        digits: 4,
    },
    Column {
        name: "objective",
        heading: "q",
        doc: "q(λ).",
        value: Entry::Figure(|r| r.objective),
        digits: 9,
    },
    Column {
        name: "decrease",
        heading: "decrease",
        doc: "By how much q fell.",
        value: Entry::Figure(|r| r.decrease),
        digits: 2,
    },
    Column {
        name: "open",
        heading: "open",
        doc: "Pairs without normal force.",
        value: Entry::Count(|r| r.counts.open),
        digits: 0,
    },
    Column {
        name: "closed",
        heading: "closed",
        doc: "Pairs with.",
        value: Entry::Count(|r| r.counts.closed),
        digits: 0,
    },
    Column {
        name: "stick",
        heading: "stick",
        doc: "Pairs (with separate tangents: directions) below their slip bound.",
        value: Entry::Count(|r| r.counts.stick),
        digits: 0,
    },
    Column {
        name: "slip",
        heading: "slip",
        doc: "The others.",
        value: Entry::Count(|r| r.counts.slip),
        digits: 0,
    },
    Column {
        name: "set_changes",
        heading: "changes",
        doc: "How many changed their state.",
        value: Entry::Count(|r| r.set_changes),
        digits: 0,
    },
    Column {
        name: "inner_iterations",
        heading: "inner",
        doc: "Iterations of the inner solver.",
        value: Entry::Count(|r| r.inner_iterations),
        digits: 0,
    },
    Column {
        name: "n_a",
        heading: "n_A",
        doc: "Multiplications by A so far.",
        value: Entry::Count(|r| r.n_a),
        digits: 0,
    },
    Column {
        name: "step_length",
        heading: "step",
        doc: "Length of the Newton step; 0 for a projected gradient step instead.",
        value: Entry::Share(|r| r.step_length),
        digits: 3,
    },
];
