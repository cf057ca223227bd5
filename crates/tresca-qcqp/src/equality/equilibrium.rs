//! Is there an equilibrium?
//!
//! Whether Gλ = e has a solution in Λ is asked of statics alone, before any elasticity: the
//! distance ½‖ẽ − G̃λ‖² is made smallest over Λ by the proximal point method,
//!
//! ```text
//! λ⁺ = argmin ½‖ẽ − G̃λ‖² + δ/2 ‖λ − λᵏ‖²  =  P_Λ(λᵏ + G̃ᵀv/δ)   where   v = ẽ − G̃ P_Λ(λᵏ + G̃ᵀv/δ),
//! ```
//!
//! δ falling. The equation for v is that of a rigid body on a Winkler foundation of compliance δ.
//! Either the distance falls to rounding, or v
//! becomes a proof: ẽᵀv > sup λᵀG̃ᵀv over Λ.

use super::attainable::AttainableForces;
use super::balance::Balance;
use super::foundation::Foundation;
use tresca_la::vector::{dot, norm};

/// ‖ẽ − G̃λ‖/‖ẽ‖ that counts as equilibrium.
const BALANCED: f64 = 1e-12;
/// Part of the load, as power on v, that must remain for the proof.
const LEAST_POWER: f64 = 1e-8;
/// What an entry of G̃ᵀv may be wrong by, relative to the length of its column.
const SLACK: f64 = 1e-10;
const MAX_PROXIMAL_STEPS: usize = 40;

/// What statics say.
pub(crate) enum Equilibrium {
    /// Some λ ∈ Λ balances the load, or nothing proves the contrary.
    Possible,
    /// None does: the motion v in scaled coordinates, and the λ ∈ Λ that comes nearest.
    Impossible { motion: Vec<f64>, lambda: Vec<f64> },
}

/// Looks for a λ in `reach` that balances the load.
pub(crate) fn find(balance: &Balance, reach: &AttainableForces) -> Equilibrium {
    let dim = balance.rows.first().map_or(0, Vec::len);
    let load = norm(&balance.load);
    if load == 0.0 {
        return Equilibrium::Possible;
    }
    let columns: Vec<f64> = (0..dim)
        .map(|i| {
            balance
                .rows
                .iter()
                .map(|row| row[i] * row[i])
                .sum::<f64>()
                .sqrt()
        })
        .collect();
    let largest = columns.iter().copied().fold(0.0, f64::max);
    // With no contact row at all any δ will do.
    let stiffest = if largest > 0.0 {
        largest * largest
    } else {
        1.0
    };
    let mut delta = 0.1 * stiffest;
    let mut lambda = vec![0.0; dim];
    let mut v = balance.load.clone();
    for _ in 0..MAX_PROXIMAL_STEPS {
        let step = Foundation {
            balance,
            reach,
            centre: &lambda,
            compliance: delta,
        };
        step.settle(&vec![0.0; v.len()], 1.0, &mut v);
        lambda = step.forces(&v).1;
        if norm(&balance.shortfall(&lambda)) <= BALANCED * load {
            return Equilibrium::Possible;
        }
        if proves_impossible(balance, reach, &columns, load, &v) {
            return Equilibrium::Impossible { motion: v, lambda };
        }
        delta = f64::max(0.1 * delta, 1e-9 * stiffest);
    }
    Equilibrium::Possible
}

/// ẽᵀv > sup λᵀG̃ᵀv.
fn proves_impossible(
    balance: &Balance,
    reach: &AttainableForces,
    columns: &[f64],
    load: f64,
    v: &[f64],
) -> bool {
    let mut driven = vec![0.0; columns.len()];
    balance.add_transposed(v, &mut driven);
    let size = norm(v);
    let held = reach.support(&driven, |i| SLACK * columns[i] * size);
    dot(&balance.load, v) - held > LEAST_POWER * load * size
}
