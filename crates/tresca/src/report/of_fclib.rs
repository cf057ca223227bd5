//! The report of a problem of FCLIB or Siconos.

use tresca_io::fclib::{Document, FclibProblem};
use tresca_la::vector::norm;
use tresca_qcqp::Settings;

use super::of_matrices::of_solution;
use super::posed::{FclibReport, LawReport, Reference};
use super::run::{RunReport, Source, StepReport};
use crate::fclib::law::FclibLaw;
use crate::fclib::reduced::MatrixFacts;
use crate::fclib::solve::FclibOutcome;

/// Asymmetry that is not worth a note.
const ROUNDING: f64 = 1e-14;

impl RunReport {
    /// Of a problem of FCLIB or Siconos.
    pub fn of_fclib(document: &Document, outcome: &FclibOutcome, settings: &Settings) -> Self {
        let Document { problem, info, .. } = document;
        let solution = &outcome.solution;
        // With another law the solution of the file solves another problem.
        let theirs = document.solution.as_ref();
        let theirs = theirs.filter(|_| outcome.law == FclibLaw::Coulomb);
        let step = StepReport {
            residuals: Some(outcome.residuals),
            matrix: Some(outcome.matrix),
            reference: theirs.map(|state| Reference {
                forces: difference(&outcome.forces, &state.r),
                velocities: difference(&outcome.velocities, &state.u),
            }),
            ..of_solution(solution)
        };
        Self {
            title: info.title.clone(),
            fclib: Some(posed(problem, outcome.law)),
            times: solution.times.into(),
            notes: notes(&outcome.matrix),
            ..Self::new(Source::Fclib, settings, solution.status, vec![step])
        }
    }
}

fn posed(problem: &FclibProblem, law: FclibLaw) -> FclibReport {
    FclibReport {
        problem: match problem {
            FclibProblem::Local(_) => "local",
            FclibProblem::Global(_) => "global",
        },
        dimension: problem.dimension(),
        contacts: problem.contacts(),
        velocities: problem.velocities(),
        law: match law {
            FclibLaw::Coulomb => LawReport {
                name: "coulomb",
                bound: None,
            },
            FclibLaw::Tresca { bound } => LawReport {
                name: "tresca",
                bound: Some(bound),
            },
        },
    }
}

fn notes(facts: &MatrixFacts) -> Vec<String> {
    let mut notes = Vec::new();
    if let (true, Some(rank)) = (facts.is_singular(), facts.rank) {
        notes.push(format!(
            "W is singular (rank {rank} of {}): under given slip bounds velocities and objective are \
             unique, contact forces need not be",
            facts.unknowns
        ));
    }
    if let (Some(smallest), Some(largest)) = (facts.smallest_eigenvalue, facts.largest_eigenvalue)
        && smallest < -1e-12 * facts.unknowns as f64 * largest
    {
        notes.push(format!(
            "W is not positive semidefinite: its eigenvalues reach from {smallest:.1e} to {largest:.1e}"
        ));
    }
    if facts.asymmetry > ROUNDING {
        notes.push(format!(
            "W is symmetric up to {:.1e} of its largest entry; solved with its symmetric part",
            facts.asymmetry
        ));
    }
    notes
}

/// ‖a − b‖/‖b‖, or ‖a − b‖ where b = 0.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let gap: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    match norm(b) {
        0.0 => norm(&gap),
        size => norm(&gap) / size,
    }
}
