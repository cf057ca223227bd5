//! The last resort: contact by contact.
//!
//! A sweep of Gauss and Seidel solves every contact exactly, one after another, with the others held. It knows no
//! bounds that lag behind their normal forces, and gets there where these two drive each other on for ever. Slowly: as soon as a Newton method takes over from where the
//! sweeps are, it does.

use super::exact;
use super::frictional::{Frictional, first_multiplier};
use super::in_loop;
use super::local::Local;
use crate::inner_problem::Ending;
use crate::point::{Point, point_at};
use crate::session::Session;
use crate::sets::block::{Block, BlockSet};
use crate::sets::convex_set::ConvexSet;
use crate::start::Start;
use crate::status::Status;
use tresca_la::SymmetricEntries;
use tresca_la::vector::{axpy, dot, norm};

/// Sweeps for each outer iteration that the settings allow, and the fewest of these with which there are any.
const SWEEPS_EACH: usize = 100;
const LEAST_OUTER: usize = 10;
/// Sweeps between looks at the residual.
const LOOK: usize = 10;
/// Up to here the exact Newton method is tried at every look: sweeps that return for ever pass by many points.
const OFTEN: usize = 300;
/// Sweeps after which the Newton loop of convex problems is offered what there is.
const HAND_OVER: [usize; 5] = [20, 100, 400, 1500, 4000];

/// A contact that a sweep solves at once.
struct Contact {
    /// Where its normal force is.
    normal: usize,
    /// Whether that is the contact's own to change.
    moves_normally: bool,
    /// Its tangential unknowns, one or two.
    friction: Vec<usize>,
    coefficient: f64,
    limit: f64,
}

/// Sweeps from the start, or from λ = 0; `None` where A has no entries to be had, or sweeps do not get there either. A sweep counts as a multiplication, and takes one more for a fresh gradient.
pub(super) fn solve(
    session: &mut Session,
    problem: &Frictional,
    start: Option<Start>,
) -> Option<Ending> {
    let outer = session.settings.max_outer_iterations;
    if outer < LEAST_OUTER || session.operator.explicit().is_none() {
        return None;
    }
    let (contacts, others) = parts(problem);
    let mut lambda = start.map_or_else(|| vec![0.0; problem.rhs.len()], |s| s.lambda.to_vec());
    problem.set.project(&mut lambda);
    let mut beta = first_multiplier(problem, start);
    let mut set = problem.set.clone();
    for sweep in 1..=SWEEPS_EACH.saturating_mul(outer) {
        let rhs = driven(problem, &beta);
        let mut point = point_at(&mut *session.operator, &rhs, lambda);
        let a = session.operator.explicit()?;
        for contact in &contacts {
            settle(a, contact, &mut point);
        }
        for block in &others {
            relax(a, block, &mut point);
        }
        session.operator.tally().count += 1;
        session.sweeps += 1;
        lambda = point.lambda;
        if let Some(balance) = problem.balance {
            // A holds G̃ᵀG̃: this is the step of the method of multipliers.
            axpy(1.0, &balance.shortfall(&lambda), &mut beta);
        }
        if !norm(&lambda).is_finite() {
            return None;
        }
        let hand_over = HAND_OVER.contains(&sweep);
        if !hand_over && !sweep.is_multiple_of(LOOK) {
            continue;
        }
        if let Some(ending) = solved(session, problem, lambda.clone(), beta.clone(), sweep) {
            return Some(ending);
        }
        let exactly = hand_over || sweep <= OFTEN;
        let found = exactly
            .then(|| exact::solve(&mut *session.operator, problem, &lambda, &beta))
            .flatten();
        let ending = found.and_then(|(lambda, beta)| solved(session, problem, lambda, beta, sweep));
        if ending.is_some() {
            return ending;
        }
        if hand_over {
            problem.law.bound(&mut set, &problem.law.bounds(&lambda));
            let motion = problem.balance.map_or_else(Vec::new, |b| b.motion(&beta));
            let from = Frictional {
                set: &set,
                ..*problem
            };
            let ending = {
                let start = Start {
                    lambda: &lambda,
                    multiplier: &motion,
                };
                in_loop::solve(session, &from, Some(start))
            };
            if ending.status.is_converged() {
                return Some(ending);
            }
        }
        if session.journal.stop {
            return None;
        }
    }
    None
}

/// The end at a λ, if that solves the problem.
fn solved(
    session: &mut Session,
    problem: &Frictional,
    lambda: Vec<f64>,
    beta: Vec<f64>,
    sweep: usize,
) -> Option<Ending> {
    let mut set = problem.set.clone();
    problem.law.bound(&mut set, &problem.law.bounds(&lambda));
    let mut ending = session.evaluate(&driven(problem, &beta), &set, lambda);
    if let Some(balance) = problem.balance {
        let lambda = &ending.point.lambda;
        ending.equality_residual = balance.relative_shortfall(&balance.shortfall(lambda), lambda);
        let applied = balance.rows.iter().map(|row| dot(row, lambda));
        ending.objective += applied.zip(&beta).map(|(x, b)| x * b).sum::<f64>();
    }
    ending.status = Status::Converged;
    ending.outer_iterations = sweep;
    ending.multiplier = beta;
    let residual = ending.relative.max(ending.equality_residual);
    (residual <= session.settings.tolerance).then_some(ending)
}

/// b + G̃ᵀβ.
fn driven(problem: &Frictional, beta: &[f64]) -> Vec<f64> {
    let mut rhs = problem.rhs.to_vec();
    if let Some(balance) = problem.balance {
        balance.add_transposed(beta, &mut rhs);
    }
    rhs
}

/// The contacts with friction by Coulomb, and the blocks that have nothing to do with them.
fn parts(problem: &Frictional) -> (Vec<Contact>, Vec<Block>) {
    let blocks = problem.set.blocks();
    let mut contacts: Vec<Contact> = Vec::new();
    let mut taken = vec![false; problem.set.dimension()];
    for bound in problem.law.bounds_of_blocks() {
        let friction = blocks[bound.block].range();
        let presses = blocks
            .iter()
            .any(|b| b.start == bound.normal && matches!(b.set, BlockSet::HalfLine(_)));
        // A normal force that a contact before has, or that may pull, is held while this friction is settled.
        let own = presses && !taken[bound.normal];
        friction.clone().for_each(|i| taken[i] = true);
        if own {
            taken[bound.normal] = true;
        }
        contacts.push(Contact {
            normal: bound.normal,
            moves_normally: own,
            friction: friction.collect(),
            coefficient: bound.coefficient,
            limit: bound.limit,
        });
    }
    let others = blocks.iter().filter(|b| !taken[b.start]).copied();
    (contacts, others.collect())
}

/// Solves one contact with the others held.
fn settle(a: &dyn SymmetricEntries, contact: &Contact, point: &mut Point) {
    let entry = |i: usize, j: usize| a.entry(i.max(j), i.min(j));
    let mut unknowns = vec![contact.normal];
    unknowns.extend(&contact.friction);
    let (mut w, mut q, mut before) = ([[0.0; 3]; 3], [0.0; 3], [0.0; 3]);
    for (k, &i) in unknowns.iter().enumerate() {
        before[k] = point.lambda[i];
        q[k] = point.gradient[i];
        for (l, &j) in unknowns.iter().enumerate() {
            w[k][l] = entry(i, j);
        }
    }
    for k in 0..3 {
        q[k] -= (0..3).map(|l| w[k][l] * before[l]).sum::<f64>();
    }
    if !contact.moves_normally {
        // The normal force stands: what it does to the tangents is part of what the others do.
        let normal = before[0];
        for k in 1..3 {
            q[k] += w[k][0] * normal;
        }
        (w[0], q[0]) = ([1.0, 0.0, 0.0], -normal);
        (w[1][0], w[2][0]) = (0.0, 0.0);
    }
    let local = Local {
        w,
        q,
        coefficient: contact.coefficient,
        limit: contact.limit,
        tangents: contact.friction.len(),
    };
    let Some(after) = local.solve(before) else {
        return;
    };
    for (k, &i) in unknowns.iter().enumerate() {
        if k > 0 || contact.moves_normally {
            change(a, i, after[k] - before[k], point);
        }
    }
}

/// λ of a block ← P(λ − r/w), w its largest diagonal entry.
fn relax(a: &dyn SymmetricEntries, block: &Block, point: &mut Point) {
    let range = block.range();
    let w = range.clone().map(|i| a.entry(i, i)).fold(0.0, f64::max);
    if w <= 0.0 {
        return;
    }
    let step = |i: usize| point.lambda[i] - point.gradient[i] / w;
    let mut y: Vec<f64> = range.clone().map(step).collect();
    block.set.project(&mut y);
    for (i, y) in range.zip(y) {
        change(a, i, y - point.lambda[i], point);
    }
}

/// λ_i ← λ_i + δ.
fn change(a: &dyn SymmetricEntries, i: usize, delta: f64, point: &mut Point) {
    if delta == 0.0 {
        return;
    }
    point.lambda[i] += delta;
    for (j, r) in point.gradient.iter_mut().enumerate() {
        *r += delta * a.entry(i.max(j), i.min(j));
    }
}
