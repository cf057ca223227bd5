//! Nodal stresses by patch recovery.
//!
//! The stress of the discrete displacement jumps from cell to cell and is of first order; at certain
//! points inside the cells it is of second order (the centre, for linear elements). So the cells'
//! values there are carried to a node by a least-squares fit of a linear polynomial over the patch of
//! cells around it (Zienkiewicz and Zhu, *The superconvergent patch recovery*, IJNME 33, 1992). On a
//! regular patch inside the body this *is* the average of the surrounding cells.
//!
//! Why not extrapolate from the Gauss points and average: at a boundary, where contact happens, the
//! neighbours on the other side that would cancel the first-order error are missing, and the whole
//! field falls back to order 3/2 in L2, its boundary values to order 1. The patch of a boundary node
//! reaches one layer of cells further in instead.

use super::{StressSample, samples};
use crate::material::Isotropic;
use crate::mesh::{Incidence, Mesh};
use crate::tensor::{dot, sub, symmetric_eigen};
use rayon::prelude::*;

/// The fitted slope along a principal direction of the patch is dropped when it would magnify
/// errors of the samples more than this (as a variance): the samples lie nearly in a plane that the
/// node is far from, as in a plate of one layer of cells. Two layers need about ½.
const LARGEST_LEVERAGE: f64 = 4.0;

/// The stress tensor at every node, recovered from the displacement `u` (full dofs).
///
/// Second-order accurate on smooth solutions, up to the boundary; on triangles, whose centres are
/// superconvergent only in pairs, second-order inside and of order 3/2 in L2 because of the boundary. Near a singular point (an edge of
/// the contact zone, a re-entrant corner) it smooths over the patch like any recovery.
///
/// # Panics
/// When the length of `u` is not [`Mesh::dof_count`].
pub fn recover(mesh: &Mesh, material: &Isotropic, u: &[f64]) -> Vec<[f64; 6]> {
    let samples = samples(mesh, material, u);
    let mut first_sample = vec![0; mesh.cell_count() + 1];
    for sample in &samples {
        first_sample[sample.cell + 1] += 1;
    }
    for cell in 0..mesh.cell_count() {
        first_sample[cell + 1] += first_sample[cell];
    }
    let incidence = mesh.incidence();
    let mut on_boundary = vec![false; mesh.node_count()];
    for node in mesh.nodes_of_faces(&mesh.boundary_faces()) {
        on_boundary[node] = true;
    }
    (0..mesh.node_count())
        .into_par_iter()
        .map_init(Vec::new, |patch, node| {
            collect_patch(mesh, &incidence, node, on_boundary[node], patch);
            let of_patch = patch
                .iter()
                .flat_map(|&cell| &samples[first_sample[cell]..first_sample[cell + 1]]);
            fit(of_patch, mesh.points[node])
        })
        .collect()
}

/// The cells at a node, and for a boundary node also the cells that share a node with those.
fn collect_patch(
    mesh: &Mesh,
    incidence: &Incidence,
    node: usize,
    on_boundary: bool,
    patch: &mut Vec<usize>,
) {
    patch.clear();
    let around = incidence.cells_at(node);
    if on_boundary {
        for &cell in around {
            for &near in mesh.cell(cell).nodes {
                patch.extend_from_slice(incidence.cells_at(near));
            }
        }
        patch.sort_unstable();
        patch.dedup();
    } else {
        patch.extend_from_slice(around);
    }
}

/// The linear least-squares fit of some samples, evaluated at `x`.
fn fit<'a>(samples: impl Iterator<Item = &'a StressSample> + Clone, x: [f64; 3]) -> [f64; 6] {
    let count = samples.clone().count() as f64;
    let (mut center, mut mean) = ([0.0; 3], [0.0; 6]);
    for sample in samples.clone() {
        for i in 0..3 {
            center[i] += sample.position[i] / count;
        }
        for k in 0..6 {
            mean[k] += sample.stress[k] / count;
        }
    }
    let mut covariance = [[0.0; 3]; 3];
    let mut moment = [[0.0; 3]; 6];
    for sample in samples {
        let r = sub(sample.position, center);
        for i in 0..3 {
            for j in 0..3 {
                covariance[i][j] += r[i] * r[j];
            }
            for k in 0..6 {
                moment[k][i] += r[i] * sample.stress[k];
            }
        }
    }
    // value = mean + Σ_d (v_d·(x − center)) (v_d·moment) / λ_d over the principal directions v_d.
    let (eigenvalues, directions) = symmetric_eigen(covariance);
    let largest = eigenvalues.iter().fold(0.0_f64, |a, &b| a.max(b));
    let r = sub(x, center);
    let mut value = mean;
    for (lambda, direction) in eigenvalues.into_iter().zip(directions) {
        let reach = dot(direction, r);
        if lambda <= 1e-14 * largest || reach * reach > LARGEST_LEVERAGE * lambda {
            continue;
        }
        for k in 0..6 {
            value[k] += reach * dot(direction, moment[k]) / lambda;
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(position: [f64; 3]) -> StressSample {
        let [x, y, z] = position;
        let stress = [1.0, 2.0 * x, y - z, x + y + z, 3.0 - z, 0.0];
        StressSample {
            cell: 0,
            position,
            stress,
        }
    }

    #[test]
    fn a_fit_reproduces_linear_fields_outside_the_patch() {
        let samples: Vec<_> = (0..8)
            .map(|k| sample([0.0, 1.0, 2.0].map(|s| s + 0.5 * f64::from((k >> (s as u32)) & 1))))
            .collect();
        let x = [-0.2, 1.7, 2.9];
        let value = fit(samples.iter(), x);
        for k in 0..6 {
            assert!((value[k] - sample(x).stress[k]).abs() < 1e-13);
        }
    }

    #[test]
    fn a_flat_patch_fits_only_within_its_plane() {
        let mut samples: Vec<_> = (0..4)
            .map(|k| sample([f64::from(k & 1), f64::from(k >> 1), 0.0]))
            .collect();
        for tilt in [0.0, 1e-3] {
            samples[0].position[2] = tilt;
            let value = fit(samples.iter(), [0.5, 0.5, 0.5]);
            assert!(
                (value[1] - 1.0).abs() < 1e-2 && value[5] == 0.0,
                "{value:?}"
            );
        }
        let single = fit(samples[..1].iter(), [9.0; 3]);
        assert_eq!(single, samples[0].stress);
    }
}
