//! The reduced Newton systems (ZᵀAZ + C) s = −Zᵀ r: their spaces, how they are solved, and what is kept of A to
//! precondition them.

pub(crate) mod operator_memory;
pub(crate) mod preconditioner;
mod recycled_products;
pub(crate) mod reduced_space;
pub(crate) mod system;
pub(crate) mod tangent;
