//! The result files of a problem of FCLIB or Siconos.

use std::io::Write;
use std::time::Instant;

use tresca_io::atomic::OutputSet;
#[cfg(feature = "fclib")]
use tresca_io::fclib::State;
use tresca_io::fclib::{Document, FclibProblem};
use tresca_io::history::{History, Value};
use tresca_io::{WriteError, summary};
use tresca_qcqp::Settings;

use super::{Destination, SUMMARY, history};
use crate::fclib::law::FclibLaw;
use crate::fclib::solve::FclibOutcome;
use crate::report::run::RunReport;

impl Destination {
    /// Writes `solution.csv` (a row per contact: r, u and the bound), `history.csv`, `summary.json` and, in a
    /// build with HDF5, `<name>.hdf5`: the problem in the layout of FCLIB with r, u (and v) as its solution, where
    /// the run converged. All of them appear, or none.
    ///
    /// # Errors
    /// When a file cannot be written, or a result is not finite.
    pub fn write_fclib(
        self,
        name: &str,
        document: &Document,
        outcome: &FclibOutcome,
        settings: &Settings,
    ) -> Result<RunReport, WriteError> {
        let begin = Instant::now();
        let mut files = OutputSet::new(self.directory)?;
        #[cfg(feature = "fclib")]
        files.stage(&format!("{name}.hdf5"), |out| {
            solved(document, outcome).write_hdf5(out)
        })?;
        files.stage("solution.csv", |out| {
            solution(&document.problem, outcome, out)
        })?;
        files.stage("history.csv", |out| {
            history::write([(1, &outcome.solution.records[..])], out)
        })?;
        let report = RunReport::of_fclib(document, outcome, settings)
            .named(name)
            .with_output(begin.elapsed().as_secs_f64());
        files.stage(SUMMARY, |out| summary::write(out, &report))?;
        files.commit()?;
        Ok(report)
    }
}

/// The problem with our solution. What did not converge is none: readers of the format cannot be told.
#[cfg(feature = "fclib")]
fn solved(document: &Document, outcome: &FclibOutcome) -> Document {
    let converged = outcome.solution.status.is_converged();
    Document {
        solution: converged.then(|| State {
            v: outcome.global_velocities.clone(),
            u: outcome.velocities.clone(),
            r: outcome.forces.clone(),
        }),
        ..document.clone()
    }
}

fn solution(
    problem: &FclibProblem,
    outcome: &FclibOutcome,
    out: &mut dyn Write,
) -> Result<(), WriteError> {
    let dimension = problem.dimension();
    let columns: &[&str] = match dimension {
        2 => &["contact", "r_n", "r_t", "u_n", "u_t", "bound"],
        _ => &[
            "contact", "r_n", "r_t1", "r_t2", "u_n", "u_t1", "u_t2", "bound",
        ],
    };
    let mut table = History::new(columns);
    let forces = outcome.forces.chunks(dimension);
    let contacts = forces.zip(outcome.velocities.chunks(dimension));
    for (contact, (r, u)) in contacts.enumerate() {
        let bound = match outcome.law {
            FclibLaw::Coulomb => problem.friction()[contact] * r[0],
            FclibLaw::Tresca { bound } => bound,
        };
        let mut row: Vec<Value> = vec![contact.into()];
        row.extend(r.iter().chain(u).map(|&value| Value::from(value)));
        row.push(bound.into());
        table.push(&row)?;
    }
    table.write(out)
}
