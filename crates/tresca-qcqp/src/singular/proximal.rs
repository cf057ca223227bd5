//! Proximal steps: a singular problem as a sequence of regular ones.
//!
//! ```text
//! λ⁺ = argmin over Λ of q(λ) + ε/2 ‖λ − λᵏ‖²,      ε falling
//! ```
//!
//! (R. T. Rockafellar, *Monotone operators and the proximal point algorithm*, SIAM J. Control Optim. 14 (1976).)
//! From λ⁰ = 0 the forces of (about) smallest norm are found. What ε adds to A vanishes with the steps:
//! r(λ⁺) = r_ε(λ⁺) − ε (λ⁺ − λᵏ). Where the problem has no solution, λ⁺ − λᵏ turns into the direction in which q falls
//! without end, and that is the proof.

use super::contradiction;
use super::shifted::Shift;
use crate::inner_problem::{Ending, Inner};
use crate::methods::run;
use crate::point::Point;
use crate::session::{Attempt, Session};
use crate::settings::Method;
use crate::status::Status;
use tresca_la::vector::axpy;

/// ε of the first step relative to σmax, the factor between steps, and the least ε: there A is known to some
/// digits still, in the directions that matter.
const FIRST: f64 = 1e-6;
const FALLING: f64 = 0.1;
const LEAST: f64 = 1e-11;
/// The factor after a step that was not solved, and the largest ε: with it every step is easy.
const RISING: f64 = 100.0;
const MOST: f64 = 1e-1;
/// Part of the tolerance that a step is solved to.
const SHARE: f64 = 0.1;
const MAX_STEPS: usize = 100;
/// Newton steps that one of them gets.
const STEPS_EACH: usize = 100;

/// Solves the inner problem by proximal steps, each by GRSSN.
pub(crate) fn solve(session: &mut Session, inner: &Inner, start: Option<&[f64]>) -> Ending {
    let sigma = session.memory.spectrum.sigma;
    let mut centre = start.map_or_else(|| vec![0.0; inner.rhs.len()], <[f64]>::to_vec);
    inner.set.project(&mut centre);
    let mut shift = FIRST * sigma;
    let limit = session.most_steps;
    let mut best: Option<Ending> = None;
    let mut diverged = false;
    for _ in 0..MAX_STEPS {
        let mut rhs = inner.rhs.to_vec();
        axpy(shift, &centre, &mut rhs);
        let step = Inner {
            rhs: &rhs,
            tolerance: SHARE * inner.tolerance,
            ..*inner
        };
        let attempt = Attempt {
            method: Method::Grssn,
            shift: Shift {
                products: shift,
                factors: shift,
            },
            most_steps: limit.min(session.journal.steps() + STEPS_EACH),
        };
        let end = session.attempt(&step, Some(&centre), attempt);
        session.proximal_steps += 1;
        let end_status = end.status;
        let Point {
            lambda,
            mut gradient,
        } = end.point;
        let moved: Vec<f64> = lambda.iter().zip(&centre).map(|(l, c)| l - c).collect();
        axpy(-shift, &moved, &mut gradient);
        let point = Point { lambda, gradient };
        centre.clone_from(&point.lambda);
        let mut ending = run::ending_of(point, inner, sigma);
        let over = session.journal.stop || session.journal.steps() >= limit;
        // First: to a coarse tolerance contradictions look like solutions.
        let found =
            contradiction::proof(&mut *session.operator, sigma, inner.rhs, inner.set, &moved);
        if found.is_some() {
            ending.status = Status::Infeasible;
            ending.contradiction = found;
            return ending;
        }
        if ending.relative <= inner.tolerance
            && !run::drowned(&*session.operator, sigma, &ending.point, ending.reference)
        {
            ending.status = Status::Converged;
            return ending;
        }
        if best
            .as_ref()
            .is_none_or(|best| ending.relative < best.relative)
        {
            best = Some(ending);
        }
        // Nothing was gained, and not for want of steps: a product is not finite.
        let broken = end_status == Status::Diverged && moved.iter().all(|&m| m == 0.0);
        if over || broken {
            diverged = broken;
            break;
        }
        shift = if end_status == Status::Converged {
            f64::max(FALLING * shift, LEAST * sigma)
        } else {
            f64::min(RISING * shift, MOST * sigma)
        };
    }
    let mut ending = best.unwrap_or_else(|| run::ending_of(Point::zero(inner.rhs), inner, sigma));
    ending.status = if session.journal.stop {
        Status::Interrupted
    } else if diverged {
        Status::Diverged
    } else if session.journal.steps() >= session.most_steps {
        Status::IterationLimit
    } else {
        Status::Stagnated
    };
    ending
}
