//! Problems of matrices alone: against an independent conic solver, against the case path, at the door.

mod case_path;
mod common;
mod door;
mod dual_form;
mod files;
mod oracle;
mod repeated;
mod sizes;
