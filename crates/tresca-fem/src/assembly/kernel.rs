//! Integration over one cell.

use crate::element::{ShapeTable, jacobian};
use crate::material::Isotropic;
use crate::mesh::CellKind;
use crate::tensor::{determinant, inverse_rows, norm};

/// det J counts as zero below this fraction of its largest possible value, ∏ ‖∂x/∂ξ_j‖. The ratio
/// does not know the cell's size or aspect, only how flat the angles are; rounding makes 1e-16.
const FLAT: f64 = 1e-12;

/// Index pairs i ≤ j of the six stored gradient products.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
/// Where the product (i, j) or its transpose is stored.
const PAIR_OF: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];

/// The element stiffness of cells with N nodes.
///
/// All that a cell needs of the geometry are the products H^ij_ab = ∫ ∂_i φ_a ∂_j φ_b dΩ. The
/// material enters once per cell, after integration:
///
/// K_(ai)(bj) = λ H^ij_ab + μ H^ji_ab + μ δ_ij Σ_k H^kk_ab.
pub(crate) struct Kernel<const N: usize> {
    lambda: f64,
    mu: f64,
    table: ShapeTable,
    /// H^ij for the pairs i ≤ j; H^ji_ab = H^ij_ba.
    products: [[[f64; N]; N]; 6],
}

impl<const N: usize> Kernel<N> {
    pub fn new(kind: CellKind, material: &Isotropic) -> Self {
        assert_eq!(kind.node_count(), N);
        Self {
            lambda: material.lambda(),
            mu: material.mu(),
            table: ShapeTable::full(kind),
            products: [[[0.0; N]; N]; 6],
        }
    }

    /// Integrates the products of a cell; the error is a Jacobian determinant that is not positive.
    pub fn integrate(&mut self, points: &[[f64; 3]; N]) -> Result<(), f64> {
        self.products = [[[0.0; N]; N]; 6];
        for q in 0..self.table.len() {
            let (rows, determinant) = inverse_jacobian(self.table.gradients(q), points)?;
            let weight = self.table.weights[q] * determinant;
            // By component, so that the loop over b below runs over contiguous numbers.
            let mut gradients = [[0.0; N]; 3];
            for (a, g) in self.table.gradients(q).iter().enumerate() {
                for i in 0..3 {
                    gradients[i][a] = g[0] * rows[0][i] + g[1] * rows[1][i] + g[2] * rows[2][i];
                }
            }
            for (product, (i, j)) in self.products.iter_mut().zip(PAIRS) {
                for a in 0..N {
                    let left = weight * gradients[i][a];
                    for b in 0..N {
                        product[a][b] += left * gradients[j][b];
                    }
                }
            }
        }
        Ok(())
    }

    /// The 3×3 block K_ab of the cell integrated last, `[i][j]`.
    #[inline]
    pub fn block(&self, a: usize, b: usize) -> [[f64; 3]; 3] {
        let h = |i: usize, j: usize| {
            let product = &self.products[PAIR_OF[i][j]];
            if i <= j { product[a][b] } else { product[b][a] }
        };
        let trace = self.mu * (h(0, 0) + h(1, 1) + h(2, 2));
        let mut block = [[0.0; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                block[i][j] = self.lambda * h(i, j) + self.mu * h(j, i);
            }
            block[i][i] += trace;
        }
        block
    }
}

/// Rows ∇ξ_j of the inverse Jacobian and det J; the error is a det J that is not positive.
#[inline]
fn inverse_jacobian(
    gradients: &[[f64; 3]],
    points: &[[f64; 3]],
) -> Result<([[f64; 3]; 3], f64), f64> {
    let columns = jacobian(gradients, points);
    let det = determinant(&columns);
    let largest = norm(columns[0]) * norm(columns[1]) * norm(columns[2]);
    // Written so that NaN is refused too.
    if det > FLAT * largest {
        Ok((inverse_rows(&columns, det), det))
    } else {
        Err(det)
    }
}

/// ∇φ_a in physical coordinates at point q, written to `physical`; returns det J, or as the error a
/// det J that is not positive.
pub(crate) fn physical_gradients(
    table: &ShapeTable,
    q: usize,
    points: &[[f64; 3]],
    physical: &mut [[f64; 3]],
) -> Result<f64, f64> {
    let (rows, determinant) = inverse_jacobian(table.gradients(q), points)?;
    for (p, g) in physical.iter_mut().zip(table.gradients(q)) {
        *p = std::array::from_fn(|i| g[0] * rows[0][i] + g[1] * rows[1][i] + g[2] * rows[2][i]);
    }
    Ok(determinant)
}

/// Strain xx, yy, zz, γxy, γyz, γxz of the displacements `u` (full dofs) at a point with the given
/// gradients.
pub(crate) fn strain(nodes: &[usize], gradients: &[[f64; 3]], u: &[f64]) -> [f64; 6] {
    let mut e = [0.0; 6];
    for (&node, g) in nodes.iter().zip(gradients) {
        let [ux, uy, uz] = [u[3 * node], u[3 * node + 1], u[3 * node + 2]];
        e[0] += g[0] * ux;
        e[1] += g[1] * uy;
        e[2] += g[2] * uz;
        e[3] += g[1] * ux + g[0] * uy;
        e[4] += g[2] * uy + g[1] * uz;
        e[5] += g[2] * ux + g[0] * uz;
    }
    e
}
