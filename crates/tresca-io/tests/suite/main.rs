//! Files that come in and files that go out.
//!
//! One binary for all of them: what they share is compiled and linked once.

mod fclib;
mod mesh;
mod output;
mod problem;
