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

use crate::sets::{BlockSet, BlockState, ProductSet};
use crate::{ActiveSet, DualOperator};
use faer::{Mat, MatRef};
use tresca_la::LinearOperator;

/// The direction in which a slipping pair may move.
#[derive(Clone, Copy, Debug)]
struct Tangent {
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
    tangents: Vec<Tangent>,
}

impl ReducedSpace {
    /// The unknowns of the free blocks.
    pub fn free(set: &ProductSet, active: &ActiveSet) -> Self {
        let free = set.blocks().iter().zip(active.states());
        let free = free.filter(|(_, state)| **state == BlockState::Free);
        Self { units: free.flat_map(|(block, _)| block.range()).collect(), tangents: Vec::new() }
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
            let BlockSet::Disc(disc) = block.set else { continue };
            if *state == BlockState::Free || disc.bound == 0.0 {
                continue;
            }
            let start = block.start;
            let norm = normal[start].hypot(normal[start + 1]);
            let t = [-normal[start + 1] / norm, normal[start] / norm];
            let curvature = curvature(start, disc.bound);
            space.tangents.push(Tangent { start, t, curvature });
        }
        space
    }

    /// The exact reduction of the SSN system at y = λ − ρ r(λ).
    pub fn newton(set: &ProductSet, active: &ActiveSet, y: &[f64], rho: f64) -> Self {
        Self::with_tangents(set, active, y, |i, bound| {
            (y[i].hypot(y[i + 1]) / bound - 1.0) / rho
        })
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

    /// The diagonal of Zᵀ diag(d) Z + C.
    pub fn diagonal(&self, d: &[f64]) -> Vec<f64> {
        let units = self.units.iter().map(|&i| d[i]);
        let tangents = self.tangents.iter().map(|tangent| {
            let [t0, t1] = tangent.t;
            d[tangent.start] * t0 * t0 + d[tangent.start + 1] * t1 * t1 + tangent.curvature
        });
        units.chain(tangents).collect()
    }

    /// out ← out + C s.
    fn add_curvature(&self, s: &[f64], out: &mut [f64]) {
        let first = self.units.len();
        for ((tangent, s), out) in self.tangents.iter().zip(&s[first..]).zip(&mut out[first..]) {
            *out += tangent.curvature * s;
        }
    }

    /// ZᵀAZ + C as a dense matrix, lower triangle only.
    pub fn assemble(&self, a: MatRef<'_, f64>) -> Mat<f64> {
        let unit = |i: usize| ([i, i], [1.0, 0.0]);
        let columns: Vec<_> = (self.units.iter().map(|&i| unit(i)))
            .chain(self.tangents.iter().map(|t| ([t.start, t.start + 1], t.t)))
            .collect();
        let mut matrix = Mat::zeros(columns.len(), columns.len());
        for (j, (cj, tj)) in columns.iter().enumerate() {
            for (i, (ci, ti)) in columns.iter().enumerate().skip(j) {
                let mut sum = 0.0;
                for (&c, &t) in cj.iter().zip(tj).filter(|(_, t)| **t != 0.0) {
                    sum += t * (ti[0] * a[(ci[0], c)] + ti[1] * a[(ci[1], c)]);
                }
                matrix[(i, j)] = sum;
            }
        }
        for (k, tangent) in self.tangents.iter().enumerate() {
            let k = self.units.len() + k;
            matrix[(k, k)] += tangent.curvature;
        }
        matrix
    }
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
        Self { operator, space, expanded: vec![0.0; n], product: vec![0.0; n] }
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
