//! What a reference element is.

use crate::mesh::kind::CellKind;
use crate::quadrature::Rule;

/// A face of a reference element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReferenceFace {
    /// The face's own element, of one dimension less.
    pub kind: CellKind,
    /// The element's nodes that are the face element's nodes 0, 1, 2, …, in the order
    /// that makes the normal ∂x/∂ξ₁ × ∂x/∂ξ₂ (in the plane: the tangent turned
    /// clockwise) point outwards.
    pub nodes: &'static [usize],
}

/// A Lagrange reference element.
///
/// With n nodes at ξ_b, the shape functions φ_a, a = 0 … n−1, satisfy
///
/// - φ_a(ξ_b) = δ_ab,   Σ_a φ_a = 1,   Σ_a ∇φ_a = 0,
/// - every linear field is reproduced by its nodal values.
///
/// Each implementation passes the list of checks in `element::conformance` by one call.
pub trait Element: Sync {
    /// Dimension d of the reference domain; coordinates beyond it are zero.
    fn dimension(&self) -> usize;

    /// Reference coordinates of the nodes.
    fn nodes(&self) -> &'static [[f64; 3]];

    /// Writes φ_a(ξ) to `values[a]`; `values` has one entry per node.
    fn shape(&self, xi: [f64; 3], values: &mut [f64]);

    /// Writes ∂φ_a/∂ξ_j at ξ to `gradients[a][j]`, zeros for j ≥ d.
    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]);

    /// The faces (edges in the plane), empty for a line.
    fn faces(&self) -> &'static [ReferenceFace];

    /// The rule of full integration for the stiffness: exact on an affine cell, and of enough points
    /// that rigid motions alone cost no energy.
    fn rule(&self) -> Rule;

    /// The rule for everything else: exact for the mass matrix of an affine cell, for the volume of any
    /// cell, and on a face for ∫ φ_a n dΓ, curved or not. Where [`Element::rule`] does as well it is the
    /// same one; on quadratic simplices, whose stiffness is of lower degree, it has more points.
    fn mass_rule(&self) -> Rule {
        self.rule()
    }

    /// Points at which the strain of the discrete solution is of higher accuracy than elsewhere
    /// (Barlow points); stress recovery samples there.
    fn stress_points(&self) -> Rule;
}
