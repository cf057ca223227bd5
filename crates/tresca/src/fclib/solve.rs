//! A problem solved by the dual form.

use std::time::Instant;

use tresca_io::fclib::FclibProblem;
use tresca_qcqp::Settings;
use tresca_system::matrices::{self, Dual, Operator, PairLaw, Solution};
use tresca_system::progress::Progress;

use super::error::FclibProblemError;
use super::law::FclibLaw;
use super::reduced::{MatrixFacts, Reduced, place};
use super::residual::Residuals;

/// A problem solved. Vectors stand in the order of the file: contact by contact, normal first.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct FclibOutcome {
    /// The law it was solved with.
    pub law: FclibLaw,
    /// How the method ended and what it did, with the certificate of the dual form; its vectors are in the
    /// order of [`Dual`]. `times.assembly` is the reduction to the contacts and a look at W.
    pub solution: Solution,
    /// r.
    pub forces: Vec<f64>,
    /// u = W r + q, or Hᵀ v + w, computed from r and the matrices as they stand in the file.
    pub velocities: Vec<f64>,
    /// v with M v = H r + f; of global problems alone.
    pub global_velocities: Option<Vec<f64>>,
    /// How far r and u are from solving the problem, computed without the solver.
    pub residuals: Residuals,
    /// What W is like.
    pub matrix: MatrixFacts,
}

/// Solves a problem.
///
/// # Errors
/// When the parts of the problem do not fit together, W or M is not symmetric, M is not positive
/// definite, there are more contacts than a dense W allows, a setting or the slip bound is out of range, or
/// `progress` stops the run before its first iteration. How the solve ended is no error: see
/// [`FclibOutcome::solution`].
pub fn solve(
    problem: &FclibProblem,
    law: FclibLaw,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<FclibOutcome, FclibProblemError> {
    if let FclibLaw::Tresca { bound } = law
        && !(bound >= 0.0 && bound.is_finite())
    {
        return Err(FclibProblemError::Bound(bound));
    }
    let begin = Instant::now();
    let reduced = Reduced::new(problem)?;
    let laws: Vec<PairLaw> = problem
        .friction()
        .iter()
        .map(|&coefficient| match law {
            FclibLaw::Coulomb => PairLaw::coulomb(coefficient),
            FclibLaw::Tresca { bound } => PairLaw::tresca(bound),
        })
        .collect();
    let dual = Dual::new(
        Operator::dense(problem.unknowns(), &reduced.w)?,
        reduced.q.iter().map(|q| -q).collect(),
        problem.dimension() - 1,
        laws,
    );
    let preparation = begin.elapsed().as_secs_f64();
    let mut solution = matrices::solve_dual(dual, settings, progress)?;
    solution.times.assembly += preparation;

    let place = |i| place(problem.dimension(), problem.contacts(), i);
    let mut forces = vec![0.0; problem.unknowns()];
    let found = solution
        .normal_force
        .iter()
        .chain(&solution.tangential_force);
    for (i, &force) in found.enumerate() {
        forces[place(i)] = force;
    }
    let (velocities, global_velocities) = reduced.velocities(problem, &forces);
    Ok(FclibOutcome {
        law,
        residuals: Residuals::new(problem, law, &reduced, &forces, &velocities),
        matrix: reduced.facts,
        solution,
        forces,
        velocities,
        global_velocities,
    })
}
