//! Rigid motions: what a body can do without being strained, and what its supports leave of it.

mod coupled;
mod free;
mod grounding;
mod motion;
mod remaining;

pub use free::FreeMotion;
pub use grounding::Grounding;
pub use motion::{RigidMotion, motions};
pub use remaining::remaining;
