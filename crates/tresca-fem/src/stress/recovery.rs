//! Nodal stresses by patch recovery.
//!
//! The stress of the discrete displacement jumps from cell to cell and is of order p, the cells' order;
//! at certain points inside the cells it is of order p + 1 (the centre of linear cells, the 2 × 2 × 2
//! Gauss points of quadratic hexahedra). So the cells' values there are carried to a corner node by a
//! least-squares fit of a polynomial of degree p over the patch of cells around it (Zienkiewicz and Zhu,
//! *The superconvergent patch recovery*, IJNME 33, 1992). On a regular patch of linear cells inside the
//! body this *is* the average of the surrounding cells. A middle node has the mean of what the patches
//! of the corners that it lies amid say there.
//!
//! Why not extrapolate from the Gauss points and average: at a boundary, where contact happens, the
//! neighbours on the other side that would cancel the error of order p are missing, and the whole
//! field falls back to order p + ½ in L2, its boundary values to order p. The patch of a boundary node
//! reaches one layer of cells further in instead.

use super::fit::Fit;
use super::sample::{StressSample, samples};
use crate::assembly::formulation::Formulation;
use crate::element::kinds::corners_of_nodes;
use crate::initial_strain::InitialStrain;
use crate::material::Isotropic;
use crate::mesh::data::Mesh;
use crate::mesh::kind::CellKind;
use crate::mesh::topology::Incidence;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The stress tensor at every node, corners and middle nodes, recovered from the displacement `u` (full
/// dofs) and the initial strain, if there is one.
///
/// Of order p + 1 on smooth solutions with cells of order p, up to the boundary; on triangles and
/// tetrahedra, whose points are superconvergent only in groups, that order inside and at least p + ½ in
/// L2 because of the boundary. Near a singular point (an edge of the contact zone, a re-entrant corner)
/// it smooths over the patch like any recovery.
///
/// # Panics
/// When the length of `u` is not [`Mesh::dof_count`].
pub fn recover(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    u: &[f64],
    initial: Option<&InitialStrain>,
) -> Vec<[f64; 6]> {
    let samples = samples(mesh, material, formulation, u, initial);
    let patches = Patches::new(mesh, &samples);
    let of_corners: Vec<Vec<(usize, [f64; 6])>> = (0..mesh.node_count())
        .into_par_iter()
        .map_init(Scratch::default, |scratch, node| {
            patches.values_around(node, scratch)
        })
        .collect();
    // Each node's mean, added up in the order of the corners.
    let mut stress = vec![[0.0; 6]; mesh.node_count()];
    let mut counts = vec![0_u32; mesh.node_count()];
    for (node, value) in of_corners.into_iter().flatten() {
        counts[node] += 1;
        for k in 0..6 {
            stress[node][k] += value[k];
        }
    }
    for (stress, count) in stress.iter_mut().zip(counts) {
        if count > 1 {
            stress.iter_mut().for_each(|s| *s /= f64::from(count));
        }
    }
    stress
}

/// The samples of a mesh by cell, and the patches of its corner nodes.
struct Patches<'a> {
    mesh: &'a Mesh,
    samples: &'a [StressSample],
    /// Where the samples of each cell start.
    first_sample: Vec<usize>,
    incidence: Incidence,
    on_boundary: Vec<bool>,
    /// For each kind of cells the corners that each of its nodes lies amid.
    corners: BTreeMap<CellKind, Vec<Vec<usize>>>,
}

#[derive(Default)]
struct Scratch {
    patch: Vec<usize>,
    targets: Vec<usize>,
}

impl<'a> Patches<'a> {
    fn new(mesh: &'a Mesh, samples: &'a [StressSample]) -> Self {
        let mut first_sample = vec![0; mesh.cell_count() + 1];
        for sample in samples {
            first_sample[sample.cell + 1] += 1;
        }
        for cell in 0..mesh.cell_count() {
            first_sample[cell + 1] += first_sample[cell];
        }
        let mut on_boundary = vec![false; mesh.node_count()];
        for node in mesh.nodes_of_faces(&mesh.boundary_faces()) {
            on_boundary[node] = true;
        }
        let kinds = mesh.cells.iter().map(|block| block.kind);
        Self {
            mesh,
            samples,
            first_sample,
            incidence: mesh.incidence(),
            on_boundary,
            corners: kinds.map(|kind| (kind, corners_of_nodes(kind))).collect(),
        }
    }

    /// The values of a corner node's polynomial at the node and at the middle nodes next to it; nothing
    /// for a middle node.
    fn values_around(&self, node: usize, scratch: &mut Scratch) -> Vec<(usize, [f64; 6])> {
        let Scratch { patch, targets } = scratch;
        targets.clear();
        for &cell in self.incidence.cells_at(node) {
            let of = self.mesh.cell(cell);
            let corners = &self.corners[&of.kind];
            let Some(own) = of.nodes.iter().position(|&a| a == node) else {
                continue;
            };
            let near = (0..of.nodes.len()).filter(|&a| corners[a].contains(&own));
            targets.extend(near.map(|a| of.nodes[a]));
        }
        targets.sort_unstable();
        targets.dedup();
        if targets.is_empty() {
            return Vec::new();
        }
        self.collect_patch(node, patch);
        let of_patch = patch
            .iter()
            .flat_map(|&cell| &self.samples[self.first_sample[cell]..self.first_sample[cell + 1]]);
        let orders = patch.iter().map(|&cell| self.mesh.cell(cell).kind.order());
        let fit = Fit::new(of_patch, orders.min().unwrap_or(1));
        let values = targets.iter();
        values
            .map(|&target| (target, fit.at(self.mesh.points[target])))
            .collect()
    }

    /// The cells at a node, and for a boundary node also the cells that share a node with those.
    fn collect_patch(&self, node: usize, patch: &mut Vec<usize>) {
        patch.clear();
        let around = self.incidence.cells_at(node);
        if self.on_boundary[node] {
            for &cell in around {
                for &near in self.mesh.cell(cell).nodes {
                    patch.extend_from_slice(self.incidence.cells_at(near));
                }
            }
            patch.sort_unstable();
            patch.dedup();
        } else {
            patch.extend_from_slice(around);
        }
    }
}
