//! Case files: what is read from a good one, and what is said about a bad one.

mod docs;
mod files;
mod good;
mod keys;
mod names;
mod random;
mod support;
mod types;
mod values;
