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
use crate::sets::product::ProductSet;
use crate::settings::{Method, Settings};
use crate::singular::shifted::{Shift, Shifted};
use crate::solution::DualSolution;

/// What the inner problems share.
pub(crate) struct Session<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub memory: &'a mut OperatorMemory,
    pub settings: &'a Settings,
    pub observer: &'a mut dyn Observer,
    pub journal: Journal,
    /// A is known to be singular.
    pub singular: bool,
    /// Newton steps of all inner problems together that are left to what runs now: those of the settings, or a part.
    pub most_steps: usize,
    /// Proximal steps so far.
    pub proximal_steps: usize,
    /// Sweeps over the contacts so far.
    pub sweeps: usize,
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
        solution.figures.sweeps = self.sweeps;
        solution
    }
}
