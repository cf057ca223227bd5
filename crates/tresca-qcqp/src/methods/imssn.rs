//! IMSSN: MSSN with CG of adaptive precision.

use super::run::{Advance, Run};
use crate::newton::reduced_space::ReducedSpace;
use crate::newton::system::conjugate_gradients;
use crate::point::Point;
use crate::settings::Settings;
use crate::status::Status;
use tresca_la::krylov::Identity;

/// The falling tolerance of IMSSN and GIMSSN, relative to err⁰:
/// tol⁰ = r_tol/c_fact, tol^{k+1} = min(r_tol · errᵏ/err⁰, c_fact · tolᵏ), with
/// errᵏ = ‖r̃_ρ(λᵏ)‖ at the method's own ρ.
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

    /// The next tolerance, absolute, at the iterate λᵏ.
    pub fn next(&mut self, run: &Run, iterate: &Point) -> f64 {
        let error = run.reduced_gradient_norm(iterate);
        let first = *self.first.get_or_insert(error);
        let Settings { r_tol, c_fact, .. } = *run.settings;
        self.tolerance = f64::min(r_tol * error / first, c_fact * self.tolerance);
        // The tail is linear and long, the tolerance falls geometrically: unchecked, it would end
        // far below what the run is asked for.
        f64::max(self.tolerance * first, run.full_accuracy())
    }
}

/// As MSSN, CG started from λ with the bound blocks replaced.
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut precision = AdaptivePrecision::new(run.settings);
    let mut x = start;
    let mut step = Advance::START;
    loop {
        let feasible = run.projected(&x);
        if let Some(status) = run.judge(&feasible, step) {
            return status;
        }
        let tolerance = precision.next(run, &x);
        let y = run.y(&x);
        let active = run.set.classify(&y);
        let space = ReducedSpace::free(&run.set, &active);
        let fixed = run.with_bound_blocks_fixed(&x.lambda, &active, &y);
        x = run.point_unless(fixed, &x);
        let identity = &mut Identity(space.dim());
        let spent = conjugate_gradients(
            run.operator,
            &space,
            identity,
            &mut x,
            tolerance,
            run.settings.max_inner_iterations,
            |_, _| true,
        );
        step = Advance::full(spent.iterations);
    }
}
