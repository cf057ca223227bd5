//! {0}: an unknown that is always zero.

use super::convex_set::{BlockState, ConvexSet};

/// The point 0: a component of a pair along which supports let nothing move, so that no force acts. Always
/// bound, and counted neither as sticking nor as slipping.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Origin;

impl ConvexSet for Origin {
    fn dimension(&self) -> usize {
        1
    }

    fn project(&self, y: &mut [f64]) {
        // An infinity becomes a NaN, too: neither is silently lost.
        y[0] = y[0] * 0.0 + 0.0;
    }

    fn contains(&self, x: &[f64]) -> bool {
        x[0] == 0.0
    }

    fn classify(&self, _: &[f64]) -> BlockState {
        BlockState::Bound
    }

    fn slant(&self, _: &[f64], h: &mut [f64]) {
        h[0] = 0.0;
    }
}
