//! Barycentric coordinates, and the quadratic functions of tri6 and tet10 in them:
//! L_i (2L_i − 1) at the corners, 4 L_i L_j in the middle of the edge between i and j.

/// The V = d + 1 barycentric coordinates 1 − Σ ξ_i, ξ_1, …, ξ_d of a point.
#[inline]
pub(super) fn barycentric<const V: usize>(xi: [f64; 3]) -> [f64; V] {
    let first = 1.0 - xi[..V - 1].iter().sum::<f64>();
    std::array::from_fn(|i| if i == 0 { first } else { xi[i - 1] })
}

/// ∇L_i.
#[inline]
pub(super) fn barycentric_gradient<const V: usize>(i: usize) -> [f64; 3] {
    std::array::from_fn(|j| match i {
        0 if j + 1 < V => -1.0,
        0 => 0.0,
        _ if i == j + 1 => 1.0,
        _ => 0.0,
    })
}

/// Corners first, then the edges' middles.
pub(super) fn quadratic_shape<const V: usize>(
    edges: &[&[usize]],
    xi: [f64; 3],
    values: &mut [f64],
) {
    let l = barycentric::<V>(xi);
    for i in 0..V {
        values[i] = l[i] * (2.0 * l[i] - 1.0);
    }
    for (value, edge) in values[V..].iter_mut().zip(edges) {
        let (i, j) = (edge[0], edge[1]);
        *value = 4.0 * l[i] * l[j];
    }
}

/// Gradients of [`quadratic_shape`].
pub(super) fn quadratic_gradients<const V: usize>(
    edges: &[&[usize]],
    xi: [f64; 3],
    gradients: &mut [[f64; 3]],
) {
    let l = barycentric::<V>(xi);
    for i in 0..V {
        gradients[i] = barycentric_gradient::<V>(i).map(|g| (4.0 * l[i] - 1.0) * g);
    }
    for (gradient, edge) in gradients[V..].iter_mut().zip(edges) {
        let (i, j) = (edge[0], edge[1]);
        let (gi, gj) = (barycentric_gradient::<V>(i), barycentric_gradient::<V>(j));
        *gradient = std::array::from_fn(|k| 4.0 * (l[i] * gj[k] + l[j] * gi[k]));
    }
}
