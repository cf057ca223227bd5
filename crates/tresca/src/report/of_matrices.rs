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
    let pairs = solution.normal_force.len();
    let tangents = solution.tangential_force.len() / pairs.max(1);
    let count = |test: &dyn Fn(usize) -> bool| (0..pairs).filter(|&pair| test(pair)).count();
    let (closed, stick) = (&solution.closed, &solution.stick);
    let has_friction = |pair: usize| {
        let own = &solution.tangential_force[tangents * pair..tangents * (pair + 1)];
        own.iter().any(|&force| force != 0.0)
    };
    ContactReport {
        pairs,
        closed: count(&|pair| closed[pair]),
        open: count(&|pair| !closed[pair]),
        open_with_friction: count(&|pair| !closed[pair] && has_friction(pair)),
        stick: count(&|pair| closed[pair] && stick[pair]),
        slip: count(&|pair| closed[pair] && !stick[pair]),
        held: solution.description.as_ref().map(|own| own.held_pairs),
        normal_force_sum: solution.normal_force.iter().sum(),
        max_slip_component: Some(largest(solution.slip.iter().map(|slip| slip.abs()))),
        max_gap: Some(largest(solution.gap.iter().copied())),
        ..ContactReport::default()
    }
}
