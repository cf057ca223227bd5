//! From the name of a method to the method.

use super::run::Run;
use super::{apgd, gimssn, grssn, imssn, mssn, ssn};
use crate::newton::operator_memory::OperatorMemory;
use crate::settings::Method;
use crate::status::Status;

/// Runs the method; `capacity` is the number of products worth keeping.
pub(crate) fn run(
    run: &mut Run,
    method: Method,
    memory: &mut OperatorMemory,
    capacity: usize,
    start: Option<&[f64]>,
) -> Status {
    let start = run.start(start);
    match method {
        Method::Ssn => ssn::run(run, start),
        Method::Mssn => mssn::run(run, start),
        Method::Imssn => imssn::run(run, start),
        Method::Gimssn => gimssn::run(run, start),
        Method::Grssn => grssn::run(run, memory.newton(run.operator, capacity), start),
        Method::Apgd => apgd::run(run, start),
    }
}
