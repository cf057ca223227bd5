//! Products of quadratic polynomials on [−1, 1], the shape functions of line3, quad9 and hex27.

/// The quadratic polynomial that is 1 at `node` and 0 at the other two of −1, 0, 1: value and
/// derivative at x.
#[inline]
fn quadratic(node: f64, x: f64) -> (f64, f64) {
    if node == 0.0 {
        (1.0 - x * x, -2.0 * x)
    } else {
        (0.5 * x * (x + node), x + 0.5 * node)
    }
}

/// φ_a(ξ) = ∏ of the polynomials of the node's coordinates along the first `D` axes.
pub(super) fn shape<const D: usize>(nodes: &[[f64; 3]], xi: [f64; 3], values: &mut [f64]) {
    for (value, node) in values.iter_mut().zip(nodes) {
        *value = (0..D).map(|i| quadratic(node[i], xi[i]).0).product();
    }
}

/// ∂φ_a/∂ξ_j of [`shape`].
pub(super) fn gradients<const D: usize>(
    nodes: &[[f64; 3]],
    xi: [f64; 3],
    gradients: &mut [[f64; 3]],
) {
    for (gradient, node) in gradients.iter_mut().zip(nodes) {
        let factors: [(f64, f64); D] = std::array::from_fn(|i| quadratic(node[i], xi[i]));
        *gradient = [0.0; 3];
        for j in 0..D {
            gradient[j] = (0..D)
                .map(|i| if i == j { factors[i].1 } else { factors[i].0 })
                .product();
        }
    }
}
