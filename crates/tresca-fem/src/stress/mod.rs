//! Stresses of a displacement, and quantities made of them.
//!
//! Stress components are in the order xx, yy, zz, xy, yz, xz. In the plane zz is the stress across it,
//! ν(σ_xx + σ_yy) under plane strain and 0 under plane stress; in an axisymmetric space xx is radial,
//! yy axial and zz the hoop stress. All functions need a mesh and a material that assembly accepted.

mod fit;
mod recovery;
pub(crate) mod sample;

pub use recovery::recover;
pub use sample::{StressSample, samples, strain_energy, von_mises};
