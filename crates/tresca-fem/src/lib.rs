//! Finite elements for `tresca`: meshes, reference elements, materials,
//! supports, dof numbering, assembly, loads and stress recovery for linear
//! elastic bodies with small displacements.
//!
//! Conventions shared by the whole crate:
//!
//! - **Space** is data: [`mesh::Space`] says whether a mesh is a solid, a plane body
//!   (plane strain, or plane stress by choice of the material) or the meridian section
//!   of a body of revolution, with x the radius and y the axis.
//! - **Points and vectors** are `[f64; 3]` in any space; in two dimensions
//!   the third entry is zero.
//! - **Measures** (volumes, areas, loads, stiffness) are per unit thickness in the plane
//!   and those of the full circumference in an axisymmetric space.
//! - **Full dofs** are interleaved by node: `dimension * node + component`.
//!   A vector over the full dofs describes a body; a vector over the *free*
//!   dofs (see [`dofs::DofMap`]) is what the linear solver sees.
//! - **Stress and strain** have the order xx, yy, zz, xy, yz, xz; shear
//!   strains are the engineering ones, γ = 2ε. In an axisymmetric space xx is
//!   radial, yy axial, and zz the hoop component.
//! - **Units** are the caller's, as long as they are consistent (mm, N, MPa or
//!   m, N, Pa or m, MN, MPa).
//! - **Determinism**: every result is the same bit for bit, whatever the number
//!   of rayon threads.

// Loops over components i, j, k are written as in the formulas.
#![allow(clippy::needless_range_loop)]

pub mod assembly;
pub mod constraints;
pub mod dofs;
pub mod element;
mod error;
pub mod initial_strain;
pub mod loads;
pub mod material;
mod matrix3;
pub mod mesh;
pub mod quadrature;
pub mod rigid;
pub mod stress;
pub mod supports;
pub mod vector3;

pub use error::FemError;
