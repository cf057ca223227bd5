//! GIMSSN: the globalised inexact MSSN.
//!
//! For ρ ∈ (0, 2/σmax): q(λ^{k+1}) − q* ≤ η (q(λᵏ) − q*) with η = 1 − ρσmin for
//! ρ ≤ 1/σmax and 1 − (2/σmax − ρ)σmin above, because the projected gradient
//! step alone has this rate and CG only lowers q further.

use super::imssn::AdaptivePrecision;
use super::inner::{Move, conjugate_gradients};
use super::run::Step;
use super::{Point, Run};
use crate::Status;
use crate::reduced::ReducedSpace;
use tresca_la::krylov::Identity;

/// From P_Λ(λ − ρ r(λ)), CG on the active unknowns, which stops before an iterate leaves Λ.
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut precision = AdaptivePrecision::new(run.settings);
    let set = run.set.clone();
    let mut trial = vec![0.0; start.lambda.len()];
    let mut x = start;
    let mut step = Step::START;
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
        step = Step::full(conjugate_gradients(
            run,
            &space,
            identity,
            &mut x,
            tolerance,
            stays_inside,
        ));
    }
}
