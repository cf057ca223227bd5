//! Elements, assembly, loads and recovery against closed forms.
//!
//! One binary for all of them: what they share is compiled and linked once.

mod common;
mod convergence;
mod convergence_plane;
mod grounding;
mod patch;
mod plane;
mod stiffness;
