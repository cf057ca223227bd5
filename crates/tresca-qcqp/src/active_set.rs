//! Which blocks are free and which are bound.

use crate::sets::block::{Block, BlockSet};
use crate::sets::convex_set::BlockState;
use serde::{Deserialize, Serialize};

/// How many blocks are in which state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct StateCounts {
    /// Half-lines at 0.
    pub open: usize,
    /// Half-lines away from 0.
    pub closed: usize,
    /// Intervals and discs inside.
    pub stick: usize,
    /// Intervals and discs on the boundary; those with bound 0 are always here.
    pub slip: usize,
}

/// The state of every block of a [`ProductSet`](crate::ProductSet), in its order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ActiveSet {
    states: Vec<BlockState>,
    counts: StateCounts,
}

impl ActiveSet {
    pub(crate) fn new(blocks: &[Block], states: Vec<BlockState>) -> Self {
        let mut counts = StateCounts::default();
        for (block, state) in blocks.iter().zip(&states) {
            match (block.set, state) {
                (BlockSet::Line(_) | BlockSet::Origin(_), _) => {}
                (BlockSet::HalfLine(_), BlockState::Free) => counts.closed += 1,
                (BlockSet::HalfLine(_), BlockState::Bound) => counts.open += 1,
                (BlockSet::Interval(_) | BlockSet::Disc(_), BlockState::Free) => counts.stick += 1,
                (BlockSet::Interval(_) | BlockSet::Disc(_), BlockState::Bound) => counts.slip += 1,
            }
        }
        Self { states, counts }
    }

    /// State of each block.
    pub fn states(&self) -> &[BlockState] {
        &self.states
    }

    /// How many blocks are in which state.
    pub fn counts(&self) -> StateCounts {
        self.counts
    }

    /// Number of blocks whose state differs from that in `other`.
    pub fn changes(&self, other: &ActiveSet) -> usize {
        self.states
            .iter()
            .zip(&other.states)
            .filter(|(a, b)| a != b)
            .count()
    }
}
