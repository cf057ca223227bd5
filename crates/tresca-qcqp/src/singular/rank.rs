//! Is a small A singular?

use crate::operator::dual_operator::DualOperator;
use faer::linalg::solvers::Llt;
use faer::{Mat, Side};

/// Up to this order the question costs less than a few multiplications.
const SMALL: usize = 300;
/// Squared distance of a row (of B, scaled to unit energy) from the span of those before it, below which it is
/// said to be in it.
const DEPENDENT: f64 = 1e-12;

/// Whether A, which must be explicit and small, has rows that depend on others; `false` where that is not known.
pub(crate) fn is_singular(operator: &dyn DualOperator) -> bool {
    let order = operator.dim();
    let Some(a) = operator.explicit().filter(|_| order <= SMALL) else {
        return false;
    };
    let lengths: Vec<f64> = (0..order).map(|i| a.entry(i, i).max(0.0).sqrt()).collect();
    let unit = Mat::from_fn(order, order, |i, j| {
        let size = lengths[i] * lengths[j];
        if i == j {
            1.0
        } else if i > j && size > 0.0 {
            a.entry(i, j) / size
        } else {
            0.0
        }
    });
    // Rows of zeros stand alone: what acts there moves nothing, and nothing else.
    match Llt::new(unit.as_ref(), Side::Lower) {
        Ok(factor) => (0..order).any(|i| factor.L()[(i, i)].powi(2) <= DEPENDENT),
        Err(_) => true,
    }
}
