//! Integration over one cell.

use super::formulation::Formulation;
use crate::element::mapping::inverse_jacobian;
use crate::element::table::{ShapeTable, interpolate};
use crate::material::Isotropic;
use crate::mesh::kind::CellKind;
use crate::mesh::space::Space;

/// Index pairs i ≤ j of the six stored gradient products.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
/// Where the product (i, j) or its transpose is stored.
const PAIR_OF: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];

/// The element stiffness of cells with N nodes of D displacement components.
///
/// All that a cell needs of the geometry are the products H^ij_ab = ∫ ∂_i φ_a ∂_j φ_b dΩ. The
/// material enters once per cell, after integration:
///
/// K_(ai)(bj) = λ H^ij_ab + μ H^ji_ab + μ δ_ij Σ_k H^kk_ab.
///
/// In an axisymmetric space the third "gradient" is ψ_a = φ_a/r, which makes the hoop strain. It
/// belongs to the radial component, so that the divergence of φ_a e_i is ∂_i φ_a + δ_i0 ψ_a: see
/// [`Kernel::block`]. In the plane it is zero.
///
/// With B-bar strains the energy splits into κ θ̄² |Ω_c| and that of the deviator, which is the full one
/// of a material with λ = −2μ/3. So K is the above with that λ, plus κ m_ai m_bj / |Ω_c| with
/// m_ai = ∫ div(φ_a e_i) dΩ.
pub(crate) struct Kernel<const N: usize, const D: usize> {
    space: Space,
    lambda: f64,
    mu: f64,
    /// The bulk modulus κ = λ + 2μ/3 with B-bar strains, else zero.
    bulk: f64,
    table: ShapeTable,
    /// H^ij for the pairs i ≤ j; H^ji_ab = H^ij_ba.
    products: [[[f64; N]; N]; 6],
    /// m_ai; with B-bar strains only.
    divergence: [[f64; D]; N],
    /// κ / |Ω_c|; with B-bar strains only.
    bulk_by_volume: f64,
}

impl<const N: usize, const D: usize> Kernel<N, D> {
    pub fn new(
        space: Space,
        kind: CellKind,
        (material, formulation): (&Isotropic, Formulation),
    ) -> Self {
        assert_eq!((kind.node_count(), space.dimension()), (N, D));
        let mu = material.mu();
        let (lambda, bulk) = match formulation {
            Formulation::Full => (material.effective_lambda(), 0.0),
            Formulation::BBar => (-2.0 * mu / 3.0, material.lambda() + 2.0 * mu / 3.0),
        };
        Self {
            space,
            lambda,
            mu,
            bulk,
            table: ShapeTable::stiffness(kind),
            products: [[[0.0; N]; N]; 6],
            divergence: [[0.0; D]; N],
            bulk_by_volume: 0.0,
        }
    }

    /// Integrates the products of a cell; `None` where its Jacobian is not positive.
    pub fn integrate(&mut self, points: &[[f64; 3]; N]) -> Option<()> {
        self.products = [[[0.0; N]; N]; 6];
        self.divergence = [[0.0; D]; N];
        let mut volume = 0.0;
        for q in 0..self.table.len() {
            let (rows, determinant) = inverse_jacobian::<D>(self.table.gradients(q), points)?;
            let mut weight = self.table.weights[q] * determinant;
            // By component, so that the loop over b below runs over contiguous numbers.
            let mut gradients = [[0.0; N]; 3];
            for (a, g) in self.table.gradients(q).iter().enumerate() {
                for i in 0..3 {
                    gradients[i][a] = g[0] * rows[0][i] + g[1] * rows[1][i] + g[2] * rows[2][i];
                }
            }
            if D == 2 && self.space == Space::Axisymmetric {
                let values = self.table.values(q);
                let x = interpolate(values, points);
                weight *= self.space.circumference(x);
                for (psi, value) in gradients[2].iter_mut().zip(values) {
                    *psi = value / x[0];
                }
            }
            if self.bulk != 0.0 {
                volume += weight;
                for (a, m) in self.divergence.iter_mut().enumerate() {
                    for i in 0..D {
                        m[i] += weight * gradients[i][a];
                    }
                    if D == 2 {
                        m[0] += weight * gradients[2][a];
                    }
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
        if self.bulk != 0.0 {
            self.bulk_by_volume = self.bulk / volume;
        }
        Some(())
    }

    /// The D×D block K_ab of the cell integrated last, `[i][j]`.
    #[inline]
    pub fn block(&self, a: usize, b: usize) -> [[f64; D]; D] {
        let h = |i: usize, j: usize| {
            let product = &self.products[PAIR_OF[i][j]];
            if i <= j { product[a][b] } else { product[b][a] }
        };
        let trace = self.mu * (0..D).fold(0.0, |sum, k| sum + h(k, k));
        let mut block = [[0.0; D]; D];
        for i in 0..D {
            for j in 0..D {
                block[i][j] = self.lambda * h(i, j) + self.mu * h(j, i);
            }
            block[i][i] += trace;
        }
        if D == 2 {
            // What ψ adds to λ div(φ_a e_i) div(φ_b e_j), and 2μ ψ_a ψ_b.
            for k in 0..2 {
                block[0][k] += self.lambda * h(2, k);
                block[k][0] += self.lambda * h(k, 2);
            }
            block[0][0] += (self.lambda + 2.0 * self.mu) * h(2, 2);
        }
        if self.bulk_by_volume != 0.0 {
            for i in 0..D {
                let left = self.bulk_by_volume * self.divergence[a][i];
                for j in 0..D {
                    block[i][j] += left * self.divergence[b][j];
                }
            }
        }
        block
    }
}
