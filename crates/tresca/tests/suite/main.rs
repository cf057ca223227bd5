//! Models, matrices and files through the library.
//!
//! One binary for all of them: what they share is compiled and linked once.

mod algebraic;
mod architecture;
mod case_and_model;
mod check_values;
mod circles;
mod fclib;
mod invariance;
mod stopping;
mod summary_page;
