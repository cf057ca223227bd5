//! Constraints that no displacement satisfies together, for those who must find the fault in their model.

use std::collections::HashSet;

use serde::Serialize;

use crate::body::SystemBody;
use crate::layout::Layout;
use crate::load_case::LoadCase;
use crate::measures::largest;
use tresca_la::vector::norm;

/// Forces below this, relative to the largest, are rounding in a proof.
const VISIBLE: f64 = 1e-6;
/// ‖Bᵀy‖ that counts as 0, relative to the largest of the forces |Bᵀ| |y| on a dof.
const NOTHING: f64 = 1e-8;

/// Forces y with which pairs push against each other and nothing else: Bᵀy = 0, y in the dual cone of the
/// constraints (y ≥ 0 where a pair may open), and yet cᵀy < 0 for their right-hand sides c. No u can satisfy
/// B u ≤ c then (Farkas), as 0 = uᵀBᵀy ≤ cᵀy.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Contradiction {
    /// −cᵀy, y scaled to the largest entry 1: by how much the constraints miss each other, a length. One of the
    /// pairs with |y| = 1 would have to give way by as much.
    pub by: f64,
    /// The pairs that take part, in order.
    pub pairs: Vec<ContradictingPair>,
}

/// A pair in a contradiction.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ContradictingPair {
    /// Number of the pair, from 0.
    pub pair: usize,
    /// Its normal force in y.
    pub normal: f64,
    /// Its tangential force in y.
    pub tangential: [f64; 2],
}

/// Rows of B, and the dofs that they touch, each with the number of its body.
type Group = (Vec<usize>, HashSet<(usize, usize)>);

/// The rows with a force, in groups that share dofs.
fn groups(bodies: &[SystemBody], mu: &[f64]) -> Vec<Vec<usize>> {
    let size = largest(mu);
    let acting = (0..mu.len()).filter(|&i| mu[i].abs() >= VISIBLE * size);
    let mut groups: Vec<Group> = Vec::new();
    for i in acting {
        let of_body = |(k, body): (usize, &SystemBody)| {
            let row: Vec<_> = body.coupling.row(i).map(|(dof, _)| (k, dof)).collect();
            row
        };
        let dofs: HashSet<_> = bodies.iter().enumerate().flat_map(of_body).collect();
        let (mut joined, apart): (Vec<_>, Vec<_>) = groups
            .into_iter()
            .partition(|(_, others)| !others.is_disjoint(&dofs));
        let mut group = (vec![i], dofs);
        for (rows, dofs) in joined.drain(..) {
            group.0.extend(rows);
            group.1.extend(dofs);
        }
        groups = apart;
        groups.push(group);
    }
    groups.into_iter().map(|(rows, _)| rows).collect()
}

impl Contradiction {
    /// Of the forces y, against right-hand sides c in the order of λ.
    pub(crate) fn new(layout: &Layout, mut forces: Vec<f64>, sides: &[f64]) -> Self {
        let size = largest(&forces);
        forces.iter_mut().for_each(|y| {
            *y /= size;
            if y.abs() < VISIBLE {
                *y = 0.0;
            }
        });
        let work: f64 = forces.iter().zip(sides).map(|(y, c)| y * c).sum();
        let pairs = (0..layout.pair_count()).map(|pair| ContradictingPair {
            pair,
            normal: forces[pair],
            tangential: layout.tangential(&forces, pair),
        });
        Self {
            by: -work,
            pairs: pairs
                .filter(|own| own.normal != 0.0 || own.tangential != [0.0; 2])
                .collect(),
        }
    }

    /// Of y in the solver's unknowns, where B is known: `None` when Bᵀy does not vanish. Rows of B that nearly
    /// depend on each other look from the dual problem like rows that do; the displacements that they ask for are
    /// there, but rounding does not let them be found.
    pub(crate) fn confirmed(
        layout: &Layout,
        bodies: &[SystemBody],
        case: &LoadCase,
        mu: &[f64],
    ) -> Option<Self> {
        let vanishes = |body: &SystemBody| {
            let order = body.stiffness.order();
            let (mut sum, mut sizes) = (vec![0.0; order], vec![0.0; order]);
            body.coupling.add_transposed_product(mu, &mut sum);
            body.coupling.add_transposed_sizes(mu, &mut sizes);
            norm(&sum) <= NOTHING * largest(&sizes)
        };
        let mut sides = case.origin.clone();
        sides.iter_mut().zip(&case.gaps).for_each(|(c, d)| *c += d);
        sides
            .iter_mut()
            .zip(&case.base)
            .for_each(|(c, base)| *c -= base);
        if !bodies.iter().all(vanishes) {
            return None;
        }
        // Groups of pairs that share no dof contradict each other apart: the worst is shown.
        let groups = groups(bodies, mu);
        let of_group = |group: &Vec<usize>| {
            let mut own = vec![0.0; mu.len()];
            group.iter().for_each(|&i| own[i] = mu[i]);
            Self::new(layout, layout.forces(&own), &sides)
        };
        groups
            .iter()
            .map(of_group)
            .max_by(|one, other| one.by.total_cmp(&other.by))
    }
}
