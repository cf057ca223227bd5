//! The problems that one call of `solve` is made of, and how they end.

use crate::active_set::ActiveSet;
use crate::coulomb::law::CoulombLaw;
use crate::equality::Statics;
use crate::figures::Figures;
use crate::operator::dual_operator::Tally;
use crate::point::Point;
use crate::record::IterationRecord;
use crate::sets::product::ProductSet;
use crate::settings::Settings;
use crate::solution::DualSolution;
use crate::status::Status;

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
    pub statics: Option<Statics>,
    /// y, the proof that constraints contradict each other.
    pub contradiction: Option<Vec<f64>>,
    pub outer_iterations: usize,
    pub outer_residual: f64,
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
                proximal_steps: 0,
                sweeps: 0,
                objective: self.objective,
                seconds_in_products: spent.time.as_secs_f64(),
            },
            lambda: self.point.lambda,
            gradient: self.point.gradient,
            active_set: self.active,
            multiplier: self.multiplier,
            motion: self.motion,
            statics: self.statics,
            contradiction: self.contradiction,
            records: journal.records,
        }
    }
}
