//! The map from the reference element to a cell, and its inverse.

use super::table::{ShapeTable, interpolate, jacobian};
use crate::matrix3::{determinant, inverse_rows};
use crate::mesh::space::Space;
use crate::vector3::norm;

/// det J counts as zero below this fraction of its largest possible value, ∏ ‖∂x/∂ξ_j‖, and when one
/// of these vectors is shorter than this fraction of another. The first ratio does not know the cell's
/// size or aspect, only how flat the angles are; rounding makes 1e-16.
const FLAT: f64 = 1e-12;

/// The least |det J| that does not count as zero, for the Jacobian with the given columns.
#[inline]
fn least_determinant(columns: &[[f64; 3]; 3], dimension: usize) -> f64 {
    let lengths = columns.map(norm);
    let used = &lengths[..dimension];
    let (shortest, longest) = used
        .iter()
        .fold((f64::INFINITY, 0.0_f64), |(a, b), &x| (a.min(x), b.max(x)));
    if shortest > FLAT * longest {
        FLAT * lengths[0] * lengths[1] * lengths[2]
    } else {
        f64::INFINITY
    }
}

/// Which way round a cell is at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Orientation {
    /// det J > 0, as it should be.
    Positive,
    /// det J = 0 up to rounding, or no number.
    Flat,
    /// det J < 0.
    Negative,
}

/// det J of a cell at the point with the given reference gradients, and what it means.
pub(crate) fn orientation(
    dimension: usize,
    gradients: &[[f64; 3]],
    points: &[[f64; 3]],
) -> (f64, Orientation) {
    let mut columns = jacobian(gradients, points);
    if dimension == 2 {
        columns[2] = [0.0, 0.0, 1.0];
    }
    let det = determinant(&columns);
    let least = least_determinant(&columns, dimension);
    if det > least {
        (det, Orientation::Positive)
    } else if det < -least {
        (det, Orientation::Negative)
    } else {
        (det, Orientation::Flat)
    }
}

/// Rows ∇ξ_j of the inverse Jacobian and det J, of a cell that fills a space of D dimensions; `None`
/// where det J is not positive. In the plane the third row is (0, 0, 1).
#[inline]
pub(crate) fn inverse_jacobian<const D: usize>(
    gradients: &[[f64; 3]],
    points: &[[f64; 3]],
) -> Option<([[f64; 3]; 3], f64)> {
    let mut columns = jacobian(gradients, points);
    if D == 2 {
        columns[2] = [0.0, 0.0, 1.0];
    }
    let det = determinant(&columns);
    // Written so that NaN is refused too.
    if det > least_determinant(&columns, D) {
        Some((inverse_rows(&columns, det), det))
    } else {
        None
    }
}

/// det J times the circumference at point q of a cell that is not inside out.
pub(crate) fn measure(space: Space, table: &ShapeTable, q: usize, points: &[[f64; 3]]) -> f64 {
    let (determinant, _) = orientation(space.dimension(), table.gradients(q), points);
    determinant * space.circumference(interpolate(table.values(q), points))
}

/// ∇φ_a in physical coordinates at point q, written to `physical`, and det J times the circumference
/// there: what a reference weight is multiplied by. `None` where det J is not positive.
///
/// The third entries are ∂φ_a/∂z in space, 0 in the plane, and φ_a/r in an axisymmetric space, where
/// the hoop strain Σ u_a φ_a/r plays the part of ε_zz.
pub(crate) fn physical_gradients(
    space: Space,
    table: &ShapeTable,
    q: usize,
    points: &[[f64; 3]],
    physical: &mut [[f64; 3]],
) -> Option<f64> {
    let (rows, determinant) = match space {
        Space::Solid => inverse_jacobian::<3>(table.gradients(q), points)?,
        Space::Plane | Space::Axisymmetric => inverse_jacobian::<2>(table.gradients(q), points)?,
    };
    for (p, g) in physical.iter_mut().zip(table.gradients(q)) {
        *p = std::array::from_fn(|i| g[0] * rows[0][i] + g[1] * rows[1][i] + g[2] * rows[2][i]);
    }
    if space != Space::Axisymmetric {
        return Some(determinant);
    }
    let x = interpolate(table.values(q), points);
    for (p, value) in physical.iter_mut().zip(table.values(q)) {
        p[2] = value / x[0];
    }
    Some(determinant * space.circumference(x))
}
