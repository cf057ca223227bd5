//! Affine constraints between the dofs of one body, u = C û + u⁰.
//!
//! An [`Equation`] Σ a_k u_k = b takes one dof away, its *dependent* one. [`crate::dofs::DofMap::constrained`]
//! resolves a list of them together with the supports: what is left are the free dofs û, and every full
//! vector is
//!
//! <div>
//! $$
//! u = C \hat u + u^0
//! $$
//! </div>
//!
//! with one row of C per full dof: a unit row for a free dof, a zero row for a held one, the resolved
//! equation for a dependent one; u⁰ has the held displacements and what the equations make of them and of
//! their right sides. Stiffness, loads and rows of contact follow:
//!
//! <div>
//! $$
//! \hat K = C^T K C, \qquad \hat f = C^T (f - K u^0), \qquad \hat B = B\, C.
//! $$
//! </div>
//!
//! All of it is behind the doors of [`crate::dofs::DofMap`]; a body without equations pays nothing.
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
pub(crate) mod elimination;
pub(crate) mod equation;
mod pairs;

pub use coupling::{ReferencePoint, distributing, rigid};
pub use equation::{Dof, Equation};
pub use pairs::{cyclic, periodic, pretension};
