//! One file per command.

pub mod bench;
pub mod check;
pub mod export;
pub mod fclib;
pub mod matrices;
pub mod options;
pub mod solve;
