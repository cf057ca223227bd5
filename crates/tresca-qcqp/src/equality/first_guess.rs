//! A first guess of motion and forces.
//!
//! A body may hang far above its support, and slide far before anything holds it. Both are found on
//! a Winkler foundation, for the price of one multiplication that gives the foundation its compliance.

use super::attainable::AttainableForces;
use super::balance::Balance;
use super::foundation::Foundation;
use crate::session::Session;
use tresca_la::vector::{dot, norm};

/// η of the first proximal step; it is divided by ten in each further one.
const FIRST_SPRING: f64 = 0.1;
const MAX_STEPS: usize = 12;
/// ‖ẽ − G̃λ‖/‖ẽ‖ of a guess that is good enough.
const GOOD: f64 = 1e-6;

/// β and λ ∈ Λ with about Gλ = e, for b as it belongs to the deformable parts alone.
pub(crate) fn guess(
    session: &mut Session,
    rhs: &[f64],
    balance: &Balance,
    reach: &AttainableForces,
) -> (Vec<f64>, Vec<f64>) {
    let mut own_rhs = rhs.to_vec();
    let minus_load: Vec<f64> = balance.load.iter().map(|e| -e).collect();
    balance.add_transposed(&minus_load, &mut own_rhs);
    let mut beta = vec![0.0; balance.load.len()];
    // σmax is the compliance of smooth fields, but of those of GᵀSG too.
    let first = land(
        balance,
        reach,
        &own_rhs,
        session.memory.spectrum.sigma,
        &mut beta,
    );
    let measured = compliance_of(session, balance, &first);
    if measured > 0.0 && measured.is_finite() {
        let lambda = land(balance, reach, &own_rhs, measured, &mut beta);
        return (beta, lambda);
    }
    (beta, first)
}

/// Equilibrium on a foundation of the given compliance; moves β, returns λ.
fn land(
    balance: &Balance,
    reach: &AttainableForces,
    rhs: &[f64],
    compliance: f64,
    beta: &mut Vec<f64>,
) -> Vec<f64> {
    let centre: Vec<f64> = rhs.iter().map(|b| b / compliance).collect();
    let foundation = Foundation {
        balance,
        reach,
        centre: &centre,
        compliance,
    };
    let mut spring = FIRST_SPRING;
    let mut lambda = Vec::new();
    for _ in 0..MAX_STEPS {
        foundation.settle(&beta.clone(), spring, beta);
        lambda = foundation.forces(beta).1;
        if norm(&balance.shortfall(&lambda)) <= GOOD * norm(&balance.load) {
            break;
        }
        spring *= 0.1;
    }
    lambda
}

/// λᵀA_cλ/λᵀλ with A_c = A − GᵀSG: what the deformable parts do under these forces.
fn compliance_of(session: &mut Session, balance: &Balance, lambda: &[f64]) -> f64 {
    let mut product = vec![0.0; lambda.len()];
    session.operator.apply(lambda, &mut product);
    let mut minus_resultant = vec![0.0; balance.load.len()];
    for (resultant, row) in minus_resultant.iter_mut().zip(&balance.rows) {
        *resultant = -dot(row, lambda);
    }
    balance.add_transposed(&minus_resultant, &mut product);
    dot(lambda, &product) / dot(lambda, lambda)
}
