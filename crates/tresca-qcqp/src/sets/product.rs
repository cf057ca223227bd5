//! Λ: the product of the blocks.

use super::block::{Block, BlockSet};
use super::convex_set::ConvexSet;
use super::disc::Disc;
use super::half_line::HalfLine;
use super::interval::Interval;
use crate::active_set::ActiveSet;
use crate::error::QcqpError;

/// Λ = product of blocks; every unknown belongs to exactly one.
#[derive(Clone, Debug, PartialEq)]
pub struct ProductSet {
    dimension: usize,
    blocks: Vec<Block>,
}

impl ProductSet {
    /// The product of `blocks` in ℝ^`dimension`, in any order.
    ///
    /// # Errors
    /// When an unknown is left out or claimed twice, or a bound is negative or not finite.
    pub fn new(dimension: usize, blocks: Vec<Block>) -> Result<Self, QcqpError> {
        let mut claims = vec![0_usize; dimension];
        for (number, block) in blocks.iter().enumerate() {
            if let Some(value) = block.set.bound() {
                check_bound(number, value)?;
            }
            let claimed = claims.get_mut(block.range());
            let claimed = claimed.ok_or(QcqpError::BlockRange {
                block: number,
                dimension,
            })?;
            claimed.iter_mut().for_each(|n| *n += 1);
        }
        match claims.iter().position(|&n| n != 1) {
            Some(index) => Err(QcqpError::Cover {
                index,
                found: claims[index],
            }),
            None => Ok(Self { dimension, blocks }),
        }
    }

    /// Contact in three dimensions with slip bounds g (forces, one per pair):
    /// λ = [λν (m); λτ (2m, the two components of a pair adjacent)], m half-lines, then m discs.
    ///
    /// # Errors
    /// When a bound is negative or not finite.
    pub fn contact_3d(bounds: &[f64]) -> Result<Self, QcqpError> {
        let m = bounds.len();
        let normals = (0..m).map(|start| Block {
            start,
            set: BlockSet::HalfLine(HalfLine),
        });
        let tangents = bounds.iter().enumerate().map(|(i, &bound)| Block {
            start: m + 2 * i,
            set: BlockSet::Disc(Disc { bound }),
        });
        Self::new(3 * m, normals.chain(tangents).collect())
    }

    /// Contact in two dimensions: λ = [λν (m); λτ (m)], m half-lines, then m intervals.
    ///
    /// # Errors
    /// When a bound is negative or not finite.
    pub fn contact_2d(bounds: &[f64]) -> Result<Self, QcqpError> {
        let m = bounds.len();
        let normals = (0..m).map(|start| Block {
            start,
            set: BlockSet::HalfLine(HalfLine),
        });
        let tangents = bounds.iter().enumerate().map(|(i, &bound)| Block {
            start: m + i,
            set: BlockSet::Interval(Interval { bound }),
        });
        Self::new(2 * m, normals.chain(tangents).collect())
    }

    /// Gives the interval or disc number `block` another bound.
    ///
    /// # Errors
    /// When there is no such block, it is a line or half-line, or the bound is negative or not
    /// finite.
    pub fn set_bound(&mut self, block: usize, bound: f64) -> Result<(), QcqpError> {
        check_bound(block, bound)?;
        match self.blocks.get_mut(block) {
            Some(own) if own.set.bound().is_some() => own.set = own.set.with_bound(bound),
            _ => return Err(QcqpError::NoBound { block }),
        }
        Ok(())
    }

    /// Gives a block another bound that is known to be in order.
    pub(crate) fn rebound(&mut self, block: usize, bound: f64) {
        let own = &mut self.blocks[block];
        own.set = own.set.with_bound(bound);
    }

    /// Number of unknowns.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The blocks, in the order given.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// y ← P_Λ(y).
    pub fn project(&self, y: &mut [f64]) {
        for block in &self.blocks {
            block.set.project(&mut y[block.range()]);
        }
    }

    /// Whether x ∈ Λ, up to the rounding of [`project`](Self::project).
    pub fn contains(&self, x: &[f64]) -> bool {
        self.blocks
            .iter()
            .all(|block| block.set.contains(&x[block.range()]))
    }

    /// The state of every block at y = λ − ρ r(λ).
    pub fn classify(&self, y: &[f64]) -> ActiveSet {
        let states = self
            .blocks
            .iter()
            .map(|block| block.set.classify(&y[block.range()]));
        ActiveSet::new(&self.blocks, states.collect())
    }

    /// h ← G(y) h, G the slanting function of P_Λ.
    pub fn slant(&self, y: &[f64], h: &mut [f64]) {
        for block in &self.blocks {
            block.set.slant(&y[block.range()], &mut h[block.range()]);
        }
    }
}

fn check_bound(block: usize, value: f64) -> Result<(), QcqpError> {
    if value.is_finite() && value >= 0.0 {
        Ok(())
    } else {
        Err(QcqpError::Bound { block, value })
    }
}
