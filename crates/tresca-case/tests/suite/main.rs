//! Case files: what is read from a good one, and what is said about a bad one.

mod docs;
mod expression;
mod fields;
mod files;
mod friction;
mod good;
mod keys;
mod loads;
mod meshes;
mod names;
mod obstacles;
mod plane;
mod random;
mod steps;
mod support;
mod types;
mod values;
