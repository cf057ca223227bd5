//! Results: what is written, read back by readers that are not ours, and what is left after failures.

mod atomic;
mod grids;
mod kinds;
mod tables;
