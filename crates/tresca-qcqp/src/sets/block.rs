//! One factor of Λ, and where it stands.

use super::convex_set::{BlockState, ConvexSet};
use super::disc::Disc;
use super::half_line::HalfLine;
use super::interval::Interval;
use super::line::Line;
use super::origin::Origin;
use std::ops::Range;

/// One factor of the product.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BlockSet {
    /// ℝ.
    Line(Line),
    /// [0, ∞).
    HalfLine(HalfLine),
    /// [−g, g].
    Interval(Interval),
    /// ‖x‖ ≤ g in ℝ².
    Disc(Disc),
    /// {0}.
    Origin(Origin),
}

impl BlockSet {
    /// The set as an object.
    fn geometry(&self) -> &dyn ConvexSet {
        match self {
            BlockSet::Line(set) => set,
            BlockSet::HalfLine(set) => set,
            BlockSet::Interval(set) => set,
            BlockSet::Disc(set) => set,
            BlockSet::Origin(set) => set,
        }
    }

    /// The bound g of an interval or a disc.
    pub fn bound(&self) -> Option<f64> {
        match *self {
            BlockSet::Interval(Interval { bound }) | BlockSet::Disc(Disc { bound }) => Some(bound),
            BlockSet::Line(_) | BlockSet::HalfLine(_) | BlockSet::Origin(_) => None,
        }
    }

    /// The same set with another bound, where it has one.
    pub(crate) fn with_bound(self, bound: f64) -> Self {
        match self {
            BlockSet::Interval(_) => BlockSet::Interval(Interval { bound }),
            BlockSet::Disc(_) => BlockSet::Disc(Disc { bound }),
            BlockSet::Line(_) | BlockSet::HalfLine(_) | BlockSet::Origin(_) => self,
        }
    }
}

impl ConvexSet for BlockSet {
    fn dimension(&self) -> usize {
        self.geometry().dimension()
    }
    fn project(&self, y: &mut [f64]) {
        self.geometry().project(y);
    }
    fn contains(&self, x: &[f64]) -> bool {
        self.geometry().contains(x)
    }
    fn classify(&self, y: &[f64]) -> BlockState {
        self.geometry().classify(y)
    }
    fn slant(&self, y: &[f64], h: &mut [f64]) {
        self.geometry().slant(y, h);
    }
}

/// A factor and where its components stand in λ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Index of its first component; a disc's second one follows.
    pub start: usize,
    /// The set.
    pub set: BlockSet,
}

impl Block {
    /// Its components.
    pub fn range(&self) -> Range<usize> {
        self.start..self.start + self.set.dimension()
    }
}
