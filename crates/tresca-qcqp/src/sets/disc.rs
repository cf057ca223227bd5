//! { ‖x‖ ≤ g }: friction in three dimensions.

use super::convex_set::{BlockState, ConvexSet};

/// The disc { x ∈ ℝ² : ‖x‖ ≤ g }, g ≥ 0: free where ‖y‖ ≤ g (stick), else bound
/// to the circle (slip). With g = 0 it is the point 0 and always bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// g.
    pub bound: f64,
}

/// Relative slack of `contains`: scaling onto the circle is exact to a few units in the last place.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

impl ConvexSet for Disc {
    fn dimension(&self) -> usize {
        2
    }

    fn project(&self, y: &mut [f64]) {
        let norm = y[0].hypot(y[1]);
        // Written so that a NaN stays one, and a zero bound needs no division by it.
        if norm > self.bound {
            let scale = self.bound / norm;
            y[0] *= scale;
            y[1] *= scale;
        }
    }

    fn contains(&self, x: &[f64]) -> bool {
        x[0].hypot(x[1]) <= self.bound * (1.0 + ROUNDING)
    }

    fn classify(&self, y: &[f64]) -> BlockState {
        if self.bound > 0.0 && y[0].hypot(y[1]) <= self.bound {
            BlockState::Free
        } else {
            BlockState::Bound
        }
    }

    fn slant(&self, y: &[f64], h: &mut [f64]) {
        if self.classify(y) == BlockState::Free {
            return;
        }
        let norm = y[0].hypot(y[1]);
        if norm == 0.0 {
            h.fill(0.0);
            return;
        }
        // (g/‖y‖)(I − ŷŷᵀ) h = (g/‖y‖) t (tᵀh) with t ⟂ ŷ
        let t = [-y[1] / norm, y[0] / norm];
        let along = self.bound / norm * (t[0] * h[0] + t[1] * h[1]);
        h[0] = along * t[0];
        h[1] = along * t[1];
    }
}
