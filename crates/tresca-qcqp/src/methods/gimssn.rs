//! GIMSSN: the globalised inexact MSSN.
//!
//! For ρ ∈ (0, 2/σmax): q(λ^{k+1}) − q* ≤ η (q(λᵏ) − q*) with η = 1 − ρσmin for
//! ρ ≤ 1/σmax and 1 − (2/σmax − ρ)σmin above, because the projected gradient
//! step alone has this rate and CG only lowers q further.

use super::imssn::AdaptivePrecision;
use super::run::{Advance, Run};
use crate::newton::reduced_space::ReducedSpace;
use crate::newton::system::{Move, conjugate_gradients};
use crate::point::Point;
use crate::status::Status;
use tresca_la::krylov::Identity;

/// From P_Λ(λ − ρ r(λ)), CG on the active unknowns, which stops before an iterate leaves Λ.
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut precision = AdaptivePrecision::new(run.settings);
    let set = run.set.clone();
    let mut trial = vec![0.0; start.lambda.len()];
    let mut x = start;
    let mut step = Advance::START;
    loop {
        if let Some(status) = run.judge(&x, step) {
            return status;
        }
        let tolerance = precision.next(run, &x);
        let mut y = run.y(&x);
        let active = run.set.classify(&y);
        let space = ReducedSpace::free(&run.set, &active);
        run.set.project(&mut y);
        x = run.point_unless(y, &x);
        let stays_inside = |x: &Point, step: &Move| {
            for (trial, (l, d)) in trial.iter_mut().zip(x.lambda.iter().zip(step.direction)) {
                *trial = l + step.alpha * d;
            }
            set.contains(&trial)
        };
        let identity = &mut Identity(space.dim());
        let spent = conjugate_gradients(
            run.operator,
            &space,
            identity,
            &mut x,
            tolerance,
            run.settings.max_inner_iterations,
            stays_inside,
        );
        step = Advance::full(spent.iterations);
    }
}
