//! Everything that people see: tables, progress, the verdict.

pub mod format;
pub mod monitor;
pub mod verdict;
