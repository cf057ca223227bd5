//! Affine constraints against merged meshes, closed forms, full rings and dense algebra.

mod bodies;
mod couplings;
mod equations;
mod motions;
mod promises;
