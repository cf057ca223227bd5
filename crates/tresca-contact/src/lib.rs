//! Geometry of contact: surfaces, pairing, local frames, gaps and friction data.
//!
//! In go two meshed bodies and the surfaces that may touch, or one body and an obstacle; out
//! comes [`ContactData`]: the coupling matrix B = \[N; T\] of each side, the
//! initial normal gaps d, the local frames, the areas and what the friction law
//! is for each pair.
//! No algorithm of contact lives here: who solves the problem, and how, this
//! crate does not know.
//!
//! - [`couple`] chooses between [`couple_node_by_node`], for surfaces whose nodes lie on one another, and
//!   mortar coupling with dual multipliers, for any two surfaces that face each other.
//! - [`couple_obstacle`] has a plane, sphere, cylinder or rigid surface for a partner.
//! - [`facing_surfaces`] finds the surfaces.
//! - A pair belongs to a slave node and a smooth patch of its surface; [`patches`] cuts a surface at its edges.
//!
//! Whatever the coupling, λν of a pair is a force, λν over the pair's area the pressure, d a length. The
//! formulas of mortar coupling, and where they come from, stand in `docs/mortar.md`:
//!
//! ```text
//! N_j u = (1/a_j) ( Σ_k D_jk ν_j·u_s,k − Σ_l M_jl ν_j·u_m,l )      D_jk = ∫ ψ_j φ_k,  M_jl = ∫ ψ_j φ^m_l
//! d_j   = (1/a_j) ∫ ψ_j ν·(x_m − x_s)                              a_j  = ∫ ψ_j,      Σ ψ_j = 1
//! ```
//!
//! Conventions, everywhere in the workspace:
//! - the *slave* side carries the contact forces; the unit normal ν points out of the slave body;
//! - N u = ν·(u_slave − u_master) is the approach of the two surfaces, d the initial gap, and
//!   N u ≤ d says that they do not penetrate;
//! - T u is the relative tangential displacement in the frame (τ1, τ2), slave minus master; in the
//!   plane τ1 alone;
//! - λ = \[λν; λτ\] with m normal forces first and then the m pairs (τ1, τ2), in the plane m
//!   tangential forces.

mod coupling;
mod data;
mod error;
mod facing;
mod frame;
mod friction;
mod geometry;
mod interface;
mod pair;
mod scalar_field;
mod surface;

pub use coupling::choice::{CouplingMethod, couple};
pub use coupling::node_by_node::couple_node_by_node;
pub use coupling::obstacle::couple::couple_obstacle;
pub use coupling::obstacle::shape::{RigidShape, RigidSurface};
pub use data::{ContactData, Discretization, SharedNode};
pub use error::ContactError;
pub use facing::facing_surfaces;
pub use frame::Frame;
pub use friction::{FrictionLaw, Opening, Sliding};
pub use interface::{Interface, Side};
pub use pair::contact_pair::ContactPair;
pub use pair::mobility::Mobility;
pub use scalar_field::ScalarField;
pub use surface::nodes::{ContactSurface, SurfaceNode};
pub use surface::patches::{SmoothPatches, patches};
