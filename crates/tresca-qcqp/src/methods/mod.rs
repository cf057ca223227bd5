//! The methods, one file each, and what they share.
//!
//! Every method is a function that takes a [`Run`](run::Run) and a start, loops until
//! [`Run::judge`](run::Run::judge) gives a status, and returns that status.

mod apgd;
pub(crate) mod dispatch;
mod faces;
mod gimssn;
mod grssn;
mod imssn;
mod mssn;
pub(crate) mod run;
mod ssn;
