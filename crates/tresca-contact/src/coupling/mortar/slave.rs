//! The slave side of a mortar coupling.

use std::ops::Range;

use crate::error::ContactError;
use crate::geometry::faces::FaceShapes;
use crate::interface::Side;
use crate::pair::mobility::restrained_frame;
use crate::surface::nodes::{ContactSurface, SurfaceNode};

/// A slave surface, ready for integration.
pub(crate) struct SlaveSurface<'a> {
    /// What was given.
    pub side: Side<'a>,
    /// Its nodes.
    pub surface: ContactSurface,
    /// Its faces.
    pub faces: FaceShapes,
    /// Which of `surface.nodes` have their multipliers in another contact.
    pub taken: Vec<bool>,
    /// First position in `surface.nodes` by node of the mesh.
    first: Vec<usize>,
}

impl<'a> SlaveSurface<'a> {
    /// Collects nodes and faces.
    pub fn new(side: Side<'a>) -> Result<Self, ContactError> {
        let surface = ContactSurface::of_side(side)?;
        let mut first = vec![usize::MAX; side.mesh.node_count()];
        for (i, node) in surface.nodes.iter().enumerate().rev() {
            first[node.node] = i;
        }
        let mut slave = Self {
            side,
            taken: vec![false; surface.nodes.len()],
            faces: FaceShapes::of_mesh(side.mesh, side.faces)?,
            surface,
            first,
        };
        for &node in side.taken {
            for i in slave.positions(node) {
                slave.taken[i] = true;
            }
        }
        Ok(slave)
    }

    /// Position in `surface.nodes` of a node of the mesh on the patch of a face.
    pub fn index_of(&self, face: usize, node: usize) -> usize {
        let patch = self.side.patches.map_or(0, |patches| patches.of_face(face));
        let mut index = self.first[node];
        while self.surface.nodes[index].patch < patch {
            index += 1;
        }
        index
    }

    /// Positions in `surface.nodes` of a node of the mesh, on whatever patch; none for others.
    fn positions(&self, node: usize) -> Range<usize> {
        let first = self.first.get(node).copied().unwrap_or(usize::MAX);
        let of_node = self.surface.nodes.get(first..).unwrap_or(&[]).iter();
        let count = of_node.take_while(|other| other.node == node).count();
        first..first.saturating_add(count)
    }

    /// Which components of a node of the mesh can move.
    pub fn free(&self, node: usize) -> [bool; 3] {
        free(self.side, node)
    }

    /// Do supports hold a node (by position in `surface.nodes`) in the direction of its normal?
    pub fn holds_normal(&self, index: usize) -> bool {
        let node = &self.surface.nodes[index];
        restrained_frame(node.normal, self.free(node.node))
            .is_some_and(|(_, mobility)| !mobility.normal)
    }

    /// Unit normals by node of the surface, turned into symmetry planes where supports make one.
    pub fn normals(&self) -> Vec<[f64; 3]> {
        let normal = |node: &SurfaceNode| match restrained_frame(node.normal, self.free(node.node))
        {
            Some((frame, mobility)) if mobility.normal => frame.normal,
            _ => node.normal,
        };
        self.surface.nodes.iter().map(normal).collect()
    }
}

/// Which components of a node can move.
pub(crate) fn free(side: Side<'_>, node: usize) -> [bool; 3] {
    std::array::from_fn(|component| {
        component < side.mesh.dimension() && side.dofs.moves(node, component)
    })
}
