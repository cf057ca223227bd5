//! What every set of the product can do.

use serde::{Deserialize, Serialize};

/// On which side of its constraint a block stands, judged by y = λ − ρ r(λ).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BlockState {
    /// The unknown is free and its gradient must vanish: closed or sticking.
    Free,
    /// The unknown lies on the boundary: open or slipping.
    Bound,
}

/// A closed convex set in ℝ or ℝ² with what a semismooth Newton method needs.
///
/// Slices passed in have length [`dimension`](ConvexSet::dimension).
pub trait ConvexSet {
    /// Number of components, 1 or 2.
    fn dimension(&self) -> usize;

    /// y ← P(y), the nearest point of the set.
    fn project(&self, y: &mut [f64]);

    /// Whether x lies in the set, up to the rounding of `project`: true for every projected point.
    fn contains(&self, x: &[f64]) -> bool;

    /// The side of y. Free means P(y) = y with y off the kink or inside; a set that is a
    /// single point is always bound, so that its unknowns are dropped.
    fn classify(&self, y: &[f64]) -> BlockState;

    /// h ← G(y) h with the slanting function G of P:
    /// P(y + h) − P(y) − G(y + h) h = o(‖h‖). Symmetric, 0 ≤ G ≤ I.
    fn slant(&self, y: &[f64], h: &mut [f64]);
}
