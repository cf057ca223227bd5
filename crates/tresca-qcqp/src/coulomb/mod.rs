//! Coulomb's law: slip bounds that follow from the normal forces.
//!
//! g(λ) = min(F max(λν, 0), limit). A λ solves the problem with friction by Coulomb when it solves
//! the one with the frozen bounds g = g(λ). The bounds are found by problems with frozen bounds one
//! after another ([`fixed_point`]), or follow λ inside of the Newton loop ([`in_loop`]).

mod fixed_point;
mod history;
mod in_loop;

use crate::equality::{Balance, Balanced};
use crate::session::{Ending, Inner, Session};
use crate::sets::ProductSet;
use crate::settings::CoulombMethod;
use crate::start::Start;
use crate::{Method, QcqpError, Status};
use tresca_la::vector::norm;

/// A friction block whose bound is min(coefficient · max(λν, 0), limit).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoulombBound {
    /// Number of the block in [`ProductSet::blocks`], an interval or a disc.
    pub block: usize,
    /// Index of the normal force λν in λ.
    pub normal: usize,
    /// F ≥ 0.
    pub coefficient: f64,
    /// Cap of the bound (a force), ≥ 0 or ∞.
    pub limit: f64,
}

/// The bounds of a problem, checked against its set.
#[derive(Clone, Debug, Default)]
pub(crate) struct CoulombLaw(Vec<CoulombBound>);

impl CoulombLaw {
    pub fn new(bounds: Vec<CoulombBound>, set: &ProductSet) -> Result<Self, QcqpError> {
        let mut seen = vec![false; set.blocks().len()];
        for (number, bound) in bounds.iter().enumerate() {
            let refuse = |what| {
                Err(QcqpError::Coulomb {
                    bound: number,
                    what,
                })
            };
            let Some(block) = set.blocks().get(bound.block) else {
                return refuse("there is no such block");
            };
            if block.set.bound().is_none() {
                return refuse("the block is no interval and no disc");
            }
            if std::mem::replace(&mut seen[bound.block], true) {
                return refuse("the block has another one already");
            }
            if bound.normal >= set.dimension() || block.range().contains(&bound.normal) {
                return refuse("the normal force is no unknown outside of the block");
            }
            if !(bound.coefficient >= 0.0 && bound.coefficient.is_finite()) {
                return refuse("the coefficient must be finite and not negative");
            }
            if bound.limit.is_nan() || bound.limit < 0.0 {
                return refuse("the limit must not be negative");
            }
        }
        Ok(Self(bounds))
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The bounds as given.
    pub fn bounds_of_blocks(&self) -> &[CoulombBound] {
        &self.0
    }

    /// g(λ).
    pub fn bounds(&self, lambda: &[f64]) -> Vec<f64> {
        let bound = |b: &CoulombBound| (b.coefficient * lambda[b.normal].max(0.0)).min(b.limit);
        self.0.iter().map(bound).collect()
    }

    /// The bounds that the set has.
    pub fn present(&self, set: &ProductSet) -> Vec<f64> {
        let present = |b: &CoulombBound| set.blocks()[b.block].set.bound().unwrap_or(0.0);
        self.0.iter().map(present).collect()
    }

    /// Gives the set these bounds.
    pub fn bound(&self, set: &mut ProductSet, bounds: &[f64]) {
        for (own, &bound) in self.0.iter().zip(bounds) {
            set.rebound(own.block, bound);
        }
    }

    /// ‖g(λ) − g‖/‖g(λ)‖ with the bounds g of the set; 0 when both vanish.
    pub fn change(&self, set: &ProductSet, lambda: &[f64]) -> f64 {
        let follows = self.bounds(lambda);
        relative_change(&follows, &self.present(set))
    }
}

/// The problem with friction by Coulomb.
#[derive(Clone, Copy)]
pub(crate) struct Frictional<'a> {
    pub rhs: &'a [f64],
    /// Λ; the bounds of the law in it count only when there is a start.
    pub set: &'a ProductSet,
    pub law: &'a CoulombLaw,
    pub balance: Option<&'a Balance>,
}

/// Solves it by the way that the settings name.
pub(crate) fn solve(session: &mut Session, problem: &Frictional, start: Option<Start>) -> Ending {
    match session.settings.coulomb {
        CoulombMethod::FixedPoint => fixed_point::solve(session, problem, start),
        CoulombMethod::InLoop => in_loop::solve(session, problem, start),
        CoulombMethod::Auto if session.settings.method != Method::Grssn => {
            fixed_point::solve(session, problem, start)
        }
        // Where both are possible the loop takes fewer products: by a quarter on clamped bodies, by
        // half on floating ones with iterative inner solves. But close to the load that friction can
        // just carry, bounds and rigid motions drive each other on, and the fixed point gets there.
        CoulombMethod::Auto => {
            let ending = in_loop::solve(session, problem, start);
            let steps_left = session.journal.steps() < session.settings.max_iterations;
            if gave_up(ending.status) && steps_left && !session.journal.stop {
                fixed_point::solve(session, problem, start)
            } else {
                ending
            }
        }
    }
}

/// Whether another way may get further.
fn gave_up(status: Status) -> bool {
    matches!(
        status,
        Status::IterationLimit
            | Status::Stagnated
            | Status::CoulombCycles
            | Status::CoulombDiverges
    )
}

/// The same with bounds that are frozen as they are in `set`, or (`law`) follow from there.
#[derive(Clone, Copy)]
struct Bounded<'a> {
    problem: &'a Frictional<'a>,
    set: &'a ProductSet,
    law: Option<&'a CoulombLaw>,
    tolerance: f64,
}

impl Bounded<'_> {
    /// Solves it from λ and β.
    fn solve(&self, session: &mut Session, start: Option<&[f64]>, multiplier: &[f64]) -> Ending {
        let Bounded {
            set,
            law,
            tolerance,
            ..
        } = *self;
        let rhs = self.problem.rhs;
        let Some(balance) = self.problem.balance else {
            let plain = Inner::plain(rhs, set, tolerance);
            return session.solve(&Inner { law, ..plain }, start);
        };
        let balanced = Balanced {
            rhs,
            set,
            law,
            balance,
            tolerance,
        };
        crate::equality::solve(session, &balanced, start, multiplier)
    }
}

/// β of the start; 0 without one, empty without an equality constraint.
fn first_multiplier(problem: &Frictional, start: Option<Start>) -> Vec<f64> {
    let alpha = start.map_or(&[][..], |start| start.multiplier);
    problem
        .balance
        .map_or_else(Vec::new, |balance| balance.coordinates(alpha))
}

/// ‖new − old‖/‖new‖; 0 when both vanish.
fn relative_change(new: &[f64], old: &[f64]) -> f64 {
    let difference: Vec<f64> = new.iter().zip(old).map(|(n, o)| n - o).collect();
    match norm(&difference) {
        0.0 => 0.0,
        change => change / norm(new),
    }
}
