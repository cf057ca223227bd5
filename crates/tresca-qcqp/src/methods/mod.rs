//! The methods, one file each, and what they share.
//!
//! Every method is a function that takes a [`Run`] and a start, loops until
//! [`Run::judge`] gives a status, and returns that status.

mod apgd;
mod compliance;
mod faces;
mod gimssn;
mod grssn;
mod imssn;
mod inner;
mod memory;
mod mssn;
mod point;
mod preconditioner;
mod recycle;
mod run;
mod ssn;

pub(crate) use compliance::{Compliance, compliance};
pub(crate) use memory::Memory;
pub(crate) use point::{Point, relative};
pub(crate) use run::{Run, ending_at, zero_ending};

use crate::{Method, Status};

/// Runs the method of the settings; `capacity` is the number of products worth keeping.
pub(crate) fn run(
    run: &mut Run,
    memory: &mut Memory,
    capacity: usize,
    start: Option<&[f64]>,
) -> Status {
    let start = run.start(start);
    match run.settings.method {
        Method::Ssn => ssn::run(run, start),
        Method::Mssn => mssn::run(run, start),
        Method::Imssn => imssn::run(run, start),
        Method::Gimssn => gimssn::run(run, start),
        Method::Grssn => grssn::run(run, memory.newton(run.operator, capacity), start),
        Method::Apgd => apgd::run(run, start),
    }
}
