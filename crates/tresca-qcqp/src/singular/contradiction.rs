//! The proof that constraints contradict each other.
//!
//! No u satisfies N u ≤ d (and what else is asked of B u) when there are forces y that the laws do not limit,
//! with Bᵀy = 0 and cᵀy < 0, c the right-hand sides: for any u that did, 0 = uᵀBᵀy ≤ cᵀy (Farkas). In the
//! terms of the dual problem: Ay = 0 and bᵀy > 0, along y the objective falls without end.

use crate::operator::dual_operator::DualOperator;
use crate::sets::block::BlockSet;
use crate::sets::product::ProductSet;
use tresca_la::vector::{dot, norm};

/// ‖Ay‖ that counts as 0, relative to σmax ‖y‖.
const NOTHING: f64 = 1e-11;
/// bᵀy that counts as more than 0, relative to Σ |b_i y_i|: gaps that differ by less agree.
const CONTRADICTS: f64 = 1e-9;
/// Part of a direction that may lie outside of the cone of forces without limit.
const OUTSIDE: f64 = 1e-3;

/// The part of a direction that the laws do not limit, at length 1, if it proves that no displacement satisfies
/// the constraints. One product where it may.
pub(crate) fn proof(
    operator: &mut dyn DualOperator,
    sigma: f64,
    rhs: &[f64],
    set: &ProductSet,
    direction: &[f64],
) -> Option<Vec<f64>> {
    let mut y = direction.to_vec();
    keep_unlimited(set, &mut y);
    let length = norm(&y);
    let outside: f64 = direction.iter().zip(&y).map(|(d, y)| (d - y).powi(2)).sum();
    if !(length > 0.0 && length.is_finite() && outside.sqrt() <= OUTSIDE * length) {
        return None;
    }
    y.iter_mut().for_each(|v| *v /= length);
    let size: f64 = rhs.iter().zip(&y).map(|(b, y)| (b * y).abs()).sum();
    if dot(rhs, &y) <= CONTRADICTS * size {
        return None;
    }
    let mut product = vec![0.0; y.len()];
    operator.apply(&y, &mut product);
    (norm(&product) <= NOTHING * sigma).then_some(y)
}

/// The nearest direction in which one can go on for ever inside of Λ. Slip bounds that no force reaches are
/// bounds all the same: who stands against them could slip.
fn keep_unlimited(set: &ProductSet, y: &mut [f64]) {
    for block in set.blocks() {
        let own = &mut y[block.range()];
        match block.set {
            BlockSet::Line(_) => {}
            BlockSet::HalfLine(_) => own.iter_mut().for_each(|v| *v = v.max(0.0)),
            BlockSet::Origin(_) | BlockSet::Interval(_) | BlockSet::Disc(_) => own.fill(0.0),
        }
    }
}
