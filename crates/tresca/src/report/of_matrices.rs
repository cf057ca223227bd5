//! The report of a problem that came as matrices.

use tresca_qcqp::StateCounts;

use super::contact::{ContactReport, largest};
use super::figures::Figures;
use super::run::{RunReport, Source, StepReport};
use crate::algebraic::{Note, Solution};

impl RunReport {
    /// Of matrices, or of the pure dual form.
    pub fn of_matrices(solution: &Solution) -> Self {
        let description = solution.description.as_ref();
        let step = StepReport {
            certificate: Some(solution.certificate.clone()),
            ..StepReport::new(solution.status, solution.into(), contact(solution))
        };
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

impl From<&Solution> for Figures {
    fn from(solution: &Solution) -> Self {
        Self {
            iterations: solution.iterations,
            n_a: solution.n_a,
            n_a_setup: solution.n_a_setup,
            sigma_max: solution.sigma_max,
            relative_reduced_gradient: solution.relative_reduced_gradient,
            equality_residual: solution.equality_residual,
            outer_iterations: solution.outer_iterations,
            outer_residual: solution.outer_residual,
            dual_objective: solution.dual_objective,
            counts: counts(solution),
        }
    }
}

/// Pairs by their states.
fn counts(solution: &Solution) -> StateCounts {
    let count = |flags: &[bool]| flags.iter().filter(|flag| **flag).count();
    let pairs = solution.normal_force.len();
    let (closed, stick) = (count(&solution.closed), count(&solution.stick));
    StateCounts {
        open: pairs - closed,
        closed,
        stick,
        slip: pairs - stick,
    }
}

fn contact(solution: &Solution) -> ContactReport {
    let counts = counts(solution);
    ContactReport {
        pairs: solution.normal_force.len(),
        closed: counts.closed,
        open: counts.open,
        stick: counts.stick,
        slip: counts.slip,
        held: solution.description.as_ref().map(|own| own.held_pairs),
        normal_force_sum: solution.normal_force.iter().sum(),
        max_slip_component: Some(largest(solution.slip.iter().map(|slip| slip.abs()))),
        max_gap: Some(largest(solution.gap.iter().copied())),
        ..ContactReport::default()
    }
}
