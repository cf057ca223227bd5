//! The quadratic serendipity functions of quad8 and hex20: nodes at corners and edge middles only.
//!
//! Zienkiewicz, Taylor: *The Finite Element Method*, vol. 1, section 6.5 ("serendipity" family): with
//! a the node's coordinates, s_i = 1 + a_i ξ_i, and 1 − ξ_i² along the edge of a middle node,
//!
//! - corner:  φ = 2⁻ᵈ ∏ s_i (Σ a_i ξ_i − (d − 1)),
//! - middle:  φ = 2¹⁻ᵈ ∏ s_i  (one factor being 1 − ξ_i²).

/// Factor of one axis and its derivative.
#[inline]
fn factor(node: f64, x: f64) -> (f64, f64) {
    if node == 0.0 {
        (1.0 - x * x, -2.0 * x)
    } else {
        (1.0 + node * x, node)
    }
}

/// The last factor of a corner, Σ a_i ξ_i − (d − 1); `None` for the middle of an edge.
#[inline]
fn corner_factor<const D: usize>(node: &[f64; 3], xi: [f64; 3]) -> Option<f64> {
    let corner = (0..D).all(|i| node[i] != 0.0);
    corner.then(|| (0..D).map(|i| node[i] * xi[i]).sum::<f64>() - (D - 1) as f64)
}

/// φ_a(ξ).
pub(super) fn shape<const D: usize>(nodes: &[[f64; 3]], xi: [f64; 3], values: &mut [f64]) {
    let weight = 0.5_f64.powi(D as i32);
    for (value, node) in values.iter_mut().zip(nodes) {
        let product: f64 = (0..D).map(|i| factor(node[i], xi[i]).0).product();
        *value = weight * product * corner_factor::<D>(node, xi).unwrap_or(2.0);
    }
}

/// ∂φ_a/∂ξ_j.
pub(super) fn gradients<const D: usize>(
    nodes: &[[f64; 3]],
    xi: [f64; 3],
    gradients: &mut [[f64; 3]],
) {
    let weight = 0.5_f64.powi(D as i32);
    for (gradient, node) in gradients.iter_mut().zip(nodes) {
        let factors: [(f64, f64); D] = std::array::from_fn(|i| factor(node[i], xi[i]));
        let product: f64 = factors.iter().map(|f| f.0).product();
        let last = corner_factor::<D>(node, xi);
        *gradient = [0.0; 3];
        for j in 0..D {
            let derived: f64 = (0..D)
                .map(|i| if i == j { factors[i].1 } else { factors[i].0 })
                .product();
            let of_last = if last.is_some() {
                node[j] * product
            } else {
                0.0
            };
            gradient[j] = weight * (derived * last.unwrap_or(2.0) + of_last);
        }
    }
}
