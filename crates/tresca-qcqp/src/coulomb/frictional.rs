//! The problem with friction by Coulomb, and the same with bounds held or following.

use super::law::CoulombLaw;
use crate::equality::balance::Balance;
use crate::equality::multiplier::{self, Balanced};
use crate::inner_problem::{Ending, Inner};
use crate::inner_solve;
use crate::session::Session;
use crate::sets::product::ProductSet;
use crate::start::Start;

/// The problem with friction by Coulomb.
#[derive(Clone, Copy)]
pub(crate) struct Frictional<'a> {
    pub rhs: &'a [f64],
    /// Λ; the bounds of the law in it count only when there is a start.
    pub set: &'a ProductSet,
    pub law: &'a CoulombLaw,
    pub balance: Option<&'a Balance>,
}

/// The same with bounds that are frozen as they are in `set`, or (`law`) follow from there.
#[derive(Clone, Copy)]
pub(super) struct Bounded<'a> {
    pub problem: &'a Frictional<'a>,
    pub set: &'a ProductSet,
    pub law: Option<&'a CoulombLaw>,
    pub tolerance: f64,
}

impl Bounded<'_> {
    /// Solves it from λ and β.
    pub fn solve(
        &self,
        session: &mut Session,
        start: Option<&[f64]>,
        multiplier: &[f64],
    ) -> Ending {
        let Bounded {
            set,
            law,
            tolerance,
            ..
        } = *self;
        let rhs = self.problem.rhs;
        let Some(balance) = self.problem.balance else {
            let plain = Inner::plain(rhs, set, tolerance);
            return inner_solve::solve(session, &Inner { law, ..plain }, start);
        };
        let balanced = Balanced {
            rhs,
            set,
            law,
            balance,
            tolerance,
        };
        multiplier::solve(session, &balanced, start, multiplier)
    }
}

/// β of the start; 0 without one, empty without an equality constraint.
pub(super) fn first_multiplier(problem: &Frictional, start: Option<Start>) -> Vec<f64> {
    let alpha = start.map_or(&[][..], |start| start.multiplier);
    problem
        .balance
        .map_or_else(Vec::new, |balance| balance.coordinates(alpha))
}
