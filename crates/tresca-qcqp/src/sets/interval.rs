//! [−g, g]: friction in two dimensions.

use super::convex_set::{BlockState, ConvexSet};

/// The interval [−g, g], g ≥ 0: free where |y| ≤ g (stick), else bound to ±g (slip).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// g.
    pub bound: f64,
}

impl ConvexSet for Interval {
    fn dimension(&self) -> usize {
        1
    }

    fn project(&self, y: &mut [f64]) {
        y[0] = y[0].clamp(-self.bound, self.bound);
    }

    fn contains(&self, x: &[f64]) -> bool {
        x[0].abs() <= self.bound
    }

    fn classify(&self, y: &[f64]) -> BlockState {
        if self.bound > 0.0 && y[0].abs() <= self.bound {
            BlockState::Free
        } else {
            BlockState::Bound
        }
    }

    fn slant(&self, y: &[f64], h: &mut [f64]) {
        if self.classify(y) == BlockState::Bound {
            h[0] = 0.0;
        }
    }
}
