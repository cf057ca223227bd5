//! Contact surfaces: their nodes and normals, and their smooth patches.

pub(crate) mod nodes;
pub(crate) mod patches;
