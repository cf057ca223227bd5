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
pub(crate) mod kinds;
mod lagrange;
mod line2;
mod line3;
pub(crate) mod mapping;
mod nodes;
mod quad4;
mod quad8;
mod quad9;
pub(crate) mod reference;
mod serendipity;
mod simplex;
pub(crate) mod table;
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
pub use quad4::Quad4;
pub use quad8::Quad8;
pub use quad9::Quad9;
pub use reference::{Element, ReferenceFace};
pub use tet4::Tet4;
pub use tet10::Tet10;
pub use tri3::Tri3;
pub use tri6::Tri6;
pub use wedge6::Wedge6;
