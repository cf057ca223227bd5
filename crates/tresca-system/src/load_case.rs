//! What acts in one solve.

use tresca_contact::Sliding;
use tresca_qcqp::{CoulombBound, ProductSet, QcqpError};

use crate::layout::Layout;

/// Loads, gaps, laws: everything that may change from one solve of a system to the next.
#[derive(Debug, Clone)]
pub struct LoadCase {
    /// f of each body over its free dofs; where supports prescribe displacements u0, f − K u0.
    pub loads: Vec<Vec<f64>>,
    /// What B u is where the free dofs are zero: prescribed displacements, the motion of obstacles. Length d m.
    pub base: Vec<f64>,
    /// d, the gaps, length m.
    pub gaps: Vec<f64>,
    /// The law of every pair.
    pub slidings: Vec<Sliding>,
    /// What friction counts slip from, and glue displacements: 0 for the normals, T u of the step before
    /// for the tangents. Length d m.
    pub origin: Vec<f64>,
    /// The largest prescribed displacement.
    pub held: f64,
}

/// Where a solve starts.
#[derive(Debug, Clone)]
pub struct WarmStart {
    /// μ, the forces in the solver's unknowns.
    pub mu: Vec<f64>,
    /// α, how far the rigid motions of floating bodies have gone; empty stands for 0.
    pub multiplier: Vec<f64>,
    /// The laws under which μ was found, if it is a solution.
    pub slidings: Option<Vec<Sliding>>,
}

impl WarmStart {
    /// μ for these laws: friction forces grow and shrink with their bounds, or the start would be worse than
    /// none.
    pub(crate) fn scaled(&self, layout: &Layout, slidings: &[Sliding]) -> Vec<f64> {
        let mut mu = self.mu.clone();
        let (m, tangents) = (layout.pair_count(), layout.tangents());
        let largest = |sliding: &Sliding| match sliding {
            Sliding::Bounded([a, b]) => Some(a.max(*b)),
            Sliding::Never | Sliding::Coulomb { .. } => None,
        };
        let before = self.slidings.iter().flatten();
        for (i, (old, new)) in before.zip(slidings).enumerate() {
            if let (Some(old), Some(new)) = (largest(old), largest(new))
                && old > 0.0
                && old != new
            {
                let first = m + tangents * i;
                mu[first..first + tangents]
                    .iter_mut()
                    .for_each(|x| *x *= new / old);
            }
        }
        mu
    }
}

/// Λ for some laws; bounds that follow normal forces begin with those of the start.
///
/// # Errors
/// When a bound is no number ≥ 0.
pub(crate) fn set(
    layout: &Layout,
    slidings: &[Sliding],
    coulomb: &[CoulombBound],
    start: Option<&[f64]>,
) -> Result<ProductSet, QcqpError> {
    let mut set = layout.set(slidings)?;
    for bound in start.iter().flat_map(|_| coulomb) {
        let normal = start.map_or(0.0, |mu| mu[bound.normal].max(0.0));
        set.set_bound(bound.block, (bound.coefficient * normal).min(bound.limit))?;
    }
    Ok(set)
}
