//! The law: which bound follows from which normal force.

use crate::error::QcqpError;
use crate::sets::product::ProductSet;
use tresca_la::vector::norm;

/// A friction block whose bound is min(coefficient · max(λν, 0), limit).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoulombBound {
    /// Number of the block in [`ProductSet::blocks`], an interval or a disc.
    pub block: usize,
    /// Index of the normal force λν in λ.
    pub normal: usize,
    /// F ≥ 0.
    pub coefficient: f64,
    /// Cap of the bound (a force), ≥ 0 or ∞.
    pub limit: f64,
}

/// The bounds of a problem, checked against its set.
#[derive(Clone, Debug, Default)]
pub(crate) struct CoulombLaw(Vec<CoulombBound>);

impl CoulombLaw {
    pub fn new(bounds: Vec<CoulombBound>, set: &ProductSet) -> Result<Self, QcqpError> {
        let mut seen = vec![false; set.blocks().len()];
        for (number, bound) in bounds.iter().enumerate() {
            let refuse = |what| {
                Err(QcqpError::Coulomb {
                    bound: number,
                    what,
                })
            };
            let Some(block) = set.blocks().get(bound.block) else {
                return refuse("there is no such block");
            };
            if block.set.bound().is_none() {
                return refuse("the block is no interval and no disc");
            }
            if std::mem::replace(&mut seen[bound.block], true) {
                return refuse("the block has another one already");
            }
            if bound.normal >= set.dimension() || block.range().contains(&bound.normal) {
                return refuse("the normal force is no unknown outside of the block");
            }
            if !(bound.coefficient >= 0.0 && bound.coefficient.is_finite()) {
                return refuse("the coefficient must be finite and not negative");
            }
            if bound.limit.is_nan() || bound.limit < 0.0 {
                return refuse("the limit must not be negative");
            }
        }
        Ok(Self(bounds))
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The bounds as given.
    pub fn bounds_of_blocks(&self) -> &[CoulombBound] {
        &self.0
    }

    /// g(λ).
    pub fn bounds(&self, lambda: &[f64]) -> Vec<f64> {
        let bound = |b: &CoulombBound| (b.coefficient * lambda[b.normal].max(0.0)).min(b.limit);
        self.0.iter().map(bound).collect()
    }

    /// The bounds that the set has.
    pub fn present(&self, set: &ProductSet) -> Vec<f64> {
        let present = |b: &CoulombBound| set.blocks()[b.block].set.bound().unwrap_or(0.0);
        self.0.iter().map(present).collect()
    }

    /// Gives the set these bounds.
    pub fn bound(&self, set: &mut ProductSet, bounds: &[f64]) {
        for (own, &bound) in self.0.iter().zip(bounds) {
            set.rebound(own.block, bound);
        }
    }

    /// ‖g(λ) − g‖/‖g(λ)‖ with the bounds g of the set; 0 when both vanish.
    pub fn change(&self, set: &ProductSet, lambda: &[f64]) -> f64 {
        let follows = self.bounds(lambda);
        relative_change(&follows, &self.present(set))
    }
}

/// ‖new − old‖/‖new‖; 0 when both vanish.
pub(super) fn relative_change(new: &[f64], old: &[f64]) -> f64 {
    let difference: Vec<f64> = new.iter().zip(old).map(|(n, o)| n - o).collect();
    match norm(&difference) {
        0.0 => 0.0,
        change => change / norm(new),
    }
}
