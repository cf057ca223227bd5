//! Reference elements: shape functions, their gradients, and faces.
//!
//! An element maps its reference domain to a cell by x(ξ) = Σ_a φ_a(ξ) x_a
//! (isoparametric). Node and face numbering are VTK's: of quadratic elements the corners come first,
//! numbered like the nodes of the linear element, then the middles of the edges, then the centres of
//! faces and cell where there are any.

#[cfg(test)]
mod conformance;
mod hex20;
mod hex27;
mod hex8;
mod lagrange;
mod line2;
mod line3;
mod mapping;
mod nodes;
mod quad4;
mod quad8;
mod quad9;
mod serendipity;
mod simplex;
mod table;
mod tet10;
mod tet4;
mod tri3;
mod tri6;
mod wedge6;

pub use hex8::Hex8;
pub use hex20::Hex20;
pub use hex27::Hex27;
pub use line2::Line2;
pub use line3::Line3;
pub(crate) use mapping::{Orientation, inverse_jacobian, measure, orientation, physical_gradients};
pub use quad4::Quad4;
pub use quad8::Quad8;
pub use quad9::Quad9;
pub(crate) use table::{ShapeTable, interpolate, jacobian};
pub use tet4::Tet4;
pub use tet10::Tet10;
pub use tri3::Tri3;
pub use tri6::Tri6;
pub use wedge6::Wedge6;

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

impl CellKind {
    /// The reference element.
    pub fn element(self) -> &'static dyn Element {
        match self {
            CellKind::Line2 => &Line2,
            CellKind::Line3 => &Line3,
            CellKind::Tri3 => &Tri3,
            CellKind::Tri6 => &Tri6,
            CellKind::Quad4 => &Quad4,
            CellKind::Quad8 => &Quad8,
            CellKind::Quad9 => &Quad9,
            CellKind::Tet4 => &Tet4,
            CellKind::Tet10 => &Tet10,
            CellKind::Wedge6 => &Wedge6,
            CellKind::Hex8 => &Hex8,
            CellKind::Hex20 => &Hex20,
            CellKind::Hex27 => &Hex27,
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

/// For each node of a kind the corners that it lies amid: itself for a corner.
pub(crate) fn corners_of_nodes(kind: CellKind) -> Vec<Vec<usize>> {
    let mut values = vec![0.0; kind.corner_count()];
    let nodes = kind.element().nodes().iter();
    nodes
        .map(|&xi| {
            kind.linear().element().shape(xi, &mut values);
            (0..values.len()).filter(|&a| values[a] != 0.0).collect()
        })
        .collect()
}
