//! Shape functions tabulated at the points of a rule, once per element kind.

use crate::mesh::kind::CellKind;
use crate::quadrature::Rule;

/// φ_a and ∂φ_a/∂ξ at every point q of a rule.
#[derive(Clone, Debug)]
pub(crate) struct ShapeTable {
    /// Nodes per element.
    pub nodes: usize,
    /// Weight of each point.
    pub weights: Vec<f64>,
    values: Vec<f64>,
    gradients: Vec<[f64; 3]>,
}

impl ShapeTable {
    /// Tabulates `kind` at the points of `rule`.
    pub fn new(kind: CellKind, rule: &Rule) -> Self {
        let nodes = kind.node_count();
        let mut values = vec![0.0; nodes * rule.points.len()];
        let mut gradients = vec![[0.0; 3]; nodes * rule.points.len()];
        for (q, &xi) in rule.points.iter().enumerate() {
            let range = q * nodes..(q + 1) * nodes;
            kind.element().shape(xi, &mut values[range.clone()]);
            kind.element().gradients(xi, &mut gradients[range]);
        }
        Self {
            nodes,
            weights: rule.weights.clone(),
            values,
            gradients,
        }
    }

    /// Tabulates `kind` at the points of its stiffness rule.
    pub fn stiffness(kind: CellKind) -> Self {
        Self::new(kind, &kind.element().rule())
    }

    /// Tabulates `kind` at the points of its mass rule: for loads, areas and volumes.
    pub fn mass(kind: CellKind) -> Self {
        Self::new(kind, &kind.element().mass_rule())
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.weights.len()
    }

    /// φ_a at point q, by a.
    pub fn values(&self, q: usize) -> &[f64] {
        &self.values[q * self.nodes..(q + 1) * self.nodes]
    }

    /// ∂φ_a/∂ξ at point q, by a.
    pub fn gradients(&self, q: usize) -> &[[f64; 3]] {
        &self.gradients[q * self.nodes..(q + 1) * self.nodes]
    }
}

/// Columns ∂x/∂ξ_j of the Jacobian of a cell with the nodes at `points`.
///
/// Columns beyond the element's dimension are zero.
#[inline]
pub(crate) fn jacobian(gradients: &[[f64; 3]], points: &[[f64; 3]]) -> [[f64; 3]; 3] {
    let mut columns = [[0.0; 3]; 3];
    for (g, x) in gradients.iter().zip(points) {
        for j in 0..3 {
            for i in 0..3 {
                columns[j][i] += g[j] * x[i];
            }
        }
    }
    columns
}

/// Σ_a φ_a x_a.
#[inline]
pub(crate) fn interpolate(values: &[f64], points: &[[f64; 3]]) -> [f64; 3] {
    let mut x = [0.0; 3];
    for (v, p) in values.iter().zip(points) {
        for i in 0..3 {
            x[i] += v * p[i];
        }
    }
    x
}
