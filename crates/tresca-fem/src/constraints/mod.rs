//! Affine constraints between the dofs of one body, u = C û + u⁰.
//!
//! An [`Equation`] Σ a_k u_k = b takes one dof away, its *dependent* one. [`crate::dofs::DofMap::constrained`]
//! resolves a list of them together with the supports: what is left are the free dofs û, and every full
//! vector is
//!
//! u = C û + u⁰
//!
//! with one row of C per full dof: a unit row for a free dof, a zero row for a held one, the resolved
//! equation for a dependent one; u⁰ has the held displacements and what the equations make of them and of
//! their right sides. Stiffness, loads and rows of contact follow: K̂ = CᵀKC, f̂ = Cᵀ(f − K u⁰), B C. All of it is
//! behind the doors of [`crate::dofs::DofMap`]; a body without equations pays nothing.
//!
//! **Signs.** With the multiplier μ of an equation, the force that it puts on the body at dof k is μ a_k:
//! K u − f = Σ μ a + the reactions of the supports. See [`crate::dofs::DofMap::multipliers`].
//!
//! **Dofs beyond the mesh.** Nodes with numbers from [`crate::mesh::Mesh::node_count`] on are not in the mesh
//! and have no stiffness of their own: displacement and rotation of a [`ReferencePoint`], the shortening of a
//! bolt. Supports are made for all of them, `Supports::new(mesh.node_count() + extra, dimension)`; loads over
//! the full dofs are as much longer (a force and a moment at a reference point). Such an amount, held by a
//! support, is also how the right side of equations changes from load step to load step.
//!
//! Constructors: [`rigid`], [`distributing`], [`periodic`], [`cyclic`], [`pretension`]; whatever else is linear is
//! a list of equations.

mod coupling;
mod elimination;
mod pairs;

pub use coupling::{ReferencePoint, distributing, rigid};
pub(crate) use elimination::{Elimination, ResolvedRow};
pub use pairs::{cyclic, periodic, pretension};

use std::fmt;

/// A displacement component of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Dof {
    /// The node; from the mesh's node count on one that is not in the mesh.
    pub node: usize,
    /// The component: 0, 1 or 2.
    pub component: usize,
}

impl Dof {
    /// A component of a node.
    pub fn new(node: usize, component: usize) -> Self {
        Self { node, component }
    }

    /// The number among the full dofs of `components` per node.
    pub fn full(self, components: usize) -> usize {
        components * self.node + self.component
    }
}

impl fmt::Display for Dof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "component {} of node {}", self.component, self.node)
    }
}

/// Σ a_k u_k = b between dofs of one body, which determines its dependent dof.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The dofs with their coefficients; the first is the dependent one. A dof may stand more than once:
    /// its coefficients add up.
    pub terms: Vec<(Dof, f64)>,
    /// The right side b.
    pub value: f64,
}

impl Equation {
    /// Σ a_k u_k = b; the first dof is the dependent one.
    pub fn new(terms: Vec<(Dof, f64)>, value: f64) -> Self {
        Self { terms, value }
    }

    /// u = Σ c_k u_k of the given dependent dof.
    pub fn dependent(dof: Dof, on: impl IntoIterator<Item = (Dof, f64)>) -> Self {
        let others = on.into_iter().map(|(dof, c)| (dof, -c));
        Self::new(std::iter::once((dof, 1.0)).chain(others).collect(), 0.0)
    }
}
