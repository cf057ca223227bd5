//! The map from the reference element to a cell, and its inverse.

use super::{ShapeTable, interpolate, jacobian};
use crate::mesh::Space;
use crate::tensor::{determinant, inverse_rows, norm};

/// det J counts as zero below this fraction of its largest possible value, ∏ ‖∂x/∂ξ_j‖. The ratio
/// does not know the cell's size or aspect, only how flat the angles are; rounding makes 1e-16.
const FLAT: f64 = 1e-12;

/// Rows ∇ξ_j of the inverse Jacobian and det J, of a cell that fills a space of D dimensions; the
/// error is a det J that is not positive. In the plane the third row is (0, 0, 1).
#[inline]
pub(crate) fn inverse_jacobian<const D: usize>(
    gradients: &[[f64; 3]],
    points: &[[f64; 3]],
) -> Result<([[f64; 3]; 3], f64), f64> {
    let mut columns = jacobian(gradients, points);
    if D == 2 {
        columns[2] = [0.0, 0.0, 1.0];
    }
    let det = determinant(&columns);
    let largest = norm(columns[0]) * norm(columns[1]) * norm(columns[2]);
    // Written so that NaN is refused too.
    if det > FLAT * largest {
        Ok((inverse_rows(&columns, det), det))
    } else {
        Err(det)
    }
}

/// ∇φ_a in physical coordinates at point q, written to `physical`, and det J times the circumference
/// there: what a reference weight is multiplied by. The error is a det J that is not positive.
///
/// The third entries are ∂φ_a/∂z in space, 0 in the plane, and φ_a/r in an axisymmetric space, where
/// the hoop strain Σ u_a φ_a/r plays the part of ε_zz.
pub(crate) fn physical_gradients(
    space: Space,
    table: &ShapeTable,
    q: usize,
    points: &[[f64; 3]],
    physical: &mut [[f64; 3]],
) -> Result<f64, f64> {
    let (rows, determinant) = match space {
        Space::Solid => inverse_jacobian::<3>(table.gradients(q), points)?,
        Space::Plane | Space::Axisymmetric => inverse_jacobian::<2>(table.gradients(q), points)?,
    };
    for (p, g) in physical.iter_mut().zip(table.gradients(q)) {
        *p = std::array::from_fn(|i| g[0] * rows[0][i] + g[1] * rows[1][i] + g[2] * rows[2][i]);
    }
    if space != Space::Axisymmetric {
        return Ok(determinant);
    }
    let x = interpolate(table.values(q), points);
    for (p, value) in physical.iter_mut().zip(table.values(q)) {
        p[2] = value / x[0];
    }
    Ok(determinant * space.circumference(x))
}
