//! One file per command.

pub mod bench;
pub mod check;
pub mod export;
pub mod options;
pub mod solve;
