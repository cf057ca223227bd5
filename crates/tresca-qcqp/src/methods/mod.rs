//! The methods, one file each, and what they share.
//!
//! Every method is a function that takes a [`Run`] and a start, loops until
//! [`Run::judge`] gives a status, and returns that status.

mod apgd;
mod gimssn;
mod grssn;
mod imssn;
mod inner;
mod mssn;
mod preconditioner;
mod recycle;
mod run;
mod ssn;

pub(crate) use run::{Point, Run, zero_solution};

use crate::spectrum::Spectrum;
use crate::{Method, Status};

/// Runs the method of the settings.
pub(crate) fn run(run: &mut Run, spectrum: &Spectrum, start: Option<&[f64]>) -> Status {
    let start = run.start(start);
    match run.settings.method {
        Method::Ssn => ssn::run(run, start),
        Method::Mssn => mssn::run(run, start),
        Method::Imssn => imssn::run(run, start),
        Method::Gimssn => gimssn::run(run, start),
        Method::Grssn => grssn::run(run, spectrum, start),
        Method::Apgd => apgd::run(run, start),
    }
}
