//! What supports and equations leave of the rigid motions of parts that the equations couple.
//!
//! Parts, and dofs beyond the mesh, that some equation names together form a cluster. Its candidates are the
//! rigid motions of every part and the free dofs beyond the mesh one by one: all that strains no cell. What of
//! their combinations the supports and the equations allow is the kernel of CᵀKC.

use super::free::{FreeMotion, Piece};
use super::motion::{RigidMotion, combine, motions};
use crate::dofs::DofMap;
use crate::mesh::data::Mesh;
use crate::mesh::disjoint_sets::DisjointSets;
use crate::mesh::parts::Part;
use faer::{Mat, Side};
use std::sync::Arc;

/// As for a part by itself: a motion counts as held when more than 1e-6 of it is seen.
const HELD: f64 = 1e-12;

pub(super) fn remaining(mesh: &Mesh, dofs: &DofMap, parts: &[Part]) -> Vec<FreeMotion> {
    let nodes: Vec<Arc<[usize]>> = parts.iter().map(|part| part.nodes.clone().into()).collect();
    let mut part_of = vec![0; mesh.node_count()];
    for (index, part) in parts.iter().enumerate() {
        part.nodes.iter().for_each(|&node| part_of[node] = index);
    }
    let of_cluster = |cluster: Cluster| {
        let body = Coupled::new(mesh, dofs, parts, &part_of, cluster);
        body.remaining(&nodes)
    };
    let clusters = clusters(mesh, dofs, &part_of, parts.len());
    clusters.into_iter().flat_map(of_cluster).collect()
}

/// What equations couple.
#[derive(Default)]
struct Cluster {
    /// Ascending.
    parts: Vec<usize>,
    /// Free full dofs beyond the mesh, ascending.
    beyond: Vec<usize>,
    /// Numbers of the equations.
    equations: Vec<usize>,
}

/// The clusters that have a part, by their first part; loose dofs beyond the mesh are with the first.
fn clusters(mesh: &Mesh, dofs: &DofMap, part_of: &[usize], parts: usize) -> Vec<Cluster> {
    let full = mesh.dof_count();
    let owner = |dof: usize| match part_of.get(dof / dofs.components()) {
        Some(&part) => part,
        None => parts + dof - full,
    };
    let count = parts + dofs.full_len() - full;
    let mut sets = DisjointSets::new(count);
    for row in dofs.rows() {
        let terms = row.terms.iter().map(|&(dof, _)| dof);
        for dof in terms.filter(|&dof| dofs.free_of_full(dof).is_some()) {
            sets.join(owner(row.dependent), owner(dof));
        }
    }
    // A root beyond the parts couples none of them: its dofs are loose.
    let mut root = |index| {
        Some(sets.root(index))
            .filter(|&root| root < parts)
            .unwrap_or(0)
    };
    let mut clusters: Vec<Cluster> = (0..parts).map(|_| Cluster::default()).collect();
    for part in 0..parts {
        clusters[root(part)].parts.push(part);
    }
    for dof in (full..dofs.full_len()).filter(|&dof| dofs.free_of_full(dof).is_some()) {
        clusters[root(owner(dof))].beyond.push(dof);
    }
    for (index, row) in dofs.rows().iter().enumerate() {
        clusters[root(owner(row.dependent))].equations.push(index);
    }
    clusters.retain(|cluster| !cluster.parts.is_empty());
    clusters
}

/// A cluster with its candidates: the motions of its parts, part by part, then the dofs beyond the mesh.
struct Coupled<'a> {
    mesh: &'a Mesh,
    dofs: &'a DofMap,
    parts: &'a [Part],
    part_of: &'a [usize],
    cluster: Cluster,
    /// The motions of each of its parts, about one centre.
    motions: Vec<RigidMotion>,
}

impl<'a> Coupled<'a> {
    fn new(
        mesh: &'a Mesh,
        dofs: &'a DofMap,
        parts: &'a [Part],
        part_of: &'a [usize],
        cluster: Cluster,
    ) -> Self {
        let all = Part {
            nodes: all_nodes(parts, &cluster),
        };
        Self {
            mesh,
            dofs,
            parts,
            part_of,
            motions: motions(mesh, &all),
            cluster,
        }
    }

    fn candidates(&self) -> usize {
        self.motions.len() * self.cluster.parts.len() + self.cluster.beyond.len()
    }

    /// Adds the values of all candidates at a full dof.
    fn add(&self, factor: f64, dof: usize, row: &mut [f64]) {
        let (node, component) = (dof / self.dofs.components(), dof % self.dofs.components());
        let Some(part) = self.part_of.get(node) else {
            if let Ok(at) = self.cluster.beyond.binary_search(&dof) {
                row[self.motions.len() * self.cluster.parts.len() + at] += factor;
            }
            return;
        };
        if let Ok(at) = self.cluster.parts.binary_search(part) {
            let of_part = &mut row[self.motions.len() * at..][..self.motions.len()];
            for (entry, motion) in of_part.iter_mut().zip(&self.motions) {
                *entry += factor * motion.at(self.mesh.points[node])[component];
            }
        }
    }

    /// What the candidates must not do: move held dofs, violate equations.
    fn conditions(&self) -> Vec<Vec<f64>> {
        let mut rows = Vec::new();
        let mut condition = |terms: &mut dyn Iterator<Item = (f64, usize)>| {
            let mut row = vec![0.0; self.candidates()];
            terms.for_each(|(factor, dof)| self.add(factor, dof, &mut row));
            rows.push(row);
        };
        let prescribed = self.dofs.prescribed();
        for dof in prescribed.take_while(|&dof| dof < self.mesh.dof_count()) {
            let part = self.part_of[dof / self.dofs.components()];
            if self.cluster.parts.binary_search(&part).is_ok() {
                condition(&mut std::iter::once((1.0, dof)));
            }
        }
        for &equation in &self.cluster.equations {
            let row = &self.dofs.rows()[equation];
            // A dependent dof beyond the mesh follows, whatever the others do.
            if row.dependent < self.mesh.dof_count() {
                let others = row.terms.iter().map(|&(dof, c)| (-c, dof));
                let others = others.filter(|&(_, dof)| self.dofs.free_of_full(dof).is_some());
                condition(&mut std::iter::once((1.0, row.dependent)).chain(others));
            }
        }
        rows
    }

    fn remaining(&self, nodes: &[Arc<[usize]>]) -> Vec<FreeMotion> {
        let mut conditions = self.conditions();
        let per_part = self.motions.len();
        let of_parts = per_part * self.cluster.parts.len();
        // Dofs beyond the mesh have units of their own.
        let mut scales = vec![1.0; self.candidates()];
        for (k, scale) in scales.iter_mut().enumerate().skip(of_parts) {
            let length = conditions
                .iter()
                .map(|row| row[k] * row[k])
                .sum::<f64>()
                .sqrt();
            if length > 0.0 {
                *scale = 1.0 / length;
            }
            conditions.iter_mut().for_each(|row| row[k] *= *scale);
        }
        // Translations first, so that what is a pure translation is reported as one.
        let turns = |k: usize| k < of_parts && self.motions[k % per_part].rotation != [0.0; 3];
        let shifting: Vec<usize> = (0..scales.len()).filter(|&k| !turns(k)).collect();
        let all: Vec<usize> = (0..scales.len()).collect();
        let translations = null_space(&conditions, &shifting, scales.len());
        conditions.extend(translations.iter().cloned());
        let turning = null_space(&conditions, &all, scales.len());

        let joined: Arc<[usize]> = all_nodes(self.parts, &self.cluster).into();
        let as_motion = |coefficients: Vec<f64>| {
            let piece = |(at, &part): (usize, &usize)| Piece {
                part,
                motion: combine(&self.motions, &coefficients[per_part * at..][..per_part]),
                nodes: nodes[part].clone(),
            };
            let mut pieces = self.cluster.parts.iter().enumerate().map(piece);
            let first = pieces.next()?;
            let mut free = vec![0.0; self.dofs.free_len()];
            for (k, &dof) in self.cluster.beyond.iter().enumerate() {
                let value = coefficients[of_parts + k] * scales[of_parts + k];
                self.dofs
                    .free_of_full(dof)
                    .into_iter()
                    .for_each(|at| free[at] = value);
            }
            let mut motion =
                FreeMotion::coupled(first, pieces.collect(), self.parts.len(), joined.clone());
            // What is beyond the mesh and dependent follows from all the rest.
            let of_mesh = motion.displacement(self.mesh);
            for (free, at) in free.iter_mut().zip(0..) {
                if let Some(value) = of_mesh.get(self.dofs.full_of_free(at)) {
                    *free = *value;
                }
            }
            motion.set_beyond(self.dofs.expand(&free).split_off(self.mesh.dof_count()));
            Some(motion)
        };
        let found = translations.into_iter().chain(turning);
        found.filter_map(as_motion).collect()
    }
}

/// The nodes of the cluster's parts, ascending.
fn all_nodes(parts: &[Part], cluster: &Cluster) -> Vec<usize> {
    let of_parts = cluster.parts.iter().map(|&part| &parts[part].nodes);
    let mut nodes: Vec<usize> = of_parts.flatten().copied().collect();
    nodes.sort_unstable();
    nodes
}

/// An orthonormal basis of the vectors of length `width`, zero but for some columns, that all rows are
/// orthogonal to.
fn null_space(rows: &[Vec<f64>], columns: &[usize], width: usize) -> Vec<Vec<f64>> {
    let n = columns.len();
    let gram = Mat::from_fn(n, n, |k, l| {
        rows.iter()
            .map(|row| row[columns[k]] * row[columns[l]])
            .sum::<f64>()
    });
    let Ok(eigen) = gram.self_adjoint_eigen(Side::Lower) else {
        return Vec::new();
    };
    let values = eigen.S().column_vector();
    let largest = (0..n).fold(0.0_f64, |most, k| most.max(values[k]));
    (0..n)
        .filter(|&k| values[k] <= HELD * largest)
        .map(|k| {
            let mut vector = vec![0.0; width];
            for (l, &column) in columns.iter().enumerate() {
                vector[column] = eigen.U()[(l, k)];
            }
            vector
        })
        .collect()
}
