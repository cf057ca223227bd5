//! Which nodes have a multiplier on which faces.
//!
//! Not every slave node can have one. A node that supports hold in the direction of its normal cannot move
//! against the master, a node on an edge that two contacts share would see the same twice, and a node of
//! which (almost) nothing is covered would see the master by extrapolation from a sliver. Their
//! share of a face goes to its other nodes. On a face all of whose nodes would have to go, some stay, so that
//! the face still carries its pressure.

use super::dual::positive_measures;
use super::integrals::{FaceIntegrals, over_faces};
use super::slave::SlaveSurface;
use crate::geometry::face::{FaceShape, MAX_NODES};

/// A node has no multiplier when its covered share is below this part of what its best neighbour has …
const SHARE_OF_NEIGHBOUR: f64 = 0.01;

/// … and below this part of what it would have on covered faces.
const SHARE_OF_WHOLE: f64 = 0.1;

/// A face of which less than this share is covered is not worth a multiplier of its own.
const TOUCHED: f64 = 1e-8;

/// The nodes with a multiplier on each face, by local number; none on faces that nothing faces, nor on
/// faces in front of a `rigid` partner all of whose nodes are taken.
pub(crate) fn multipliers(
    slave: &SlaveSurface<'_>,
    integrals: &[FaceIntegrals],
    rigid: bool,
) -> Vec<[bool; MAX_NODES]> {
    let shapes = &slave.faces.shapes;
    let nodes = &slave.surface.nodes;
    let whole = over_faces(&slave.faces, |_, _| Some([0.0; MAX_NODES]));
    let covered_share = shares(slave, integrals);
    let whole_share = shares(slave, &whole);

    let faces = || shapes.iter().zip(integrals);
    let mut best = vec![0.0_f64; nodes.len()];
    for (face, (shape, _)) in faces()
        .enumerate()
        .filter(|(_, (_, integrals))| integrals.area > 0.0)
    {
        let indices = || shape.nodes().iter().map(|&node| slave.index_of(face, node));
        let top = indices().map(|i| covered_share[i]).fold(0.0, f64::max);
        for i in indices() {
            best[i] = best[i].max(top);
        }
    }
    let scarce = |i: usize| {
        let share = covered_share[i];
        share <= 0.0
            || share < SHARE_OF_NEIGHBOUR * best[i] && share < SHARE_OF_WHOLE * whole_share[i]
    };
    let held: Vec<bool> = (0..nodes.len()).map(|i| slave.holds_normal(i)).collect();

    let keep = |(index, (shape, integrals)): (usize, (&FaceShape, &FaceIntegrals))| {
        let mut keep = [false; MAX_NODES];
        if integrals.area <= 0.0 {
            return keep;
        }
        let indices: Vec<usize> = shape
            .nodes()
            .iter()
            .map(|&n| slave.index_of(index, n))
            .collect();
        let any = |able: &dyn Fn(usize) -> bool| indices.iter().any(|&i| able(i));
        let own = |i: usize| !held[i] && !slave.taken[i];
        let free = |i: usize| !held[i];
        // The master of another contact is another body: its rows differ from these.
        let able: &dyn Fn(usize) -> bool = if any(&own) {
            &own
        } else if any(&free) {
            if rigid {
                return keep;
            }
            &free
        } else {
            &|_| true
        };
        let local = || indices.iter().enumerate().filter(|&(_, &i)| able(i));
        for (a, _) in local().filter(|&(_, &i)| !scarce(i)) {
            keep[a] = true;
        }
        if keep == [false; MAX_NODES] && integrals.area > TOUCHED * whole[index].area {
            let most = local().max_by(|a, b| covered_share[*a.1].total_cmp(&covered_share[*b.1]));
            if let Some((a, _)) = most {
                keep[a] = true;
            }
        }
        keep
    };
    faces().enumerate().map(keep).collect()
}

/// ∫ φ⁺ by node of the surface, over what is integrated.
fn shares(slave: &SlaveSurface<'_>, integrals: &[FaceIntegrals]) -> Vec<f64> {
    let mut shares = vec![0.0; slave.surface.nodes.len()];
    for (face, (shape, integrals)) in slave.faces.shapes.iter().zip(integrals).enumerate() {
        let measures = positive_measures(shape.kind, &integrals.mass);
        for (&node, measure) in shape.nodes().iter().zip(measures) {
            shares[slave.index_of(face, node)] += measure;
        }
    }
    shares
}
