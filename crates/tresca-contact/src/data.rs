//! The result of the geometry: coupling matrices, gaps, frames, areas, friction data.

use faer::sparse::SparseRowMat;

use crate::pair::contact_pair::ContactPair;

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
#[non_exhaustive]
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
    /// without those of [`crate::Side::taken`].
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
