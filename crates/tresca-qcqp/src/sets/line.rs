//! ℝ: no constraint.

use super::convex_set::{BlockState, ConvexSet};

/// The whole line ℝ: an unknown without a constraint (a tied pair).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line;

impl ConvexSet for Line {
    fn dimension(&self) -> usize {
        1
    }

    fn project(&self, _: &mut [f64]) {}

    fn contains(&self, _: &[f64]) -> bool {
        true
    }

    fn classify(&self, _: &[f64]) -> BlockState {
        BlockState::Free
    }

    fn slant(&self, _: &[f64], _: &mut [f64]) {}
}
