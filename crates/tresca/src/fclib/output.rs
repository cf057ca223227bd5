//! The result files of a problem from a file.

use std::path::Path;

use serde::Serialize;
use tresca_io::atomic::OutputSet;
#[cfg(feature = "fclib")]
use tresca_io::fclib::State;
use tresca_io::fclib::{Document, Problem};
use tresca_io::history::{History, Value};
use tresca_io::{WriteError, summary};
use tresca_la::vector::norm;
use tresca_qcqp::{Figures, Settings, StateCounts, Status};

use super::{Law, MatrixFacts, Outcome, Residuals};
use crate::VERSION;
use crate::output::history_table;

/// Asymmetry that is not worth a remark.
const ROUNDING: f64 = 1e-14;

/// `summary.json`.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// Name of the run: of the file, without its extension.
    pub name: String,
    /// Title of the problem, where its author gave one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// `local` or `global`.
    pub problem: &'static str,
    /// 2 or 3.
    pub dimension: usize,
    /// Number of contacts.
    pub contacts: usize,
    /// Number of velocities v of a global problem.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocities: Option<usize>,
    /// The law of friction.
    pub law: LawSummary,
    /// Version of tresca.
    pub version: &'static str,
    /// How the run ended.
    pub status: Status,
    /// The method.
    pub method: &'static str,
    /// Iterations, multiplications by W, residuals, and the objective ½ rᵀWr + qᵀr.
    #[serde(flatten)]
    pub figures: Figures,
    /// Contacts by their states.
    pub states: StateCounts,
    /// What W is like.
    pub matrix: MatrixFacts,
    /// Distances to a solution, computed without the solver.
    pub residuals: Residuals,
    /// Differences to the solution that came with the problem.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference: Option<Reference>,
    /// What to keep in mind when using the result.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
    /// Seconds.
    pub times: Times,
    /// All settings, resolved.
    pub settings: Settings,
}

/// A law and its parameter.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct LawSummary {
    /// `coulomb` or `tresca`.
    pub name: &'static str,
    /// The slip bound of Tresca's law, a force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<f64>,
}

/// ‖ours − theirs‖/‖theirs‖.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Reference {
    /// Of r.
    pub forces: f64,
    /// Of u.
    pub velocities: f64,
}

/// Wall-clock seconds.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Times {
    /// Reduction to the contacts, eigenvalues of W.
    pub preparation: f64,
    /// The solve.
    pub solve: f64,
    /// Multiplications by W, a part of the solve.
    pub multiplications: f64,
}

impl Summary {
    /// Summarises an outcome.
    pub fn new(name: &str, document: &Document, outcome: &Outcome, settings: &Settings) -> Self {
        let Document { problem, info, .. } = document;
        let solution = &outcome.solution;
        let theirs = document.solution.as_ref();
        // With another law the solution of the file solves another problem.
        let theirs = theirs.filter(|_| outcome.law == Law::Coulomb);
        Self {
            name: name.to_owned(),
            title: info.title.clone(),
            problem: match problem {
                Problem::Local(_) => "local",
                Problem::Global(_) => "global",
            },
            dimension: problem.dimension(),
            contacts: problem.contacts(),
            velocities: problem.velocities(),
            law: match outcome.law {
                Law::Coulomb => LawSummary {
                    name: "coulomb",
                    bound: None,
                },
                Law::Tresca { bound } => LawSummary {
                    name: "tresca",
                    bound: Some(bound),
                },
            },
            version: VERSION,
            status: solution.status,
            method: solution.settings.method.name(),
            figures: solution.figures,
            states: solution.states,
            matrix: outcome.matrix,
            residuals: outcome.residuals,
            reference: theirs.map(|state| Reference {
                forces: difference(&outcome.forces, &state.r),
                velocities: difference(&outcome.velocities, &state.u),
            }),
            remarks: remarks(outcome),
            times: Times {
                preparation: solution.times.assembly,
                solve: solution.times.solve,
                multiplications: solution.times.multiplications,
            },
            settings: settings.clone(),
        }
    }
}

/// Writes `solution.csv` (a row per contact: r, u and the bound), `history.csv`, `summary.json` and, in
/// a build with HDF5, `<name>.hdf5`: the problem in the layout of FCLIB with r, u (and v) as its
/// solution. All of them appear, or none.
///
/// # Errors
/// When a file cannot be written, or a result is not finite.
pub fn write(
    directory: &Path,
    name: &str,
    document: &Document,
    outcome: &Outcome,
    settings: &Settings,
) -> Result<Summary, WriteError> {
    let result = Summary::new(name, document, outcome, settings);
    let mut files = OutputSet::new(directory)?;
    #[cfg(feature = "fclib")]
    stage_hdf5(&mut files, name, document, outcome)?;
    files.stage("solution.csv", |out| {
        solution(&document.problem, outcome)?.write(out)
    })?;
    files.stage("history.csv", |out| {
        history_table([(1, &outcome.solution.records[..])])?.write(out)
    })?;
    files.stage("summary.json", |out| summary::write(out, &result))?;
    files.commit()?;
    Ok(result)
}

#[cfg(feature = "fclib")]
fn stage_hdf5(
    files: &mut OutputSet,
    name: &str,
    document: &Document,
    outcome: &Outcome,
) -> Result<(), WriteError> {
    let solved = Document {
        solution: Some(State {
            v: outcome.global_velocities.clone(),
            u: outcome.velocities.clone(),
            r: outcome.forces.clone(),
        }),
        ..document.clone()
    };
    files.stage(&format!("{name}.hdf5"), |out| solved.write_hdf5(out))
}

fn solution(problem: &Problem, outcome: &Outcome) -> Result<History, WriteError> {
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
            Law::Coulomb => problem.friction()[contact] * r[0],
            Law::Tresca { bound } => bound,
        };
        let mut row: Vec<Value> = vec![contact.into()];
        row.extend(r.iter().chain(u).map(|&value| Value::from(value)));
        row.push(bound.into());
        table.push(&row)?;
    }
    Ok(table)
}

fn remarks(outcome: &Outcome) -> Vec<String> {
    let facts = &outcome.matrix;
    let mut remarks = Vec::new();
    if let (true, Some(rank)) = (facts.is_singular(), facts.rank) {
        remarks.push(format!(
            "W is singular (rank {rank} of {}): under given slip bounds velocities and objective are \
             unique, contact forces need not be",
            facts.unknowns
        ));
    }
    if let (Some(smallest), Some(largest)) = (facts.smallest_eigenvalue, facts.largest_eigenvalue)
        && smallest < -1e-12 * facts.unknowns as f64 * largest
    {
        remarks.push(format!(
            "W is not positive semidefinite: its eigenvalues reach from {smallest:.1e} to {largest:.1e}"
        ));
    }
    if facts.asymmetry > ROUNDING {
        remarks.push(format!(
            "W is symmetric up to {:.1e} of its largest entry; solved with its symmetric part",
            facts.asymmetry
        ));
    }
    remarks
}

/// ‖a − b‖/‖b‖, or ‖a − b‖ where b = 0.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let gap: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    match norm(b) {
        0.0 => norm(&gap),
        size => norm(&gap) / size,
    }
}
