//! MSSN: the symmetrised semismooth Newton method.
//!
//! The second term of the linearised slip condition is dropped, so that slip
//! pairs get λτ⁺ = g ŷ and the rest is an unconstrained minimisation of q:
//! CG to full accuracy.

use super::inner::{conjugate_gradients, direct, full_accuracy};
use super::run::Step;
use super::{Point, Run};
use crate::Status;
use crate::reduced::ReducedSpace;
use tresca_la::krylov::Identity;

/// λ⁺ = argmin q with λν = 0 where open and λτ = g ŷ where slipping.
/// Iterates may leave Λ; the projected ones are judged and returned.
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut x = start;
    let mut step = Step::START;
    loop {
        let feasible = run.projected(&x);
        if let Some(status) = run.judge(&feasible, step) {
            return status;
        }
        let y = run.y(&x);
        let active = run.set.classify(&y);
        let space = ReducedSpace::free(&run.set, &active);
        let fixed = run.with_bound_blocks_fixed(&x.lambda, &active, &y);
        x = run.point_unless(fixed, &x);
        step = if direct(run, &space, &mut x) {
            Step::full(1)
        } else {
            let tolerance = full_accuracy(run);
            let identity = &mut Identity(space.dim());
            Step::full(conjugate_gradients(
                run,
                &space,
                identity,
                &mut x,
                tolerance,
                |_, _| true,
            ))
        };
    }
}
