//! Where a solve starts.

use crate::solution::DualSolution;

/// A start for [`solve`](crate::solve()): forces, and the multiplier of the equality constraint.
#[derive(Clone, Copy, Debug)]
pub struct Start<'a> {
    /// λ, projected onto Λ before use; length: number of unknowns.
    pub lambda: &'a [f64],
    /// α; empty stands for 0.
    pub multiplier: &'a [f64],
}

impl<'a> From<&'a [f64]> for Start<'a> {
    fn from(lambda: &'a [f64]) -> Self {
        Self {
            lambda,
            multiplier: &[],
        }
    }
}

impl<'a> From<&'a DualSolution> for Start<'a> {
    fn from(solution: &'a DualSolution) -> Self {
        Self {
            lambda: &solution.lambda,
            multiplier: &solution.multiplier,
        }
    }
}
