//! The symmetric part of a square matrix, packed and judged in one sweep.
//!
//! Packing is bound by memory as multiplying is: a matrix of order 5000 is 200 MB, read in the time of
//! three multiplications. Whatever is to be known of the entries is found on the same way.

use std::mem::MaybeUninit;

use rayon::prelude::*;

use super::{PackedLower, pages};
use super::kernels::{EDGE, Isa, Tile};

/// Panels that one task packs: 64 entries of a row are read in one go.
const PANELS: usize = 8;

/// What a square matrix looked like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SquareReport {
    /// No entry is NaN or infinite. If one is, the other figures mean nothing.
    pub finite: bool,
    /// max |A_ij|.
    pub largest: f64,
    /// max |A_ij − A_ji|.
    pub asymmetry: f64,
}

impl PackedLower {
    /// (A + Aᵀ)/2 of a square matrix given row by row, and what was seen on the way.
    ///
    /// # Panics
    /// When there are not order² values.
    pub fn symmetric_part(order: usize, values: &[f64]) -> (Self, SquareReport) {
        assert_eq!(values.len(), order * order, "a square matrix");
        let edges = order.div_ceil(EDGE);
        let count = edges * (edges + 1) / 2;
        let mut packed = Self {
            order,
            tiles: pages::room_for(count),
            isa: Isa::best(),
        };
        let ends = (0..edges).map(|panel| packed.panel_start(panel + 1));
        let ends: Vec<usize> = ends.collect();
        // The tiles are written where they are made: zeros first would be one more sweep, on one thread.
        let mut tiles = std::mem::take(&mut packed.tiles);
        let mut rest = &mut tiles.spare_capacity_mut()[..count];
        let mut tasks = Vec::new();
        let mut begin = 0;
        for first in (0..edges).step_by(PANELS) {
            let last = edges.min(first + PANELS);
            let (own, others) = rest.split_at_mut(ends[last - 1] - begin);
            begin = ends[last - 1];
            rest = others;
            tasks.push((first..last, own));
        }
        let judges = tasks.into_par_iter().map(|(panels, tiles)| {
            let mut judge = Judge::default();
            judge.pack(order, values, panels, tiles);
            judge
        });
        let report = judges.reduce(Judge::default, Judge::with).report();
        // SAFETY: the tasks cover all panels, and `Judge::pack` writes each tile of its panels once: those of
        // the rows from the diagonal down to the last.
        unsafe { tiles.set_len(count) };
        packed.tiles = tiles;
        (packed, report)
    }
}

/// Largest figures so far, in lanes. A lane of `poison` is NaN from the first entry on that is not finite.
#[derive(Default)]
struct Judge {
    largest: [f64; EDGE],
    asymmetry: [f64; EDGE],
    poison: [f64; EDGE],
}

impl Judge {
    /// Fills the tiles of some panels, block of rows after block of rows: the rows below the diagonal and
    /// the columns above it then both come in runs of `PANELS · EDGE` entries.
    fn pack(
        &mut self,
        order: usize,
        values: &[f64],
        panels: std::ops::Range<usize>,
        tiles: &mut [MaybeUninit<Tile>],
    ) {
        let edges = order.div_ceil(EDGE);
        for first in (panels.start..edges).step_by(PANELS) {
            let mut start = 0;
            for panel in panels.clone() {
                for block in first.max(panel)..edges.min(first + PANELS) {
                    let tile = self.tile(order, values, block * EDGE, panel * EDGE);
                    tiles[start + block - panel].write(tile);
                }
                start += edges - panel;
            }
        }
    }

    /// The tile of the rows from `row` and the columns from `column` on.
    fn tile(&mut self, order: usize, values: &[f64], row: usize, column: usize) -> Tile {
        let mut tile = Tile::ZERO;
        let (rows, columns) = (EDGE.min(order - row), EDGE.min(order - column));
        let mut below = [[0.0; EDGE]; EDGE];
        let mut above = [[0.0; EDGE]; EDGE];
        for i in 0..rows {
            let at = order * (row + i) + column;
            for (below, &value) in below.iter_mut().zip(&values[at..at + columns]) {
                below[i] = value;
            }
        }
        for (j, above) in above.iter_mut().enumerate().take(columns) {
            let at = order * (column + j) + row;
            above[..rows].copy_from_slice(&values[at..at + rows]);
        }
        for ((column, below), above) in tile.0.iter_mut().zip(&below).zip(&above) {
            for (i, (&b, &a)) in below.iter().zip(above).enumerate() {
                self.largest[i] = greater(self.largest[i], greater(a.abs(), b.abs()));
                self.asymmetry[i] = greater(self.asymmetry[i], (a - b).abs());
                self.poison[i] += 0.0 * a + 0.0 * b;
                // Halves first: the sum of two large entries may be infinite. Equal entries stay as they are.
                column[i] = 0.5 * b + 0.5 * a;
            }
        }
        if row == column {
            for (j, column) in tile.0.iter_mut().enumerate() {
                column[..j].fill(0.0);
            }
        }
        tile
    }

    fn with(self, other: Self) -> Self {
        let lanes = |a: [f64; EDGE], b: [f64; EDGE], join: fn(f64, f64) -> f64| {
            std::array::from_fn(|i| join(a[i], b[i]))
        };
        Self {
            largest: lanes(self.largest, other.largest, greater),
            asymmetry: lanes(self.asymmetry, other.asymmetry, greater),
            poison: lanes(self.poison, other.poison, |a, b| a + b),
        }
    }

    fn report(&self) -> SquareReport {
        SquareReport {
            finite: self.poison.iter().all(|x| !x.is_nan()),
            largest: self.largest.into_iter().fold(0.0, greater),
            asymmetry: self.asymmetry.into_iter().fold(0.0, greater),
        }
    }
}

/// One instruction, unlike [`f64::max`]; NaN is looked for elsewhere.
fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_symmetric_part_is_packed_and_the_matrix_judged() {
        for order in [0, 1, 7, 8, 9, 64, 65, 150] {
            let mut values: Vec<f64> = (0..order * order)
                .map(|k| ((k / order + k % order) % 17) as f64 - 3.0)
                .collect();
            let at = |i: usize, j: usize| order * i + j;
            let (packed, report) = PackedLower::symmetric_part(order, &values);
            assert!(report.finite);
            assert_eq!(report.asymmetry, 0.0);
            let largest = values.iter().fold(0.0_f64, |l, v| l.max(v.abs()));
            assert_eq!(report.largest, largest);
            for i in 0..order {
                for j in 0..=i {
                    assert_eq!(packed.get(i, j), values[at(i, j)]);
                }
            }
            if order < 7 {
                continue;
            }
            let (i, j) = (order - 1, order / 3);
            values[at(j, i)] += 0.5;
            let (packed, report) = PackedLower::symmetric_part(order, &values);
            assert_eq!(report.asymmetry, 0.5);
            assert_eq!(packed.get(i, j), values[at(i, j)] + 0.25);
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                for place in [at(i, j), at(j, i), at(i, i)] {
                    let good = std::mem::replace(&mut values[place], bad);
                    assert!(!PackedLower::symmetric_part(order, &values).1.finite);
                    values[place] = good;
                }
            }
        }
    }
}
