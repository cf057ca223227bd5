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
use crate::settings::Settings;
use crate::solution::DualSolution;

/// What the inner problems share.
pub(crate) struct Session<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub memory: &'a mut OperatorMemory,
    pub settings: &'a Settings,
    pub observer: &'a mut dyn Observer,
    pub journal: Journal,
}

impl Session<'_> {
    /// Runs the method of the settings on one inner problem.
    pub fn solve(&mut self, inner: &Inner, start: Option<&[f64]>) -> Ending {
        let capacity = self.settings.recycled_directions;
        let mut run = Run::new(
            &mut *self.operator,
            inner,
            self.settings,
            self.memory.spectrum.sigma,
            &mut self.journal,
            &mut *self.observer,
        );
        let status = dispatch::run(&mut run, self.memory, capacity, start);
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
        ending.into_solution(self.settings, self.journal, tally, sigma)
    }
}
