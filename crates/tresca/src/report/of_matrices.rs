//! The report of a problem that came as matrices.

use super::contact::{ContactReport, largest};
use super::run::{RunReport, Source, StepReport};
use tresca_system::matrices::{Note, Solution};

impl RunReport {
    /// Of matrices, or of the pure dual form.
    pub fn of_matrices(solution: &Solution) -> Self {
        let description = solution.description.as_ref();
        let step = of_solution(solution);
        let door = match description {
            Some(_) => Source::Matrices,
            None => Source::Dual,
        };
        Self {
            system: description.map(Into::into),
            times: solution.times.into(),
            notes: solution.notes.iter().map(Note::to_string).collect(),
            ..Self::new(door, &solution.settings, solution.status, vec![step])
        }
    }
}

/// The one step of a solve of matrices.
pub(super) fn of_solution(solution: &Solution) -> StepReport {
    StepReport {
        failure: solution.failure.clone(),
        contradiction: solution.contradiction.as_ref().map(Into::into),
        ..StepReport::new(
            solution.status,
            solution.figures,
            solution.states,
            contact(solution),
            solution.certificate.clone(),
        )
    }
}

fn contact(solution: &Solution) -> ContactReport {
    let count = |flags: &[bool]| flags.iter().filter(|flag| **flag).count();
    let pairs = solution.normal_force.len();
    let (closed, stick) = (count(&solution.closed), count(&solution.stick));
    ContactReport {
        pairs,
        closed,
        open: pairs - closed,
        stick,
        slip: pairs - stick,
        held: solution.description.as_ref().map(|own| own.held_pairs),
        normal_force_sum: solution.normal_force.iter().sum(),
        max_slip_component: Some(largest(solution.slip.iter().map(|slip| slip.abs()))),
        max_gap: Some(largest(solution.gap.iter().copied())),
        ..ContactReport::default()
    }
}
