//! Conjugate gradients on the reduced Newton system (ZᵀAZ + C) s = −Zᵀ r(x).

use super::reduced_space::{ReducedOperator, ReducedSpace};
use crate::operator::dual_operator::DualOperator;
use crate::point::Point;
use tresca_la::LinearOperator;
use tresca_la::krylov::cg::{ConjugateGradient, Proposal};

/// One proposed CG step in the space of λ: the direction Z p, its product, the step length.
pub(crate) struct Move<'a> {
    pub alpha: f64,
    pub direction: &'a [f64],
    pub product: &'a [f64],
}

/// What conjugate gradients took, and the norm of the residual that they left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spent {
    pub iterations: usize,
    pub residual: f64,
}

/// Moves `x` by conjugate gradients until the residual is at most `tolerance` (absolute),
/// `max_iterations` are made or `admit` refuses a proposed step. Every iteration is one product.
///
/// `admit` sees the point before the step and the step.
pub(crate) fn conjugate_gradients<M: LinearOperator>(
    operator: &mut dyn DualOperator,
    space: &ReducedSpace,
    preconditioner: &mut M,
    x: &mut Point,
    tolerance: f64,
    max_iterations: usize,
    mut admit: impl FnMut(&Point, &Move) -> bool,
) -> Spent {
    let mut system = ReducedOperator::new(operator, space);
    let mut s = vec![0.0; space.dim()];
    let mut cg = ConjugateGradient::with_capacity(space.dim());
    cg.start(&residual(space, x));
    // In exact arithmetic one per unknown suffices; rounding may ask for a few times that.
    let limit = max_iterations.min(10 * space.dim());
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
    Spent {
        iterations,
        residual: cg.residual_norm(),
    }
}

/// −Zᵀ r(x).
fn residual(space: &ReducedSpace, x: &Point) -> Vec<f64> {
    let mut residual = vec![0.0; space.dim()];
    space.restrict(&x.gradient, &mut residual);
    residual.iter_mut().for_each(|v| *v = -*v);
    residual
}
