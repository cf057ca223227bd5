//! One call of `solve`: inner problems, one after another, on the same A.
//!
//! A plain problem is one inner problem. The updates of Coulomb's bounds and of
//! the multiplier of an equality constraint make a sequence of them.

use crate::inner_problem::{Ending, Inner, Journal};
use crate::methods::dispatch;
use crate::methods::run::{self, Run};
use crate::newton::operator_memory::OperatorMemory;
use crate::observe::Observer;
use crate::operator::dual_operator::DualOperator;
use crate::point::point_at;
use crate::sets::product::ProductSet;
use crate::settings::{Method, Settings};
use crate::singular::proximal;
use crate::singular::shifted::{Shift, Shifted};
use crate::solution::DualSolution;
use crate::status::Status;
use tresca_la::vector::dot;

/// Where A is singular, blocks of it are factored with this part of σmax added: of all Newton steps a short one.
const STEADY: f64 = 1e-10;

/// Steps that the method of the settings gets before proximal steps take over, however few are allowed.
const FEW: usize = 50;
/// A relative reduced gradient that is rounding: proximal steps would not get further.
const ROUNDING: f64 = 1e-12;

/// Part of the objective that rounding in it may be.
const CANCELS: f64 = 1e-9;

/// The fresh reduced gradient, relative to the tolerance, at which digits are said to be lost.
const LOST: f64 = 10.0;

/// What the inner problems share.
pub(crate) struct Session<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub memory: &'a mut OperatorMemory,
    pub settings: &'a Settings,
    pub observer: &'a mut dyn Observer,
    pub journal: Journal,
    /// A is known to be singular.
    pub singular: bool,
    /// Proximal steps so far.
    pub proximal_steps: usize,
}

/// How an inner problem is tried.
#[derive(Clone, Copy)]
pub(crate) struct Attempt {
    pub method: Method,
    pub shift: Shift,
    /// Steps of the whole session after which it ends.
    pub most_steps: usize,
}

impl Session<'_> {
    /// Solves one inner problem by the method of the settings, and by proximal steps where that fails.
    pub fn solve(&mut self, inner: &Inner, start: Option<&[f64]>) -> Ending {
        let steady = if self.singular { STEADY } else { 0.0 };
        let helped = self.helped(inner);
        if helped && self.proximal_steps > 0 {
            return proximal::solve(self, inner, start);
        }
        let limit = self.settings.max_iterations;
        let attempt = Attempt {
            method: self.settings.method,
            shift: Shift {
                products: 0.0,
                factors: steady * self.memory.spectrum.sigma,
            },
            most_steps: if helped { self.first_share() } else { limit },
        };
        let ending = self.attempt(inner, start, attempt);
        let failed = match ending.status {
            Status::Diverged => true,
            // A tolerance below rounding is not to be had by other steps either.
            Status::Stagnated | Status::IterationLimit => ending.relative > ROUNDING,
            Status::Converged => {
                self.singular && (self.cancels(&ending) || self.lost(inner, &ending))
            }
            _ => false,
        };
        if !helped || !failed || self.journal.steps() >= limit {
            return ending;
        }
        let rescued = proximal::solve(self, inner, start);
        let better =
            |ending: &Ending| matches!(ending.status, Status::Converged | Status::Infeasible);
        if better(&rescued) || rescued.relative < ending.relative {
            rescued
        } else {
            ending
        }
    }

    /// Whether forces that cancel each other are so large that rounding in their work is seen in the objective.
    fn cancels(&self, ending: &Ending) -> bool {
        let forces = dot(&ending.point.lambda, &ending.point.lambda);
        let rounding = self.operator.accuracy() * self.memory.spectrum.sigma * forces;
        rounding > CANCELS * ending.objective.abs()
    }

    /// Whether the gradient of a method whose iterates may be far outside of Λ has lost its digits on the way: one
    /// product tells.
    fn lost(&mut self, inner: &Inner, ending: &Ending) -> bool {
        if self.guaranteed() {
            return false;
        }
        let fresh = point_at(&mut *self.operator, inner.rhs, ending.point.lambda.clone());
        let fresh = run::ending_of(fresh, inner, self.memory.spectrum.sigma);
        fresh.relative > LOST * inner.tolerance
    }

    /// The steps after which the method of the settings makes room for proximal steps.
    fn first_share(&self) -> usize {
        let done = self.journal.steps();
        let left = self.settings.max_iterations.saturating_sub(done);
        if self.singular && self.settings.method != Method::Apgd {
            done + left.min(FEW)
        } else {
            done + left.min(2 * FEW).max(left / 2)
        }
    }

    /// Whether proximal steps follow where the method of the settings fails. Methods without a guarantee may fail
    /// on any problem, and are to be seen failing; but not because A is singular. Bounds that follow λ have
    /// another way out.
    fn helped(&self, inner: &Inner) -> bool {
        inner.law.is_none() && (self.guaranteed() || self.singular)
    }

    fn guaranteed(&self) -> bool {
        matches!(
            self.settings.method,
            Method::Gimssn | Method::Grssn | Method::Apgd
        )
    }

    /// Runs a method on one inner problem.
    pub fn attempt(&mut self, inner: &Inner, start: Option<&[f64]>, attempt: Attempt) -> Ending {
        let capacity = self.settings.recycled_directions;
        let Attempt {
            method,
            shift,
            most_steps,
        } = attempt;
        let sigma = self.memory.spectrum.sigma + shift.products;
        let mut shifted;
        let operator: &mut dyn DualOperator = if shift.factors > 0.0 {
            shifted = Shifted {
                operator: &mut *self.operator,
                shift,
            };
            &mut shifted
        } else {
            &mut *self.operator
        };
        let mut run = Run::new(
            operator,
            inner,
            self.settings,
            sigma,
            &mut self.journal,
            &mut *self.observer,
        );
        run.most_steps = most_steps;
        let status = dispatch::run(&mut run, method, self.memory, capacity, start);
        run.end(status)
    }

    /// What there is to say of a λ that no method has led to. One product, none for λ = 0.
    pub fn evaluate(&mut self, rhs: &[f64], set: &ProductSet, lambda: Vec<f64>) -> Ending {
        run::ending_at(
            &mut *self.operator,
            self.memory.spectrum.sigma,
            rhs,
            set.clone(),
            lambda,
        )
    }

    /// The outcome as the caller sees it.
    pub fn into_solution(self, ending: Ending) -> DualSolution {
        let tally = *self.operator.tally();
        let sigma = self.memory.spectrum.sigma;
        let mut solution = ending.into_solution(self.settings, self.journal, tally, sigma);
        solution.figures.proximal_steps = self.proximal_steps;
        solution
    }
}
