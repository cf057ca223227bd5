//! The reduced Newton system: which unknowns are free, and the operator on them.
//!
//! One step of the semismooth Newton method asks for r = 0 on the free blocks,
//! fixes the bound ones, and lets a slipping pair move along the tangent of its
//! circle. With Z the orthonormal basis of these motions at a point x and C the
//! curvature c̃ ≥ 0 of the tangents (the current slip per friction force),
//!
//! ```text
//! (ZᵀAZ + C) s = −Zᵀ r(x),      λ⁺ = x + Z s,
//! ```
//!
//! symmetric and positive definite. Without tangents this is the system of the
//! symmetrised methods (MSSN and kin); with tangents taken at y = λ − ρ r(λ),
//! x the bound blocks projected, and c̃ = (‖y‖/g − 1)/ρ, it *is* the step of SSN.

use crate::active_set::ActiveSet;
use crate::operator::dual_operator::DualOperator;
use crate::sets::block::BlockSet;
use crate::sets::convex_set::BlockState;
use crate::sets::product::ProductSet;
use faer::{ColMut, Mat};
use rayon::prelude::*;
use tresca_la::{LinearOperator, SymmetricEntries};

/// The direction in which a slipping pair may move.
#[derive(Clone, Copy, Debug)]
struct CircleTangent {
    /// Index of the pair's first component.
    start: usize,
    /// Unit vector t.
    t: [f64; 2],
    /// c̃.
    curvature: f64,
}

/// Z and C.
#[derive(Clone, Debug, Default)]
pub(crate) struct ReducedSpace {
    units: Vec<usize>,
    tangents: Vec<CircleTangent>,
}

impl ReducedSpace {
    /// The unknowns of the free blocks.
    pub fn free(set: &ProductSet, active: &ActiveSet) -> Self {
        let free = set.blocks().iter().zip(active.states());
        let free = free.filter(|(_, state)| **state == BlockState::Free);
        Self {
            units: free.flat_map(|(block, _)| block.range()).collect(),
            tangents: Vec::new(),
        }
    }

    /// The unknowns of the free blocks, and for each slipping disc with g > 0 the tangent of its
    /// circle where the ray through `normal` meets it; `curvature(pair components, g)` gives c̃.
    pub fn with_tangents(
        set: &ProductSet,
        active: &ActiveSet,
        normal: &[f64],
        curvature: impl Fn(usize, f64) -> f64,
    ) -> Self {
        let mut space = Self::free(set, active);
        for (block, state) in set.blocks().iter().zip(active.states()) {
            let BlockSet::Disc(disc) = block.set else {
                continue;
            };
            if *state == BlockState::Free || disc.bound == 0.0 {
                continue;
            }
            let start = block.start;
            let norm = normal[start].hypot(normal[start + 1]);
            let t = [-normal[start + 1] / norm, normal[start] / norm];
            let curvature = curvature(start, disc.bound);
            space.tangents.push(CircleTangent {
                start,
                t,
                curvature,
            });
        }
        space
    }

    /// Number of columns of Z.
    pub fn dim(&self) -> usize {
        self.units.len() + self.tangents.len()
    }

    /// full ← Z s.
    pub fn expand(&self, s: &[f64], full: &mut [f64]) {
        full.fill(0.0);
        let (units, tangents) = s.split_at(self.units.len());
        for (&i, s) in self.units.iter().zip(units) {
            full[i] = *s;
        }
        for (tangent, s) in self.tangents.iter().zip(tangents) {
            full[tangent.start] = tangent.t[0] * s;
            full[tangent.start + 1] = tangent.t[1] * s;
        }
    }

    /// reduced ← Zᵀ full.
    pub fn restrict(&self, full: &[f64], reduced: &mut [f64]) {
        let (units, tangents) = reduced.split_at_mut(self.units.len());
        for (&i, reduced) in self.units.iter().zip(units) {
            *reduced = full[i];
        }
        for (tangent, reduced) in self.tangents.iter().zip(tangents) {
            *reduced = tangent.t[0] * full[tangent.start] + tangent.t[1] * full[tangent.start + 1];
        }
    }

    /// The columns of Z in order, with the diagonal of C.
    pub fn columns(&self) -> impl Iterator<Item = BasisColumn> {
        let units = self.units.iter().map(|&i| BasisColumn {
            rows: [i, i],
            weights: [1.0, 0.0],
            curvature: 0.0,
        });
        let tangents = self.tangents.iter().map(|tangent| BasisColumn {
            rows: [tangent.start, tangent.start + 1],
            weights: tangent.t,
            curvature: tangent.curvature,
        });
        units.chain(tangents)
    }

    /// out ← out + C s.
    fn add_curvature(&self, s: &[f64], out: &mut [f64]) {
        let first = self.units.len();
        for ((tangent, s), out) in self.tangents.iter().zip(&s[first..]).zip(&mut out[first..]) {
            *out += tangent.curvature * s;
        }
    }

    /// ZᵀAZ + C as a dense matrix, lower triangle only. Columns are computed side by side.
    pub fn assemble(&self, a: &dyn SymmetricEntries) -> Mat<f64> {
        let columns: Vec<BasisColumn> = self.columns().collect();
        let order = columns.len();
        let mut matrix = Mat::zeros(order, order);
        let one = |(j, mut out): (usize, ColMut<'_, f64>)| {
            let own = columns[j];
            // A z_j where it is needed, then Zᵀ of it.
            let entry = |row: usize| {
                let of = |i: usize| a.entry(i.max(row), i.min(row));
                let first = own.weights[0] * of(own.rows[0]);
                if own.weights[1] == 0.0 {
                    first
                } else {
                    first + own.weights[1] * of(own.rows[1])
                }
            };
            for (i, column) in columns.iter().enumerate().skip(j) {
                let first = column.weights[0] * entry(column.rows[0]);
                let second = match column.weights[1] {
                    0.0 => 0.0,
                    weight => weight * entry(column.rows[1]),
                };
                out[i] = first + second;
            }
            out[j] += own.curvature;
        };
        matrix.as_mut().par_col_iter_mut().enumerate().for_each(one);
        matrix
    }
}

/// A column of Z: at most two entries. A unit vector has the weights (1, 0).
#[derive(Clone, Copy, Debug)]
pub(crate) struct BasisColumn {
    pub rows: [usize; 2],
    pub weights: [f64; 2],
    /// Its diagonal entry of C.
    pub curvature: f64,
}

/// ZᵀMZ + C for some columns of Z and the entries of M, lower triangle only.
pub(crate) fn galerkin(columns: &[BasisColumn], entry: impl Fn(usize, usize) -> f64) -> Mat<f64> {
    let mut matrix = Mat::zeros(columns.len(), columns.len());
    for (j, right) in columns.iter().enumerate() {
        for (i, left) in columns.iter().enumerate().skip(j) {
            let mut sum = 0.0;
            for (&row, &w) in left
                .rows
                .iter()
                .zip(&left.weights)
                .filter(|(_, w)| **w != 0.0)
            {
                for (&column, &v) in right
                    .rows
                    .iter()
                    .zip(&right.weights)
                    .filter(|(_, v)| **v != 0.0)
                {
                    sum += w * entry(row, column) * v;
                }
            }
            matrix[(i, j)] = sum;
        }
        matrix[(j, j)] += right.curvature;
    }
    matrix
}

/// s ↦ (ZᵀAZ + C) s, which keeps Z s and A Z s of the last product.
pub(crate) struct ReducedOperator<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub space: &'a ReducedSpace,
    /// Z s of the last product.
    pub expanded: Vec<f64>,
    /// A Z s of the last product.
    pub product: Vec<f64>,
}

impl<'a> ReducedOperator<'a> {
    pub fn new(operator: &'a mut dyn DualOperator, space: &'a ReducedSpace) -> Self {
        let n = operator.dim();
        Self {
            operator,
            space,
            expanded: vec![0.0; n],
            product: vec![0.0; n],
        }
    }
}

impl LinearOperator for ReducedOperator<'_> {
    fn dim(&self) -> usize {
        self.space.dim()
    }

    fn apply(&mut self, s: &[f64], out: &mut [f64]) {
        self.space.expand(s, &mut self.expanded);
        self.operator.apply(&self.expanded, &mut self.product);
        self.space.restrict(&self.product, out);
        self.space.add_curvature(s, out);
    }
}
