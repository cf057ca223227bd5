//! Problems of others: FCLIB and the text files of Siconos, solved by the methods of this project.
//!
//! The file formats are those of [`tresca_io::fclib`]; here a problem becomes a
//! [`DualProblem`]. In the words of the file, u = W r + q with r the contact
//! forces; in ours, r(λ) = Aλ − b. So A is W and b is −q, up to the order: contact by contact in the
//! file, all normals before all tangents in λ. Friction opposes sliding in both, and u_T = −c r_T with
//! c ≥ 0 where a contact slips.
//!
//! Coulomb's law is taken as it is posed, nonassociated: a fixed point on the slip bounds μ r_N. With
//! [`Law::Tresca`] the bound is the same given force at all contacts.
//!
//! ```
//! use tresca::{Settings, fclib};
//! use fclib::{Law, LocalProblem, Matrix, Problem};
//!
//! // A block pressed down with 1 and pulled aside with 2: W = I, u without forces is q.
//! let identity = Matrix::new(3, 3, (0..3).map(|i| (i, i, 1.0)).collect())?;
//! let problem = Problem::Local(LocalProblem {
//!     dimension: 3,
//!     w: identity,
//!     q: vec![-1.0, 2.0, 0.0],
//!     friction: vec![0.5],
//! });
//! let outcome = fclib::solve(&problem, Law::Coulomb, &Settings::default(), &mut fclib::Silent)?;
//! assert!(outcome.solution.status.is_converged());
//! // It slides: friction reaches μ r_N = 0.5, and 1.5 of the velocity is left.
//! for (found, expected) in outcome.forces.iter().zip([1.0, -0.5, 0.0]) {
//!     assert!((found - expected).abs() < 1e-6);
//! }
//! assert!((outcome.velocities[1] - 1.5).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod export;
mod output;
mod reduced;
mod residual;

use std::time::Instant;

use tresca_qcqp::{CoulombBound, DualProblem, Observer, ProductSet, Settings, Solution};

pub use tresca_qcqp::Silent;

pub use error::ProblemError;
pub use export::{document, local_problem};
pub use output::{Reference, Summary, Times, write};
pub use reduced::MatrixFacts;
pub use residual::Residuals;
pub use tresca_io::fclib::{
    Defect, Document, FclibError, FclibFault, GlobalProblem, Info, LocalProblem, Matrix, Problem,
    State, read,
};

use reduced::{Reduced, place};

/// The law of friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// As the file poses it: ‖r_T‖ ≤ μ r_N.
    Coulomb,
    /// ‖r_T‖ ≤ bound at every contact.
    Tresca {
        /// The slip bound, a force ≥ 0.
        bound: f64,
    },
}

/// A problem solved. Vectors stand in the order of the file: contact by contact, normal first.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The law it was solved with.
    pub law: Law,
    /// How the method ended, and what it did; its vectors are in the solver's own order.
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
    /// Seconds to reduce the problem to its contacts and to look at W.
    pub preparation: f64,
    /// Seconds of the solve.
    pub solve: f64,
}

/// Solves a problem.
///
/// # Errors
/// When the parts of the problem do not fit together, W or M is not symmetric, M is not positive
/// definite, there are more contacts than a dense W allows, or a setting or the slip bound is out of range. How the solve ended is no error:
/// see [`Outcome::solution`].
pub fn solve(
    problem: &Problem,
    law: Law,
    settings: &Settings,
    observer: &mut dyn Observer,
) -> Result<Outcome, ProblemError> {
    if let Law::Tresca { bound } = law
        && !(bound >= 0.0 && bound.is_finite())
    {
        return Err(ProblemError::Bound(bound));
    }
    let begin = Instant::now();
    let reduced = Reduced::new(problem)?;
    let mut dual = dual_problem(problem, &reduced, law)?;
    let preparation = begin.elapsed().as_secs_f64();

    let begin = Instant::now();
    let solution = tresca_qcqp::solve(&mut dual, settings, None, observer)?;
    let seconds = begin.elapsed().as_secs_f64();

    let mut forces = vec![0.0; solution.lambda.len()];
    for (i, &force) in solution.lambda.iter().enumerate() {
        forces[place(problem.dimension(), problem.contacts(), i)] = force;
    }
    let (velocities, global_velocities) = reduced.velocities(problem, &forces);
    Ok(Outcome {
        law,
        residuals: Residuals::new(problem, law, &reduced, &forces, &velocities),
        matrix: reduced.facts,
        solution,
        forces,
        velocities,
        global_velocities,
        preparation,
        solve: seconds,
    })
}

fn dual_problem(
    problem: &Problem,
    reduced: &Reduced,
    law: Law,
) -> Result<DualProblem<'static>, ProblemError> {
    let contacts = problem.contacts();
    let bound = match law {
        Law::Coulomb => 0.0,
        Law::Tresca { bound } => bound,
    };
    let bounds = vec![bound; contacts];
    let set = match problem.dimension() {
        2 => ProductSet::contact_2d(&bounds),
        _ => ProductSet::contact_3d(&bounds),
    }?;
    let place = |i| place(problem.dimension(), contacts, i);
    let rhs = (0..problem.unknowns()).map(|i| -reduced.q[place(i)]);
    let dual = DualProblem::new(reduced.operator(problem), rhs.collect(), set)?;
    let coulomb = match law {
        Law::Tresca { .. } => Vec::new(),
        Law::Coulomb => problem
            .friction()
            .iter()
            .enumerate()
            .map(|(contact, &coefficient)| CoulombBound {
                block: contacts + contact,
                normal: contact,
                coefficient,
                limit: f64::INFINITY,
            })
            .collect(),
    };
    Ok(dual.with_coulomb(coulomb)?)
}
