//! The yardstick: one linear solve of the same bodies without contact.

use std::time::Instant;

use serde::Serialize;
use tresca_model::Model;
use tresca_system::body::{Body, Factors};
use tresca_system::description::FactorWork;

use crate::error::SolveError;
use crate::solve::factor_error;

/// What one linear solve of all bodies costs: plain nested dissection, factorisation, one
/// pair of sweeps. Assembly is not part of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LinearSolve {
    /// Seconds in all.
    pub seconds: f64,
    /// The factorisation.
    pub factorization: FactorWork,
}

/// Factors and solves the bodies of a model as if they did not touch.
///
/// # Errors
/// When a stiffness matrix is not positive definite.
pub fn linear_solve(model: &Model, bodies: &[Body]) -> Result<LinearSolve, SolveError> {
    let begin = Instant::now();
    let factors = Factors::new(bodies, false);
    let factors = factors.map_err(|(body, failure)| factor_error(model, body, failure))?;
    Ok(LinearSolve {
        seconds: begin.elapsed().as_secs_f64(),
        factorization: factors.work,
    })
}
