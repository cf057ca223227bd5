//! One file per command.

pub mod bench;
pub mod options;
pub mod solve;
