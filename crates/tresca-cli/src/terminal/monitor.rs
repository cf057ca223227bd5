//! The run as it goes on: stages with a spinner (on a terminal only) and the iteration table.

use std::ops::ControlFlow;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use tresca::record::{Column, Entry, Notation};
use tresca::{Description, IterationRecord, Progress, Stage, StepInfo};

use super::format::grouped;
use crate::interrupt::Interrupt;

/// Prints what a run tells, and hands on the user's Ctrl-C.
pub struct Monitor {
    interrupt: Interrupt,
    print: bool,
    verbose: bool,
    spinner: ProgressBar,
}

impl Monitor {
    pub fn new(interrupt: Interrupt, quiet: bool, verbose: bool) -> Self {
        Self {
            interrupt,
            print: !quiet,
            verbose,
            spinner: ProgressBar::hidden(),
        }
    }

    fn flow(&self) -> ControlFlow<()> {
        if self.interrupt.is_set() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Draws to standard error, and only when that is a terminal.
    fn spin(&mut self, message: &'static str) {
        self.spinner.finish_and_clear();
        if !self.print {
            return;
        }
        let style = ProgressStyle::with_template("{spinner} {msg} {elapsed}")
            .unwrap_or_else(|_| ProgressStyle::default_spinner());
        self.spinner = ProgressBar::new_spinner()
            .with_style(style)
            .with_message(message);
        self.spinner.enable_steady_tick(Duration::from_millis(120));
    }

    /// The head of the iteration table.
    fn header(&self) {
        if !self.print {
            return;
        }
        println!("\n{}", row(|column| column.title.to_owned()));
    }

    /// Removes whatever is still turning.
    pub fn finish(&mut self) {
        self.spinner.finish_and_clear();
    }
}

impl Progress for Monitor {
    fn stage(&mut self, stage: Stage) -> ControlFlow<()> {
        match stage {
            Stage::Assembly => self.spin("assembling"),
            Stage::Factorization => self.spin("factoring the bodies"),
            Stage::Solve => {
                self.finish();
                self.header();
            }
            Stage::Recovery => self.spin("recovering displacements, checking the result"),
        }
        self.flow()
    }

    fn problem(&mut self, description: &Description) {
        self.finish();
        if !self.print {
            return;
        }
        println!(
            "{} bodies, {} dofs, {} contact pairs; engine: {}",
            description.bodies,
            grouped(description.dofs),
            grouped(description.pairs),
            description.engine.engine
        );
        if description.held_pairs > 0 {
            println!(
                "{} pairs are left out: nothing lets them move",
                grouped(description.held_pairs)
            );
        }
        if self.verbose {
            let work = &description.factorization;
            println!("engine because: {}", description.engine.reason);
            println!(
                "factorisation: {:.3e} nonzeros, {:.1} GFLOP in {:.2} s = {:.1} GFLOP/s",
                work.nonzeros,
                work.flops / 1e9,
                work.seconds,
                work.gigaflops_per_second()
            );
        }
        if description.rigid_motions > 0 {
            println!(
                "{} rigid motions are not held by supports: contact has to hold them",
                description.rigid_motions
            );
        }
    }

    fn step(&mut self, step: &StepInfo<'_>) {
        if self.print && step.count > 1 {
            let StepInfo {
                number,
                count,
                time,
                name,
                ..
            } = step;
            let name = name.unwrap_or("");
            println!("\nload step {number} of {count}, time {time} {name}");
        }
    }

    fn iteration(&mut self, record: &IterationRecord) -> ControlFlow<()> {
        if self.print {
            println!("{}", row(|column| shown(column, record)));
        }
        self.flow()
    }
}

/// A line of the iteration table, its cells to the right of their columns.
fn row(cell: impl Fn(&Column) -> String) -> String {
    let cells = IterationRecord::COLUMNS.iter();
    let cells = cells.map(|column| format!("{:>1$}", cell(column), column.width));
    cells.collect::<Vec<_>>().join(" ")
}

/// The line of a record; without one the head of the table.
pub fn row_of(record: Option<&IterationRecord>) -> String {
    row(|column| record.map_or_else(|| column.title.to_owned(), |record| shown(column, record)))
}

fn shown(column: &Column, record: &IterationRecord) -> String {
    match ((column.entry)(record), column.notation) {
        (Entry::Real(value), Notation::Fixed(digits)) => format!("{value:.digits$}"),
        (Entry::Real(value), Notation::Scientific(digits)) => format!("{value:.digits$e}"),
        (Entry::Real(value), Notation::Plain) => value.to_string(),
        (Entry::Count(count), _) => count.to_string(),
    }
}
