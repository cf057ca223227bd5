//! The fixed point iteration: problems with frozen bounds, one after another.

use super::frictional::{Bounded, Frictional, first_multiplier};
use super::history::History;
use super::law::{CoulombBound, CoulombLaw, relative_change};
use crate::equality::attainable::AttainableForces;
use crate::equality::{first_guess as rigid, multiplier};
use crate::inner_problem::Ending;
use crate::session::Session;
use crate::sets::product::ProductSet;
use crate::start::Start;
use crate::status::Status;

/// A bound that nothing reaches: everything sticks.
const STICK: f64 = 1e300;
/// Tolerance of the first frozen problem, and the part of the outer residual (as it is expected to
/// be) that the next one is solved to.
const FIRST_TOLERANCE: f64 = 1e-3;
const TOLERANCE_RATIO: f64 = 0.03;
/// A pair is said to slip when its friction is this close to the bound.
const SLIPS: f64 = 1.0 - 1e-6;
/// Times that frozen bounds without an equilibrium are widened before there is said to be none.
const MAX_WIDENINGS: usize = 6;

/// λ_k for bounds g_k, g_{k+1} = g(λ_k). A, what is known of it, λ and its sets serve on.
pub(super) fn solve(session: &mut Session, problem: &Frictional, start: Option<Start>) -> Ending {
    let law = problem.law;
    let mut at = match first_guess(session, problem, start) {
        Ok(guess) => guess,
        Err(ending) => return *ending,
    };
    let mut history = History::default();
    let mut tolerance = FIRST_TOLERANCE.max(session.settings.tolerance);
    let mut previous: Option<Ending> = None;
    let mut widenings = 0;
    let mut outer = 0;
    loop {
        outer += 1;
        let bounded = Bounded {
            problem,
            set: &at.set,
            law: None,
            tolerance,
        };
        let mut ending = bounded.solve(session, at.lambda.as_deref(), &at.multiplier);
        ending.outer_iterations = outer;
        if ending.status == Status::NoEquilibrium && widenings < MAX_WIDENINGS {
            // Too little friction on the way need not be too little at the end.
            widenings += 1;
            match &previous {
                Some(last) => widen(law, &mut at.set, last, widenings),
                None => at = Guess::sticking(problem),
            }
            continue;
        }
        if ending.status == Status::NoEquilibrium {
            // That these bounds cannot hold the load proves nothing for others: the friction cones can, as
            // far as statics told before the first problem.
            ending.status = Status::CoulombDiverges;
            ending.motion = None;
        }
        let bounds = law.bounds(&ending.point.lambda);
        ending.outer_residual = residual(law, &ending, previous.as_ref());
        if !ending.status.is_converged() {
            return ending;
        }
        let settled = ending.outer_residual <= session.settings.coulomb_tolerance;
        if settled && tolerance <= session.settings.tolerance {
            return ending;
        }
        if session.journal.stop {
            ending.status = Status::Interrupted;
            return ending;
        }
        let verdict = history.note(bounds.clone(), ending.outer_residual);
        if let Some(status) = verdict.filter(|_| !settled) {
            ending.status = status;
            return ending;
        }
        if outer >= session.settings.max_outer_iterations {
            ending.status = Status::IterationLimit;
            return ending;
        }
        tolerance = next_tolerance(session, tolerance, &ending, previous.as_ref());
        at = Guess::after(law, &ending, &bounds);
        previous = Some(ending);
        widenings = 0;
    }
}

/// Where a frozen problem starts: its bounds, λ and β.
struct Guess {
    set: ProductSet,
    lambda: Option<Vec<f64>>,
    multiplier: Vec<f64>,
}

impl Guess {
    /// The bounds that follow from the last frozen problem, and λ for them.
    fn after(law: &CoulombLaw, ending: &Ending, bounds: &[f64]) -> Self {
        let mut set = ending.set.clone();
        let lambda = scaled(law, &mut set, &ending.point.lambda, bounds);
        Self {
            set,
            lambda: Some(lambda),
            multiplier: ending.multiplier.clone(),
        }
    }

    /// Everything sticks: if this has no equilibrium, nothing has.
    fn sticking(problem: &Frictional) -> Self {
        let mut set = problem.set.clone();
        let bounds = vec![STICK; problem.law.bounds_of_blocks().len()];
        problem.law.bound(&mut set, &bounds);
        Self {
            set,
            lambda: None,
            multiplier: Vec::new(),
        }
    }
}

/// The first frozen problem: that of the start when there is one. Else without friction, whose
/// normal forces are a good guess already (sticking costs half as much again); but floating bodies
/// may need friction to be held at all, and land in their friction cones instead. An end when
/// no friction cone can hold the load, whatever the bounds.
fn first_guess(
    session: &mut Session,
    problem: &Frictional,
    start: Option<Start>,
) -> Result<Guess, Box<Ending>> {
    let Frictional { rhs, law, .. } = *problem;
    let mut set = problem.set.clone();
    let mut beta = first_multiplier(problem, start);
    let mut lambda = start.map(|start| start.lambda.to_vec());
    let mut bounds = vec![0.0; law.bounds_of_blocks().len()];
    if let Some(balance) = problem.balance {
        let impossible = multiplier::without_equilibrium(session, rhs, &set, Some(law), balance);
        if let Some(ending) = impossible {
            return Err(Box::new(ending));
        }
        if start.is_none() {
            let cones = AttainableForces::new(&set, Some(law));
            let (motion, landed) = rigid::guess(session, rhs, balance, &cones);
            bounds = law.bounds(&landed);
            beta = motion;
            lambda = Some(landed);
        }
    }
    if start.is_none() {
        law.bound(&mut set, &bounds);
    }
    Ok(Guess {
        set,
        lambda,
        multiplier: beta,
    })
}

/// The change of the bounds, and of λ since the last outer iteration.
fn residual(law: &CoulombLaw, ending: &Ending, previous: Option<&Ending>) -> f64 {
    let bounds = law.change(&ending.set, &ending.point.lambda);
    let forces = previous.map_or(0.0, |last| {
        relative_change(&ending.point.lambda, &last.point.lambda)
    });
    bounds.max(forces)
}

/// The tolerance of the next frozen problem, which never rises again.
fn next_tolerance(
    session: &Session,
    tolerance: f64,
    ending: &Ending,
    previous: Option<&Ending>,
) -> f64 {
    let settings = session.settings;
    let rate = previous.map_or(1.0, |last| ending.outer_residual / last.outer_residual);
    let expected = ending.outer_residual * rate.min(1.0);
    // The last one has to be solved to the end.
    if expected <= settings.coulomb_tolerance {
        return settings.tolerance;
    }
    (TOLERANCE_RATIO * expected).clamp(settings.tolerance, tolerance)
}

/// Gives the set the new bounds, and λ for them: pairs that slip stay on their boundary, so that
/// the active set stays.
fn scaled(law: &CoulombLaw, set: &mut ProductSet, lambda: &[f64], bounds: &[f64]) -> Vec<f64> {
    let old = law.present(set);
    law.bound(set, bounds);
    let mut lambda = lambda.to_vec();
    for ((own, old), new) in law.bounds_of_blocks().iter().zip(old).zip(bounds) {
        let friction = &mut lambda[set.blocks()[own.block].range()];
        let size = friction.iter().map(|f| f * f).sum::<f64>().sqrt();
        if old > 0.0 && size >= SLIPS * old {
            friction.iter_mut().for_each(|f| *f *= new / old);
        }
    }
    lambda
}

/// Bounds between those that follow from the last λ, which cannot hold the load, and those that
/// this λ itself needs, which can: the more of the latter, the more often it was tried.
fn widen(law: &CoulombLaw, set: &mut ProductSet, last: &Ending, times: usize) {
    let share = 1.0 - 0.5_f64.powi(times as i32);
    let follows = law.bounds(&last.point.lambda);
    let needed = |(own, follows): (&CoulombBound, f64)| {
        let friction = &last.point.lambda[last.set.blocks()[own.block].range()];
        let size = friction.iter().map(|f| f * f).sum::<f64>().sqrt();
        follows + share * (size - follows).max(0.0)
    };
    let bounds: Vec<f64> = law
        .bounds_of_blocks()
        .iter()
        .zip(follows)
        .map(needed)
        .collect();
    law.bound(set, &bounds);
}
