//! Where the time went.

use serde::Serialize;

use tresca_system::description::Times;

/// Wall-clock seconds.
#[derive(Debug, Clone, Copy, Default, Serialize)]
#[non_exhaustive]
pub struct TimesReport {
    /// Stiffness, loads, contact data; of matrices the checks of the input; of FCLIB the reduction to the
    /// contacts and the eigenvalues of W.
    pub assembly: f64,
    /// Contact search and coupling, a part of the assembly.
    pub contact: f64,
    /// Ordering, analysis, factorisation, set-up of the dual operator.
    pub factorization: f64,
    /// The dual problem.
    pub solve: f64,
    /// Multiplications by A, a part of the solve.
    pub multiplications: f64,
    /// Displacements and certificate.
    pub recovery: f64,
    /// Stresses and writing of the result files (the summary itself excepted).
    pub output: f64,
    /// All of it.
    pub total: f64,
}

impl From<Times> for TimesReport {
    fn from(times: Times) -> Self {
        Self {
            assembly: times.assembly,
            contact: times.contact,
            factorization: times.factorization,
            solve: times.solve,
            multiplications: times.multiplications,
            recovery: times.recovery,
            output: 0.0,
            total: times.total(),
        }
    }
}
