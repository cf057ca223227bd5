//! Pairs, frames, gaps and laws.
//!
//! One binary for all of them: what they share is compiled and linked once.

mod laws;
mod node_by_node;
mod surfaces;
