//! Solving the reduced Newton system (ZᵀAZ + C) s = −Zᵀ r(x).

use super::{Point, Run};
use crate::DualOperator;
use crate::reduced::{ReducedOperator, ReducedSpace};
use crate::settings::InnerSolver;
use faer::linalg::solvers::{Llt, Solve};
use faer::{ColMut, Side};
use tresca_la::LinearOperator;
use tresca_la::krylov::cg::{ConjugateGradient, Proposal};
use tresca_la::vector::norm;

/// −Zᵀ r(x).
pub(super) fn residual(space: &ReducedSpace, x: &Point) -> Vec<f64> {
    let mut residual = vec![0.0; space.dim()];
    space.restrict(&x.gradient, &mut residual);
    residual.iter_mut().for_each(|v| *v = -*v);
    residual
}

/// One proposed CG step in the space of λ: the direction Z p, its product, the step length.
pub(super) struct Move<'a> {
    pub alpha: f64,
    pub direction: &'a [f64],
    pub product: &'a [f64],
}

/// Moves `x` by conjugate gradients until the residual is at most `tolerance`
/// (absolute) or `admit` refuses a proposed step. Returns the number of
/// products spent.
///
/// `admit` sees the point before the step and the step.
pub(super) fn conjugate_gradients<M: LinearOperator>(
    run: &mut Run,
    space: &ReducedSpace,
    preconditioner: &mut M,
    x: &mut Point,
    tolerance: f64,
    mut admit: impl FnMut(&Point, &Move) -> bool,
) -> usize {
    let mut system = ReducedOperator::new(&mut *run.operator, space);
    let mut s = vec![0.0; space.dim()];
    let mut cg = ConjugateGradient::with_capacity(space.dim());
    cg.start(&residual(space, x));
    // In exact arithmetic one per unknown suffices; rounding may ask for a few times that.
    let limit = run.settings.max_inner_iterations.min(10 * space.dim());
    let mut iterations = 0;
    while cg.residual_norm() > tolerance && iterations < limit {
        // Not positive: a null direction of a semidefinite A, or rounding. What is reached stands.
        let Proposal::Step { alpha, .. } = cg.propose(&mut system, preconditioner) else {
            break;
        };
        iterations += 1;
        let step = Move {
            alpha,
            direction: &system.expanded,
            product: &system.product,
        };
        if !admit(x, &step) {
            break;
        }
        x.advance(alpha, &system.expanded, &system.product);
        cg.accept(&mut s);
    }
    iterations
}

/// Up to this order factoring the active block costs less than a few multiplications.
const SMALL: usize = 300;

/// The factor of ZᵀAZ + C when A is explicit and the settings allow it; `None` when that is not
/// so or the matrix is not positive definite.
pub(super) fn direct_factor(
    operator: &dyn DualOperator,
    solver: InnerSolver,
    space: &ReducedSpace,
) -> Option<Llt<f64>> {
    let wanted = match solver {
        InnerSolver::Auto => space.dim() <= SMALL,
        InnerSolver::Iterative => false,
        InnerSolver::Direct => true,
    };
    let matrix = operator.explicit().filter(|_| wanted && space.dim() > 0)?;
    Llt::new(space.assemble(matrix).as_ref(), Side::Lower).ok()
}

/// Solves the system by Cholesky where [`direct_factor`] has one, at the price of one
/// multiplication for the new gradient. `false`, and `x` unchanged, where it has none.
pub(super) fn direct(run: &mut Run, space: &ReducedSpace, x: &mut Point) -> bool {
    let Some(factor) = direct_factor(run.operator, run.settings.inner_solver, space) else {
        return false;
    };
    let mut s = residual(space, x);
    factor.solve_in_place(ColMut::from_slice_mut(&mut s));
    if !norm(&s).is_finite() {
        return false;
    }
    let mut direction = vec![0.0; x.lambda.len()];
    space.expand(&s, &mut direction);
    let mut product = vec![0.0; x.lambda.len()];
    run.operator.apply(&direction, &mut product);
    x.advance(1.0, &direction, &product);
    true
}

/// The residual (absolute) that "solved to full accuracy" means.
pub(super) fn full_accuracy(run: &Run) -> f64 {
    let relative = run.settings.inner_tolerance * run.tolerance;
    // Below this the product with A is rounding.
    let floor = 4.0 * f64::EPSILON * norm(run.rhs);
    (relative * run.reference).max(floor)
}
