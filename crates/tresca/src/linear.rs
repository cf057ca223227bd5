//! The yardstick: one linear solve of the same bodies without contact.

use std::time::Instant;

use serde::Serialize;

use crate::SolveError;
use crate::assemble::Assembled;
use crate::dual::{FactorWork, factor};
use crate::model::Model;

/// What one linear solve of all bodies costs: plain nested dissection, factorisation, one
/// pair of sweeps. Assembly is not part of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LinearSolve {
    /// Seconds in all.
    pub seconds: f64,
    /// The factorisation.
    pub factorization: FactorWork,
}

/// Factors and solves the bodies as if they did not touch.
///
/// # Errors
/// When a stiffness matrix is not positive definite.
pub fn linear_solve(model: &Model, assembled: &Assembled) -> Result<LinearSolve, SolveError> {
    let begin = Instant::now();
    let factored = factor(model, assembled, false)?;
    Ok(LinearSolve {
        seconds: begin.elapsed().as_secs_f64(),
        factorization: factored.work,
    })
}
