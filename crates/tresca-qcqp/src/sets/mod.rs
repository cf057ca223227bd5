//! The convex sets of which Λ is made.
//!
//! A block is one constraint of the dual problem: a free line (tied pair), a
//! half-line (normal force), an interval (friction in 2D), a disc (friction in 3D) or
//! the point 0 (nothing moves there). Each knows its projection P, whether a point y belongs to the side
//! where the unknown is free, and a slanting function of P there.

pub(crate) mod block;
pub(crate) mod convex_set;
pub(crate) mod disc;
pub(crate) mod half_line;
pub(crate) mod interval;
pub(crate) mod line;
pub(crate) mod origin;
pub(crate) mod product;

pub use block::{Block, BlockSet};
pub use convex_set::{BlockState, ConvexSet};
pub use disc::Disc;
pub use half_line::HalfLine;
pub use interval::Interval;
pub use line::Line;
pub use origin::Origin;
pub use product::ProductSet;
