//! The loops over eight rows of a square matrix that lies whole in memory.

use super::isa::{Chunk, Isa, Kind, LANES, for_each_isa, multiply_add};

for_each_isa! {
    /// y ← y + Rᵀ x, and returns R z, for eight rows R of as many chunks as z and y: both products with
    /// one reading of the rows.
    row_products = row_products_loop(rows: [&[Chunk]; LANES], x: &Chunk, z: &[Chunk], y: &mut [Chunk]) -> Chunk,
    "avx512f,avx2,fma"
}

for_each_isa! {
    /// The largest |a| of eight rows and of the eight columns that mirror them, and the largest difference of
    /// mirrored entries, as the bits of a double: those of NaN and infinity are above all others.
    /// `columns` has eight rows per chunk of `rows`.
    row_report = row_report_loop(rows: [&[Chunk]; LANES], columns: &[&Chunk]) -> [u64; 2],
    "avx512f,avx2,fma"
}

#[inline(always)]
fn row_products_loop<const FMA: bool>(
    rows: [&[Chunk]; LANES],
    x: &Chunk,
    z: &[Chunk],
    y: &mut [Chunk],
) -> Chunk {
    let rows = rows.map(|row| &row[..z.len()]);
    let mut sums = [[0.0; LANES]; LANES];
    for (c, (z, y)) in z.iter().zip(y).enumerate() {
        let mut product = *y;
        for ((row, &x), sum) in rows.iter().zip(x).zip(&mut sums) {
            for (((p, s), &a), &z) in product.iter_mut().zip(sum).zip(&row[c]).zip(z) {
                *p = multiply_add::<FMA>(a, x, *p);
                *s = multiply_add::<FMA>(a, z, *s);
            }
        }
        *y = product;
    }
    sums.map(|sum| sum.iter().sum())
}

#[inline(always)]
fn row_report_loop<const FMA: bool>(rows: [&[Chunk]; LANES], columns: &[&Chunk]) -> [u64; 2] {
    let mut largest = [0; LANES];
    let mut difference = [0; LANES];
    for (c, columns) in columns.as_chunks::<LANES>().0.iter().enumerate() {
        for (i, row) in rows.iter().enumerate() {
            for (j, &own) in row[c].iter().enumerate() {
                let mirrored = columns[j][i];
                largest[j] = bits(own).max(bits(mirrored)).max(largest[j]);
                difference[j] = bits(own - mirrored).max(difference[j]);
            }
        }
    }
    let over_lanes = |lanes: [u64; LANES]| lanes.into_iter().fold(0, u64::max);
    [over_lanes(largest), over_lanes(difference)]
}

/// The bits of |x|, in the order of the numbers.
#[inline(always)]
fn bits(x: f64) -> u64 {
    x.abs().to_bits()
}
