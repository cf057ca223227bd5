//! Mortar coupling with dual multipliers: integrals over segments, the dual basis on each face, and
//! the rows that come of them.

mod coverage;
mod dual;
mod integrals;
mod rows;
mod rules;
mod segment;

pub(crate) use integrals::{over_faces, over_segments};
pub(crate) use rows::{Master, assemble};
pub(crate) use rules::Rules;
pub(crate) use segment::{SegmentPoint, Segments};

use crate::geometry::{Patches, Reach};
use crate::restrained::restrained_frame;
use crate::{ContactData, ContactError, ContactSurface, Discretization, Interface, Side};

/// A slave surface, ready for integration.
pub(crate) struct SlaveSurface<'a> {
    /// What was given.
    pub side: Side<'a>,
    /// Its nodes.
    pub surface: ContactSurface,
    /// Its faces.
    pub patches: Patches,
    /// Which of `surface.nodes` have their multipliers in another contact.
    pub taken: Vec<bool>,
    /// Position in `surface.nodes` by node of the mesh.
    index: Vec<usize>,
}

impl<'a> SlaveSurface<'a> {
    /// Collects nodes and faces.
    pub fn new(side: Side<'a>) -> Result<Self, ContactError> {
        let surface = ContactSurface::new(side.mesh, side.faces)?;
        let mut index = vec![usize::MAX; side.mesh.node_count()];
        for (i, node) in surface.nodes.iter().enumerate() {
            index[node.node] = i;
        }
        let mut taken = vec![false; surface.nodes.len()];
        for &node in side.taken {
            if let Some(taken) = index.get(node).and_then(|&i| taken.get_mut(i)) {
                *taken = true;
            }
        }
        Ok(Self {
            side,
            taken,
            patches: Patches::of_mesh(side.mesh, side.faces)?,
            surface,
            index,
        })
    }

    /// Position in `surface.nodes` of a node of the mesh.
    pub fn index_of(&self, node: usize) -> usize {
        self.index[node]
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
        let normal =
            |node: &crate::SurfaceNode| match restrained_frame(node.normal, self.free(node.node)) {
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

/// Couples a surface to a deformable one.
pub(crate) fn couple_mortar(
    slave: Side<'_>,
    master: Side<'_>,
    interface: Interface<'_>,
    search: Option<f64>,
) -> Result<ContactData, ContactError> {
    let patches = Patches::of_mesh(master.mesh, master.faces)?;
    let side = Master {
        side: master,
        patches: &patches,
    };
    couple_patches(
        slave,
        &patches,
        Some(side),
        interface,
        search,
        Discretization::Mortar,
    )
}

/// Couples a surface to faces that belong to a body (`master`) or to nobody.
pub(crate) fn couple_patches(
    slave: Side<'_>,
    patches: &Patches,
    master: Option<Master<'_>>,
    interface: Interface<'_>,
    search: Option<f64>,
    discretization: Discretization,
) -> Result<ContactData, ContactError> {
    let slave = SlaveSurface::new(slave)?;
    let reach = reach(search, &slave.patches)?;
    let normals = slave.normals();
    let integrals = over_segments(&slave.patches, patches, reach, |node| {
        normals[slave.index_of(node)]
    });
    let normal = |i: usize| slave.surface.nodes[i].normal;
    assemble(
        &slave,
        normal,
        &integrals,
        master,
        interface,
        discretization,
    )
}

/// The distance within which partners are looked for.
pub(crate) fn reach(search: Option<f64>, slave: &Patches) -> Result<Reach, ContactError> {
    match search {
        // NaN is refused too; infinity looks everywhere.
        Some(search) if search.is_nan() || search <= 0.0 => Err(ContactError::Search { search }),
        Some(search) => Ok(Reach::new(Some(search), 0.0)),
        None => Ok(Reach::new(None, slave.diagonal())),
    }
}
