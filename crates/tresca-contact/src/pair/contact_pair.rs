//! What a contact pair is.

use super::mobility::Mobility;
use crate::frame::Frame;
use crate::friction::Sliding;

/// A contact pair: a slave node, on one smooth patch of its surface, and what faces it.
///
/// In all discretizations λν is a force, λν / `area` the pressure, `gap` a length.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPair {
    /// Node of the slave mesh. It can have other pairs, on other patches.
    pub slave_node: usize,
    /// The smooth patch of the slave surface that the pair stands on; 0 where the surface is one patch.
    pub patch: usize,
    /// Node of the master mesh, where the coupling is node by node.
    pub master_node: Option<usize>,
    /// Position of the slave node.
    pub point: [f64; 3],
    /// Local frame, ν out of the slave body. In the plane τ1 lies in the plane. A motion v of the whole
    /// partner changes the gap by ν·v and the slip by −(τ1·v, τ2·v).
    pub frame: Frame,
    /// The directions of the frame in which the supports let the pair move.
    pub mobility: Mobility,
    /// Initial normal gap d; negative where the surfaces overlap. With mortar coupling and obstacles
    /// the mean (1/a_j) ∫ ψ_j g over the part of the surface that belongs to the pair.
    pub gap: f64,
    /// The area that belongs to the pair: ∫ φ_i over the slave surface, or ∫ ψ_j over the part of it
    /// that the master covers.
    pub area: f64,
    /// What it may do along its tangents.
    pub sliding: Sliding,
}
