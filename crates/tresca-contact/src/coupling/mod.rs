//! From two surfaces, or a surface and an obstacle, to pairs.

pub(crate) mod choice;
mod matching;
pub(crate) mod mortar;
pub(crate) mod node_by_node;
pub(crate) mod obstacle;
