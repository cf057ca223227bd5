//! The elements, their assembly and their stresses against closed forms, naive formulas and
//! manufactured solutions. One binary: linking costs more than running.

#![allow(clippy::needless_range_loop)] // Components i, j, k as in the formulas.
#![allow(clippy::print_stdout)] // Errors and rates, shown with `--nocapture`.

mod common;
mod constraints;
mod convergence;
mod convergence_plane;
mod elements;
mod grounding;
mod locking;
mod patch;
mod plane;
mod stiffness;
mod thermal;
