//! Mortar coupling with dual multipliers: integrals over segments, the dual basis on each face, and
//! the rows that come of them.

pub(crate) mod couple;
mod coverage;
mod dual;
pub(crate) mod integrals;
pub(crate) mod rows;
pub(crate) mod rules;
pub(crate) mod segment;
pub(crate) mod slave;
