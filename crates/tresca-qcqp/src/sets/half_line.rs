//! [0, ∞): a contact that can only push.

use super::convex_set::{BlockState, ConvexSet};

/// The half-line [0, ∞): free where y > 0 (closed), else bound to 0 (open).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HalfLine;

impl ConvexSet for HalfLine {
    fn dimension(&self) -> usize {
        1
    }

    fn project(&self, y: &mut [f64]) {
        // `max` would turn a NaN into 0 and hide it.
        if y[0] <= 0.0 {
            y[0] = 0.0;
        }
    }

    fn contains(&self, x: &[f64]) -> bool {
        x[0] >= 0.0
    }

    fn classify(&self, y: &[f64]) -> BlockState {
        if y[0] > 0.0 {
            BlockState::Free
        } else {
            BlockState::Bound
        }
    }

    fn slant(&self, y: &[f64], h: &mut [f64]) {
        if y[0] <= 0.0 {
            h[0] = 0.0;
        }
    }
}
