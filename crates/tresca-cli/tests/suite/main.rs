//! The program as its users call it.
//!
//! One binary for all of them: what they share is compiled and linked once.

mod fclib;
mod interrupt;
mod matrices;
mod program;
