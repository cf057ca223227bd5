//! The result of the geometry: coupling matrices, gaps, frames, areas, friction data.

use faer::sparse::SparseRowMat;

use crate::frame::Frame;
use crate::friction::Sliding;
use crate::pair::mobility::Mobility;

/// What the rows of B stand for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Discretization {
    /// Two nodes that lie on one another.
    NodeByNode,
    /// A dual multiplier of the slave surface, tested against both surfaces.
    Mortar,
    /// A rigid obstacle in front of the slave surface.
    Obstacle,
}

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

/// A node of a slave surface whose pair belongs to another contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SharedNode {
    /// Node of the slave mesh.
    pub node: usize,
    /// The area that would have been its own here.
    pub area: f64,
    /// The unit normal there, out of the slave body.
    pub normal: [f64; 3],
}

/// What the dual problem needs to know of one contact.
#[derive(Debug, Clone)]
pub struct ContactData {
    /// The m pairs.
    pub pairs: Vec<ContactPair>,
    /// Slave part of B = \[N; T\]: d m × full dofs of the slave body, d the space dimension.
    pub slave_coupling: SparseRowMat<usize, f64>,
    /// Master part of B, d m × full dofs of the master body (its signs included); `None` for an
    /// obstacle.
    pub master_coupling: Option<SparseRowMat<usize, f64>>,
    /// What the rows stand for.
    pub discretization: Discretization,
    /// Area of the slave surface that has a partner, held nodes included.
    pub overlap_area: f64,
    /// Nodes of the slave surface that have no pair because (almost) nothing faces them, ascending;
    /// without those of [`Side::taken`].
    pub uncoupled: Vec<usize>,
    /// Nodes of the slave surface whose pair belongs to another contact (node by node; mortar coupling gives
    /// their share to the neighbours).
    pub shared: Vec<SharedNode>,
    /// Pairs left out because supports hold both nodes, or (mortar, obstacles) the normal of the slave node;
    /// the share of the surface that belongs to such a slave node is with its neighbours.
    pub held_pairs: usize,
}

impl ContactData {
    /// The least and the largest gap; `None` without pairs.
    pub fn gap_range(&self) -> Option<[f64; 2]> {
        let gaps = || self.pairs.iter().map(|pair| pair.gap);
        let least = gaps().reduce(f64::min)?;
        Some([least, gaps().reduce(f64::max)?])
    }
}
