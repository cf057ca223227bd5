//! What is integrated over each slave face, before any basis of multipliers is chosen.

use std::collections::BTreeMap;

use rayon::prelude::*;

use tresca_fem::vector3::{dot, norm, unit};

use super::rules::{Rules, face_rule};
use super::segment::Segments;
use crate::geometry::face::{FaceShape, MAX_NODES, combine};
use crate::geometry::faces::FaceShapes;
use crate::geometry::search::{FacetTree, Reach};

/// A matrix with a row and a column for each node of a face.
pub(crate) type Square = [[f64; MAX_NODES]; MAX_NODES];

/// Integrals over the part of a slave face that something faces.
#[derive(Debug, Clone)]
pub(crate) struct FaceIntegrals {
    /// ∫ 1.
    pub area: f64,
    /// ∫ φ_k φ_l.
    pub mass: Square,
    /// ∫ φ_k g.
    pub gap: [f64; MAX_NODES],
    /// One for each master face, ascending.
    pub partners: Vec<Partner>,
}

/// Integrals over the part of a slave face that one master face covers.
#[derive(Debug, Clone)]
pub(crate) struct Partner {
    /// The master face.
    pub face: usize,
    /// ∫ φ_k φ_l with the master's φ_l, row by row.
    pub moments: Vec<f64>,
}

impl FaceIntegrals {
    fn zero() -> Self {
        Self {
            area: 0.0,
            mass: [[0.0; MAX_NODES]; MAX_NODES],
            gap: [0.0; MAX_NODES],
            partners: Vec::new(),
        }
    }

    fn add(&mut self, count: usize, values: &[f64; MAX_NODES], weight: f64) {
        self.area += weight;
        for k in 0..count {
            for l in 0..count {
                self.mass[k][l] += weight * values[k] * values[l];
            }
        }
    }
}

/// Integrates over the segments of every slave face with all master faces within reach.
///
/// `normal` gives the unit normal ν at a node of a slave face; the gap at a point of the face is
/// (x_m − x_s)·ν with ν interpolated. A master surface parallel to the slave's tangent plane is thus seen
/// at its distance, although it was found along the facet's normal, which is first order only.
pub(crate) fn over_segments(
    slave: &FaceShapes,
    master: &FaceShapes,
    reach: Reach,
    normal: impl Fn(usize, usize) -> [f64; 3] + Sync,
) -> Vec<FaceIntegrals> {
    let tree = FacetTree::new(&master.facets);
    let rules = Rules::new();
    let face = |(index, shape): (usize, &FaceShape)| {
        let count = shape.nodes().len();
        let mut integrals = FaceIntegrals::zero();
        let mut blocks: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
        let mut points = Vec::new();
        let mut normals = [[0.0; 3]; MAX_NODES];
        for (own, &node) in normals.iter_mut().zip(shape.nodes()) {
            *own = normal(index, node);
        }
        for facet in slave.facets_of(index) {
            let segments = Segments::new(slave.space, &rules, shape, facet);
            for candidate in tree.candidates(facet, reach) {
                let other = &master.facets[candidate];
                let partner = &master.shapes[other.face];
                segments.points(partner, other, &mut points);
                let near = points.iter().map(|point| point.distance.abs());
                let nearest = near.fold(f64::INFINITY, f64::min);
                if points.is_empty() || nearest > reach.between(facet.radius, other.radius) {
                    continue;
                }
                let columns = partner.nodes().len();
                let block = blocks
                    .entry(other.face)
                    .or_insert_with(|| vec![0.0; count * columns]);
                for point in &points {
                    integrals.add(count, &point.slave, point.weight);
                    let nu = unit(combine(&point.slave, &normals));
                    let gap = dot(nu, point.offset);
                    for k in 0..count {
                        let share = point.weight * point.slave[k];
                        integrals.gap[k] += share * gap;
                        for l in 0..columns {
                            block[columns * k + l] += share * point.master[l];
                        }
                    }
                }
            }
        }
        integrals.partners = blocks
            .into_iter()
            .map(|(face, moments)| Partner { face, moments })
            .collect();
        integrals
    };
    slave.shapes.par_iter().enumerate().map(face).collect()
}

/// Integrates over whole faces, where `gaps` gives a gap at each of the nodes; `None` leaves a face
/// out.
pub(crate) fn over_faces(
    slave: &FaceShapes,
    gaps: impl Fn(usize, &FaceShape) -> Option<[f64; MAX_NODES]> + Sync,
) -> Vec<FaceIntegrals> {
    let face = |(index, shape): (usize, &FaceShape)| {
        let mut integrals = FaceIntegrals::zero();
        let Some(gaps) = gaps(index, shape) else {
            return integrals;
        };
        let count = shape.nodes().len();
        let rule = face_rule(shape.kind);
        for (&xi, weight) in rule.points.iter().zip(&rule.weights) {
            let values = shape.values(xi);
            let circumference = slave.space.circumference(shape.position(&values));
            let weight = weight * norm(shape.area_vector(xi)) * circumference;
            integrals.add(count, &values, weight);
        }
        for k in 0..count {
            integrals.gap[k] = (0..count).map(|l| integrals.mass[k][l] * gaps[l]).sum();
        }
        integrals
    };
    slave.shapes.par_iter().enumerate().map(face).collect()
}
