//! The three loops over a panel of tiles.
//!
//! A panel is a column of 8×8 tiles, each stored by columns. Eight columns are worked on together, so
//! that the vector along the rows is read and written once per eight columns.

use super::isa::{Chunk, Isa, Kind, LANES as EDGE, for_each_isa, multiply_add};

/// An 8×8 block stored by columns, on its own cache lines.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Tile(pub(crate) [Chunk; EDGE]);

impl Tile {
    pub(crate) const ZERO: Tile = Tile([[0.0; EDGE]; EDGE]);
}

for_each_isa! {
    /// y ← y − P x for the panel P of tiles, one chunk of y per tile.
    // Not AVX-512: for it the compiler turns this loop around and gathers one
    // entry from each of eight tiles, which is ten times slower.
    subtract_product = subtract_product_loop(tiles: &[Tile], x: &Chunk, y: &mut [Chunk]),
    "avx2,fma"
}

for_each_isa! {
    /// Pᵀ y for the panel P of tiles, one chunk of y per tile.
    // Not AVX-512: from memory it reaches two thirds of the rate of AVX2.
    transposed_product = transposed_product_loop(tiles: &[Tile], y: &[Chunk]) -> Chunk,
    "avx2,fma"
}

for_each_isa! {
    /// y ← y + P x, and returns Pᵀ z: both products with one reading of the panel.
    both_products = both_products_loop(tiles: &[Tile], x: &Chunk, z: &[Chunk], y: &mut [Chunk]) -> Chunk,
    "avx512f,avx2,fma"
}

#[inline(always)]
fn subtract_product_loop<const FMA: bool>(tiles: &[Tile], x: &Chunk, y: &mut [Chunk]) {
    let minus_x = x.map(|x| -x);
    for (tile, y) in tiles.iter().zip(y) {
        let mut sum = *y;
        for (column, &x) in tile.0.iter().zip(&minus_x) {
            for (s, &a) in sum.iter_mut().zip(column) {
                *s = multiply_add::<FMA>(a, x, *s);
            }
        }
        *y = sum;
    }
}

#[inline(always)]
fn transposed_product_loop<const FMA: bool>(tiles: &[Tile], y: &[Chunk]) -> Chunk {
    let mut sums = [[0.0; EDGE]; EDGE];
    for (tile, y) in tiles.iter().zip(y) {
        for (sum, column) in sums.iter_mut().zip(&tile.0) {
            for ((s, &a), &y) in sum.iter_mut().zip(column).zip(y) {
                *s = multiply_add::<FMA>(a, y, *s);
            }
        }
    }
    sums.map(|sum| sum.iter().sum())
}

#[inline(always)]
fn both_products_loop<const FMA: bool>(
    tiles: &[Tile],
    x: &Chunk,
    z: &[Chunk],
    y: &mut [Chunk],
) -> Chunk {
    let mut sums = [[0.0; EDGE]; EDGE];
    for ((tile, z), y) in tiles.iter().zip(z).zip(y) {
        let mut product = *y;
        for ((column, &x), sum) in tile.0.iter().zip(x).zip(&mut sums) {
            for (((p, s), &a), &z) in product.iter_mut().zip(sum).zip(column).zip(z) {
                *p = multiply_add::<FMA>(a, x, *p);
                *s = multiply_add::<FMA>(a, z, *s);
            }
        }
        *y = product;
    }
    sums.map(|sum| sum.iter().sum())
}
