//! Dofs and the equations between them.

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
