//! Strains of nodal displacements, and the nodal forces of stresses: one the transpose of the other.
//!
//! Both take the gradients that [`crate::element::physical_gradients`] writes.

use crate::mesh::space::Space;

/// Strain xx, yy, zz, γxy, γyz, γxz of the displacements `u` (full dofs) at a point with the given
/// gradients; in an axisymmetric space zz is the hoop strain u_r/r.
pub(crate) fn strain(space: Space, nodes: &[usize], gradients: &[[f64; 3]], u: &[f64]) -> [f64; 6] {
    let mut e = [0.0; 6];
    for (&node, g) in nodes.iter().zip(gradients) {
        if space == Space::Solid {
            let [ux, uy, uz] = [u[3 * node], u[3 * node + 1], u[3 * node + 2]];
            e[0] += g[0] * ux;
            e[1] += g[1] * uy;
            e[2] += g[2] * uz;
            e[3] += g[1] * ux + g[0] * uy;
            e[4] += g[2] * uy + g[1] * uz;
            e[5] += g[2] * ux + g[0] * uz;
        } else {
            let [ux, uy] = [u[2 * node], u[2 * node + 1]];
            e[0] += g[0] * ux;
            e[1] += g[1] * uy;
            e[2] += g[2] * ux;
            e[3] += g[1] * ux + g[0] * uy;
        }
    }
    e
}

/// What of a strain is elastic: all but the initial one.
#[inline]
pub(crate) fn elastic(strain: [f64; 6], initial: [f64; 6]) -> [f64; 6] {
    std::array::from_fn(|k| strain[k] - initial[k])
}

/// The B-bar strain: the volume change of `strain` replaced by the given one.
#[inline]
pub(crate) fn with_dilatation(mut strain: [f64; 6], dilatation: f64) -> [f64; 6] {
    let third = (dilatation - (strain[0] + strain[1] + strain[2])) / 3.0;
    for normal in &mut strain[..3] {
        *normal += third;
    }
    strain
}

/// The force on a node with the gradient `g` that balances a stress (per unit of measure).
#[inline]
pub(crate) fn nodal_force(space: Space, stress: [f64; 6], g: [f64; 3]) -> [f64; 3] {
    let [xx, yy, zz, xy, yz, xz] = stress;
    if space == Space::Solid {
        [
            xx * g[0] + xy * g[1] + xz * g[2],
            xy * g[0] + yy * g[1] + yz * g[2],
            xz * g[0] + yz * g[1] + zz * g[2],
        ]
    } else {
        [
            xx * g[0] + xy * g[1] + zz * g[2],
            xy * g[0] + yy * g[1],
            0.0,
        ]
    }
}
