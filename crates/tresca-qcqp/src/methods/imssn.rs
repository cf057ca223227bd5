//! IMSSN: MSSN with CG of adaptive precision.

use super::inner::conjugate_gradients;
use super::run::Step;
use super::{Point, Run};
use crate::reduced::ReducedSpace;
use crate::{Settings, Status};
use tresca_la::krylov::Identity;

/// The falling tolerance of IMSSN and GIMSSN, relative to ‖r̃(0)‖:
/// tol⁰ = r_tol/c_fact, tol^{k+1} = min(r_tol · errᵏ/err⁰, c_fact · tolᵏ).
pub(super) struct AdaptivePrecision {
    tolerance: f64,
    first: Option<f64>,
}

impl AdaptivePrecision {
    pub fn new(settings: &Settings) -> Self {
        Self {
            tolerance: settings.r_tol / settings.c_fact,
            first: None,
        }
    }

    /// The next tolerance, absolute, after the last judged iterate.
    pub fn next(&mut self, run: &Run) -> f64 {
        // err⁰ is that of the start, so that a good start is not solved to the accuracy of a bad one.
        let first = *self.first.get_or_insert(run.relative);
        let Settings { r_tol, c_fact, .. } = *run.settings;
        self.tolerance = f64::min(r_tol * run.relative / first, c_fact * self.tolerance);
        self.tolerance * first * run.reference
    }
}

/// As MSSN, CG started from λ with the bound blocks replaced.
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut precision = AdaptivePrecision::new(run.settings);
    let mut x = start;
    let mut step = Step::START;
    loop {
        let feasible = run.projected(&x);
        if let Some(status) = run.judge(&feasible, step) {
            return status;
        }
        let y = run.y(&x);
        let active = run.set.classify(&y);
        let space = ReducedSpace::free(run.set, &active);
        let fixed = run.with_bound_blocks_fixed(&x.lambda, &active, &y);
        x = run.point_unless(fixed, &x);
        let tolerance = precision.next(run);
        let identity = &mut Identity(space.dim());
        step = Step::full(conjugate_gradients(
            run,
            &space,
            identity,
            &mut x,
            tolerance,
            |_, _| true,
        ));
    }
}
