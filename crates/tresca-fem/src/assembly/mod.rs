//! Assembly of the stiffness matrix and of internal forces.
//!
//! K_(ai)(bj) = ∫ ε(φ_a e_i) : C : ε(φ_b e_j) dΩ over the free dofs, with the stiffness rule of
//! every element and the strain of the [`Formulation`]. How it is done:
//!
//! 1. The nodes are cut into ranges; each range owns its columns of K, which are contiguous.
//! 2. Each range finds its pattern from the cells around its nodes.
//! 3. Each range runs over the cells that touch it, in ascending order, and adds their columns.
//!
//! A cell at the border of two ranges is integrated twice, which costs little because the work of
//! a cell is small. In return nothing is shared, no triplets are sorted, memory is the matrix
//! itself, and every entry is summed in the order of the cells: the result does not depend on the
//! number of ranges or threads, bit for bit.

mod columns;
mod constrained;
pub(crate) mod formulation;
pub(crate) mod internal;
mod kernel;
pub(crate) mod stiffness;
pub(crate) mod strain;
pub(crate) mod sum;

pub use formulation::Formulation;
pub use internal::{initial_strain_load, internal_forces, reduced_load};
pub use stiffness::stiffness;
