//! What the structured meshes share: checked bounds, and coordinates that neighbours agree on.

use crate::error::FemError;

/// Checks bounds and node counts along each axis.
pub(super) fn check(min: &[f64], max: &[f64], nodes: &[usize]) -> Result<(), FemError> {
    for (i, axis) in ['x', 'y', 'z'].into_iter().enumerate().take(nodes.len()) {
        let (min, max, found) = (min[i], max[i], nodes[i]);
        if found < 2 {
            return Err(FemError::TooFewNodes { axis, found });
        }
        if !(min.is_finite() && max.is_finite() && min < max) {
            return Err(FemError::EmptyBox { axis, min, max });
        }
    }
    Ok(())
}

/// The i-th of `nodes` equidistant coordinates. Both ends are hit exactly, and the formula is
/// symmetric under swapping them.
pub(super) fn coordinate(min: f64, max: f64, nodes: usize, i: usize) -> f64 {
    let t = i as f64 / (nodes - 1) as f64;
    (1.0 - t) * min + t * max
}
