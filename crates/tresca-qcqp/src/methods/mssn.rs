//! MSSN: the symmetrised semismooth Newton method.
//!
//! The second term of the linearised slip condition is dropped, so that slip
//! pairs get λτ⁺ = g ŷ and the rest is an unconstrained minimisation of q:
//! CG to full accuracy.

use super::run::{Advance, Run};
use crate::newton::reduced_space::ReducedSpace;
use crate::newton::system::conjugate_gradients;
use crate::newton::tangent::Tangent;
use crate::point::Point;
use crate::status::Status;
use tresca_la::krylov::Identity;

/// λ⁺ = argmin q with λν = 0 where open and λτ = g ŷ where slipping.
/// Iterates may leave Λ; the projected ones are judged and returned.
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut x = start;
    let mut step = Advance::START;
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
        let tangent = Tangent::new(run.operator, run.settings.inner_solver, space);
        step = if tangent.step(run.operator, &mut x) {
            Advance::full(1)
        } else {
            let tolerance = run.full_accuracy();
            let space = tangent.space();
            let identity = &mut Identity(space.dim());
            let spent = conjugate_gradients(
                run.operator,
                space,
                identity,
                &mut x,
                tolerance,
                run.settings.max_inner_iterations,
                |_, _| true,
            );
            Advance::full(spent.iterations)
        };
    }
}
