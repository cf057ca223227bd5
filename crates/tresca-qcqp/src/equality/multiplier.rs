//! The outer iteration over the multiplier.

use super::attainable::AttainableForces;
use super::balance::Balance;
use super::compliance::compliance;
use super::dual_ascent::{DualAscent, Station};
use super::equilibrium::{self, Equilibrium};
use super::first_guess;
use crate::coulomb::law::CoulombLaw;
use crate::inner_problem::{Ending, Inner};
use crate::inner_solve;
use crate::point::{Point, relative};
use crate::session::Session;
use crate::sets::product::ProductSet;
use crate::status::Status;
use tresca_la::vector::dot;

/// Tolerance of the first inner problem, and the part of the outer residual that the next one is
/// solved to.
const FIRST_TOLERANCE: f64 = 1e-2;
const TOLERANCE_RATIO: f64 = 0.01;
/// Relative residual of the systems for H: each step gains about as much, at little cost.
const RESPONSE_ACCURACY: f64 = 3e-2;
/// Where a step gains less than this factor, both become finer by [`CARE`] for good: H is then so
/// ill-conditioned that what is neglected otherwise counts.
const SLOW: f64 = 0.3;
const CARE: f64 = 0.1;
const MOST_CARE: f64 = 1e-4;
/// Motions so many times what the loads do to the bodies themselves are no answer without a second look.
const FAR: f64 = 1e6;

/// Weight of the residual that is measured in forces: a tenth of it is asked for.
const FORCES: f64 = 0.1;
/// Forces that balance to this are known well enough, whatever the tolerance.
const KNOWN: f64 = 1e-9;

/// The factor by which inner tolerances become finer than the one asked for where forces need it, and the least one.
const FINER: f64 = 0.1;
const FINEST: f64 = 1e-14;

/// The problem to solve: min q over { λ ∈ Λ : G̃λ = ẽ }.
#[derive(Clone, Copy)]
pub(crate) struct Balanced<'a> {
    pub rhs: &'a [f64],
    pub set: &'a ProductSet,
    pub law: Option<&'a CoulombLaw>,
    pub balance: &'a Balance,
    /// On the reduced gradient and on the residual of the constraint.
    pub tolerance: f64,
}

/// Solves it from λ and β; α of the ending is still in scaled coordinates.
pub(crate) fn solve(
    session: &mut Session,
    problem: &Balanced,
    start: Option<&[f64]>,
    multiplier: &[f64],
) -> Ending {
    let Balanced {
        rhs,
        set,
        law,
        balance,
        ..
    } = *problem;
    if let Some(ending) = without_equilibrium(session, rhs, set, law, balance) {
        return ending;
    }
    let mut ending = ascend(session, problem, start, multiplier);
    if doubtful(balance, &ending) {
        let anew =
            ending_without_equilibrium(session, rhs, set, law, balance, equilibrium::find_anew);
        if let Some(anew) = anew {
            return anew;
        }
        if !ending.status.is_converged() {
            let reach = AttainableForces::new(set, law);
            ending.statics = Some(equilibrium::statics(
                &balance.with_diagonal_metric(),
                &reach,
            ));
        }
    }
    ending
}

/// Whether an end makes one ask once more if there is an equilibrium.
fn doubtful(balance: &Balance, ending: &Ending) -> bool {
    match ending.status {
        Status::IterationLimit | Status::Stagnated | Status::Diverged => true,
        Status::Converged => balance.spread(&ending.multiplier) > FAR * ending.reference,
        _ => false,
    }
}

/// The ascent to the multiplier.
fn ascend(
    session: &mut Session,
    problem: &Balanced,
    start: Option<&[f64]>,
    multiplier: &[f64],
) -> Ending {
    let Balanced { balance, law, .. } = *problem;
    let least_reference = balance.spread(&balance.load);
    let mut ascent = DualAscent::new();
    let mut set = problem.set.clone();
    let (mut beta, mut lambda) = match start {
        Some(start) => (multiplier.to_vec(), Some(start.to_vec())),
        None => {
            let reach = AttainableForces::new(&set, law);
            let (beta, lambda) = first_guess::guess(session, problem.rhs, balance, &reach);
            if let Some(law) = law {
                law.bound(&mut set, &law.bounds(&lambda));
            }
            (beta, Some(lambda))
        }
    };
    let mut tolerance = FIRST_TOLERANCE.max(problem.tolerance);
    let (mut last_residual, mut care) = (f64::INFINITY, 1.0);
    let mut updates = 0;
    let mut finest = problem.tolerance;
    loop {
        let mut rhs = problem.rhs.to_vec();
        balance.add_transposed(&beta, &mut rhs);
        let inner = Inner {
            rhs: &rhs,
            own_rhs: problem.rhs,
            least_reference,
            set: &set,
            law,
            tolerance,
        };
        let mut ending = inner_solve::solve(session, &inner, lambda.as_deref());
        let shortfall = balance.shortfall(&ending.point.lambda);
        // As a displacement, like gradients, and as a force: where soft motions govern the reference, a small part of
        // it is a large part of the load.
        let forces = balance.relative_shortfall(&shortfall, &ending.point.lambda);
        let moved = relative(balance.spread(&shortfall), ending.reference);
        let residual = if forces > KNOWN {
            moved.max(FORCES * forces)
        } else {
            moved
        };
        let value = ending.objective + dot(&beta, &balance.load);
        // q itself, and the multiplier that the caller may use.
        ending.objective += dot(&beta, &applied(balance, &ending.point));
        ending.multiplier = beta.clone();
        ending.equality_residual = residual;
        ending.outer_iterations = updates + 1;
        let balanced = residual <= problem.tolerance;
        if !ending.status.is_converged() || balanced && tolerance <= problem.tolerance {
            return ending;
        }
        if session.journal.stop {
            ending.status = Status::Interrupted;
            return ending;
        }
        if balanced {
            tolerance = problem.tolerance;
            lambda = Some(ending.point.lambda);
            set = ending.set;
            continue;
        }
        updates += 1;
        if updates >= session.settings.max_outer_iterations {
            ending.status = Status::IterationLimit;
            return ending;
        }
        if residual > SLOW * last_residual {
            care = f64::max(CARE * care, MOST_CARE);
            if moved <= problem.tolerance {
                // Only the forces are off: λ has to be known better than gradients of this reference say.
                finest = f64::max(FINER * finest, FINEST);
            }
        }
        last_residual = residual;
        let station = Station {
            beta,
            lambda: ending.point.lambda.clone(),
            shortfall,
            value: law.is_none().then_some(value),
        };
        let (next, expected) = ascent.next(station, || {
            compliance(session, &ending, &balance.rows, care * RESPONSE_ACCURACY)
        });
        (beta, lambda) = (next, Some(expected));
        set = ending.set;
        tolerance =
            (care * TOLERANCE_RATIO * moved).clamp(finest, FIRST_TOLERANCE.max(problem.tolerance));
    }
}

/// G̃λ.
fn applied(balance: &Balance, point: &Point) -> Vec<f64> {
    balance
        .rows
        .iter()
        .map(|row| dot(row, &point.lambda))
        .collect()
}

/// The end of a problem whose load no force in reach can balance, at the λ that comes nearest;
/// with a law its bounds are those that belong to this λ.
pub(crate) fn without_equilibrium(
    session: &mut Session,
    rhs: &[f64],
    set: &ProductSet,
    law: Option<&CoulombLaw>,
    balance: &Balance,
) -> Option<Ending> {
    ending_without_equilibrium(session, rhs, set, law, balance, equilibrium::find)
}

/// The same, by the way that is given to look for an equilibrium.
fn ending_without_equilibrium(
    session: &mut Session,
    rhs: &[f64],
    set: &ProductSet,
    law: Option<&CoulombLaw>,
    balance: &Balance,
    find: impl Fn(&Balance, &AttainableForces) -> Equilibrium,
) -> Option<Ending> {
    let reach = AttainableForces::new(set, law);
    // Nearest with respect to the diagonal of S: a push along one motion is then answered by that
    // motion, where S itself, which knows where the grounding sits, would mix in others.
    let diagonal = balance.with_diagonal_metric();
    let Equilibrium::Impossible { motion, lambda } = find(&diagonal, &reach) else {
        return None;
    };
    let mut motion = motion;
    let mut set = set.clone();
    if let Some(law) = law {
        law.bound(&mut set, &law.bounds(&lambda));
        // A proof over friction cones moves along their surface, opening as it slides; with the bounds
        // of the nearest λ it slides.
        let frozen = equilibrium::find(&diagonal, &AttainableForces::new(&set, None));
        if let Equilibrium::Impossible { motion: slide, .. } = frozen {
            motion = slide;
        }
    }
    let motion = balance.coordinates(&diagonal.motion(&motion));
    let mut ending = session.evaluate(rhs, &set, lambda);
    let shortfall = balance.shortfall(&ending.point.lambda);
    let reference = ending.reference.max(balance.spread(&balance.load));
    ending.status = Status::NoEquilibrium;
    ending.multiplier = vec![0.0; motion.len()];
    ending.equality_residual = relative(balance.spread(&shortfall), reference);
    ending.motion = Some(motion);
    Some(ending)
}
