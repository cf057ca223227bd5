//! One call of `solve`: inner problems, one after another, on the same A.
//!
//! A plain problem is one inner problem. The updates of Coulomb's bounds and of
//! the multiplier of an equality constraint make a sequence of them.

use crate::coulomb::CoulombLaw;
use crate::figures::Figures;
use crate::methods::{self, Memory, Point, Run};
use crate::{
    ActiveSet, DualOperator, DualSolution, IterationRecord, Observer, ProductSet, Settings, Status,
    Tally,
};

/// What the inner problems share.
pub(crate) struct Session<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub memory: &'a mut Memory,
    pub settings: &'a Settings,
    pub observer: &'a mut dyn Observer,
    pub journal: Journal,
}

/// The records of all inner problems so far, and the products before the first.
pub(crate) struct Journal {
    pub records: Vec<IterationRecord>,
    /// Number of inner problems begun.
    pub problems: usize,
    pub before: Tally,
    pub n_a_setup: usize,
    /// The observer has asked to stop. An inner problem that has just converged says so all the
    /// same: the outer iterations look here before they begin another.
    pub stop: bool,
}

impl Journal {
    /// Steps made: every inner problem has one record that is its start.
    pub fn steps(&self) -> usize {
        self.records.len().saturating_sub(self.problems)
    }
}

/// min ½ λᵀAλ − λᵀb over Λ, with all that outer iterations change held fixed.
#[derive(Clone, Copy)]
pub(crate) struct Inner<'a> {
    /// b, the multiplier's share Gᵀα included.
    pub rhs: &'a [f64],
    /// b without that share, from which the reference ‖r̃(0)‖ is taken: it must not grow with α.
    pub own_rhs: &'a [f64],
    /// Least reference.
    pub least_reference: f64,
    /// Λ.
    pub set: &'a ProductSet,
    /// Bounds that follow the normal forces inside of the Newton loop.
    pub law: Option<&'a CoulombLaw>,
    /// On ‖r̃(λ)‖/‖r̃(0)‖.
    pub tolerance: f64,
}

impl<'a> Inner<'a> {
    /// The plain problem.
    pub fn plain(rhs: &'a [f64], set: &'a ProductSet, tolerance: f64) -> Self {
        Self {
            rhs,
            own_rhs: rhs,
            least_reference: 0.0,
            set,
            law: None,
            tolerance,
        }
    }
}

/// Where an inner problem, or a sequence of them, has ended.
pub(crate) struct Ending {
    pub status: Status,
    pub point: Point,
    /// Λ of this end: the bounds change under Coulomb's law.
    pub set: ProductSet,
    pub active: ActiveSet,
    /// ‖r̃(λ)‖/reference.
    pub relative: f64,
    pub reference: f64,
    /// q(λ), the multiplier's share −αᵀGλ included while that is not taken out.
    pub objective: f64,
    /// α; empty without an equality constraint.
    pub multiplier: Vec<f64>,
    pub equality_residual: f64,
    pub motion: Option<Vec<f64>>,
    pub outer_iterations: usize,
    pub outer_residual: f64,
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
        let status = methods::run(&mut run, self.memory, capacity, start);
        run.end(status)
    }

    /// What there is to say of a λ that no method has led to. One product, none for λ = 0.
    pub fn evaluate(&mut self, rhs: &[f64], set: &ProductSet, lambda: Vec<f64>) -> Ending {
        methods::ending_at(
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

impl Ending {
    /// The outcome as the caller sees it, after the products that the operator has counted.
    pub fn into_solution(
        self,
        settings: &Settings,
        journal: Journal,
        tally: Tally,
        sigma_max: f64,
    ) -> DualSolution {
        let spent = tally - journal.before;
        DualSolution {
            status: self.status,
            method: settings.method,
            figures: Figures {
                iterations: journal.steps(),
                n_a: spent.count,
                n_a_setup: journal.n_a_setup,
                sigma_max,
                relative_reduced_gradient: self.relative,
                equality_residual: self.equality_residual,
                outer_iterations: self.outer_iterations,
                outer_residual: self.outer_residual,
                objective: self.objective,
                seconds_in_products: spent.time.as_secs_f64(),
            },
            lambda: self.point.lambda,
            gradient: self.point.gradient,
            active_set: self.active,
            multiplier: self.multiplier,
            motion: self.motion,
            records: journal.records,
        }
    }
}
