//! Reference elements: shape functions, their gradients, and faces.
//!
//! An element maps its reference domain to a cell by x(ξ) = Σ_a φ_a(ξ) x_a
//! (isoparametric). Node and face numbering are VTK's.

#[cfg(test)]
mod conformance;
mod hex8;
mod line2;
mod mapping;
mod quad4;
mod table;
mod tri3;

pub use hex8::Hex8;
pub use line2::Line2;
pub(crate) use mapping::{inverse_jacobian, physical_gradients};
pub use quad4::Quad4;
pub(crate) use table::{ShapeTable, interpolate, jacobian};
pub use tri3::Tri3;

use crate::mesh::CellKind;
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

    /// The rule of full integration: exact for the stiffness, and for the mass matrix, of
    /// an affine cell, and for the volume of any cell.
    fn rule(&self) -> Rule;

    /// Points at which the strain of the discrete solution is of higher accuracy than elsewhere
    /// (Barlow points); stress recovery samples there.
    fn stress_points(&self) -> Rule;
}

impl CellKind {
    /// The reference element.
    pub fn element(self) -> &'static dyn Element {
        match self {
            CellKind::Line2 => &Line2,
            CellKind::Tri3 => &Tri3,
            CellKind::Quad4 => &Quad4,
            CellKind::Hex8 => &Hex8,
        }
    }

    /// Number of nodes.
    pub fn node_count(self) -> usize {
        self.element().nodes().len()
    }

    /// Dimension of the reference domain.
    pub fn dimension(self) -> usize {
        self.element().dimension()
    }

    /// The faces of a cell of this kind.
    pub fn faces(self) -> &'static [ReferenceFace] {
        self.element().faces()
    }
}
