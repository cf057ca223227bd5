//! The loops that everything waits for, compiled once per instruction set and chosen at run time.
//!
//! Each does nothing but stream a matrix once from memory.

pub(crate) mod isa;
mod rows;
mod tiles;
mod vectors;

pub(crate) use isa::{Chunk, Isa, LANES};
pub(crate) use rows::{row_products, row_report};
pub(crate) use tiles::{Tile, both_products, subtract_product, transposed_product};
pub(crate) use vectors::{axpy, dot};
