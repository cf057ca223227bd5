//! A symmetric matrix that lies whole in somebody's memory, row by row, and is multiplied there.
//!
//! A matrix of order 5000 is 200 MB. Copying its triangle into the order that suits best takes as long as
//! ten multiplications; reading eight rows at a time where they lie is as fast as reading the copy.

use crate::kernels::{self, Chunk, Isa, LANES};
use crate::operator::SymmetricEntries;
use crate::vector::{axpy, dot};
use rayon::prelude::*;

/// Panels of `LANES` rows and columns that are compared with their mirror image together, so that both come
/// in runs of 512 bytes.
const PANELS: usize = 8;

/// The symmetric matrix with the lower triangle of the given one; what lies above is for
/// [`report`](SquareMatrix::report) alone.
#[derive(Clone, Copy, Debug)]
pub struct SquareMatrix<'a> {
    order: usize,
    values: &'a [f64],
    isa: Isa,
}

/// What a square matrix looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SquareReport {
    /// max |A_ij|; NaN or infinite if one of the entries is.
    pub largest: f64,
    /// max |A_ij − A_ji|.
    pub asymmetry: f64,
}

impl<'a> SquareMatrix<'a> {
    /// Takes the order² values of a matrix, row by row.
    ///
    /// # Panics
    /// When there are not order² values.
    pub fn new(order: usize, values: &'a [f64]) -> Self {
        assert_eq!(values.len(), order * order, "a square matrix");
        Self {
            order,
            values,
            isa: Isa::best(),
        }
    }

    /// Order n.
    pub fn order(&self) -> usize {
        self.order
    }

    fn row(&self, i: usize) -> &'a [f64] {
        &self.values[self.order * i..self.order * (i + 1)]
    }

    /// The entries `columns` of the rows of a panel; the columns come in whole chunks.
    fn panel(&self, panel: usize, columns: std::ops::Range<usize>) -> [&'a [Chunk]; LANES] {
        std::array::from_fn(|i| {
            let (chunks, _) = self.row(panel * LANES + i)[columns.clone()].as_chunks();
            chunks
        })
    }

    /// y ← S x for the symmetric matrix S with this lower triangle, reading the triangle once.
    ///
    /// # Panics
    /// When x or y has not the length n.
    pub fn symmetric_mul(&self, x: &[f64], y: &mut [f64]) {
        assert_eq!(x.len(), self.order);
        assert_eq!(y.len(), self.order);
        y.fill(0.0);
        let (x_chunks, _) = x.as_chunks::<LANES>();
        for (panel, own) in x_chunks.iter().enumerate() {
            let first = panel * LANES;
            let (y_chunks, _) = y.as_chunks_mut::<LANES>();
            let (y_left, y_own) = y_chunks.split_at_mut(panel);
            let rows = self.panel(panel, 0..first);
            let sums = kernels::row_products(self.isa, rows, own, &x_chunks[..panel], y_left);
            for (y, sum) in y_own[0].iter_mut().zip(sums) {
                *y += sum;
            }
            for i in 0..LANES {
                self.add_row(first + i, first, x, y);
            }
        }
        for i in x_chunks.len() * LANES..self.order {
            self.add_row(i, 0, x, y);
        }
    }

    /// Adds what the entries of row i from column `first` to the diagonal have to give to S x.
    fn add_row(&self, i: usize, first: usize, x: &[f64], y: &mut [f64]) {
        let row = &self.row(i)[first..=i];
        let (diagonal, left) = (row[i - first], &row[..i - first]);
        y[i] += dot(left, &x[first..i]) + diagonal * x[i];
        axpy(x[i], left, &mut y[first..i]);
    }

    /// Looks at every entry, both triangles, on all threads.
    pub fn report(&self) -> SquareReport {
        let panels = self.order / LANES;
        let firsts: Vec<usize> = (0..panels).step_by(PANELS).collect();
        let found = firsts
            .into_par_iter()
            .map(|first| self.report_of_panels(first..panels.min(first + PANELS)))
            .reduce(|| [0; 2], larger);
        let rest = (panels * LANES..self.order)
            .flat_map(|i| (0..=i).map(move |j| (i, j)))
            .map(|(i, j)| (self.row(i)[j], self.row(j)[i]))
            .map(|(below, above)| {
                let largest = below.abs().to_bits().max(above.abs().to_bits());
                [largest, (below - above).abs().to_bits()]
            });
        // The bits of doubles without sign are ordered as the doubles are, NaN above infinity above all else.
        let [largest, asymmetry] = rest.fold(found, larger).map(f64::from_bits);
        SquareReport { largest, asymmetry }
    }

    /// Brings a block into the cache: loads that nothing waits for come many at a time.
    fn fetch(&self, rows: std::ops::Range<usize>, columns: std::ops::Range<usize>) {
        let mut touched = 0;
        for i in rows.start * LANES..rows.end * LANES {
            let row = &self.row(i)[columns.start * LANES..columns.end * LANES];
            for value in row.iter().step_by(LANES) {
                touched ^= value.to_bits();
            }
        }
        std::hint::black_box(touched);
    }

    /// The largest figures of the rows of some panels, up to the diagonal, and of the columns that mirror them.
    fn report_of_panels(&self, panels: std::ops::Range<usize>) -> [u64; 2] {
        let mut found = [0; 2];
        for left in (0..panels.end).step_by(PANELS) {
            let right = panels.end.min(left + PANELS);
            self.fetch(panels.clone(), left..right);
            self.fetch(left..right, panels.clone());
            for panel in panels.clone() {
                let columns = left * LANES..(left + PANELS).min(panel + 1) * LANES;
                let rows = self.panel(panel, columns.clone());
                let mut mirror: [&Chunk; PANELS * LANES] = [&[0.0; LANES]; PANELS * LANES];
                let mirror = &mut mirror[..columns.len()];
                for (mirrored, j) in mirror.iter_mut().zip(columns) {
                    let (chunks, _) = self.row(j)[panel * LANES..].as_chunks();
                    *mirrored = &chunks[0];
                }
                found = larger(found, kernels::row_report(self.isa, rows, mirror));
            }
        }
        found
    }
}

impl SymmetricEntries for SquareMatrix<'_> {
    fn entry(&self, i: usize, j: usize) -> f64 {
        debug_assert!(j <= i, "outside the lower triangle");
        self.values[self.order * i + j]
    }
}

fn larger(a: [u64; 2], b: [u64; 2]) -> [u64; 2] {
    [a[0].max(b[0]), a[1].max(b[1])]
}

#[cfg(test)]
mod tests {
    use super::*;

    const ORDERS: [usize; 12] = [0, 1, 2, 7, 8, 9, 15, 16, 63, 64, 65, 150];

    fn symmetric(order: usize) -> Vec<f64> {
        let entry = |k: usize| {
            let (i, j) = (k / order, k % order);
            ((i.min(j) * 31 + i.max(j) * 17) % 23) as f64 - 9.0
        };
        (0..order * order).map(entry).collect()
    }

    #[test]
    fn the_product_is_that_of_the_lower_triangle_and_its_mirror_image() {
        for isa in Isa::available() {
            for order in ORDERS {
                let whole = symmetric(order);
                let mut values = whole.clone();
                for i in 0..order {
                    values[order * i + i + 1..order * (i + 1)].fill(f64::NAN);
                }
                let mut matrix = SquareMatrix::new(order, &values);
                matrix.isa = isa;
                let x: Vec<f64> = (0..order).map(|i| ((i * 13) % 29) as f64 - 8.0).collect();
                let mut y = vec![f64::NAN; order];
                matrix.symmetric_mul(&x, &mut y);
                // Whole numbers: exact in any order of summation.
                for (i, y) in y.iter().enumerate() {
                    let row = &whole[order * i..order * (i + 1)];
                    let expected: f64 = row.iter().zip(&x).map(|(a, x)| a * x).sum();
                    assert_eq!(*y, expected, "{isa:?}, order {order}, row {i}");
                }
            }
        }
    }

    #[test]
    fn every_entry_is_looked_at() {
        for isa in Isa::available() {
            for order in ORDERS {
                let mut values = symmetric(order);
                let report = |values: &[f64]| {
                    let mut matrix = SquareMatrix::new(order, values);
                    matrix.isa = isa;
                    matrix.report()
                };
                let largest = values.iter().fold(0.0_f64, |l, v| l.max(v.abs()));
                let expected = SquareReport {
                    largest,
                    asymmetry: 0.0,
                };
                assert_eq!(report(&values), expected, "{isa:?}, order {order}");
                for k in 0..order * order {
                    // Large orders by sample.
                    if order > 20 && k % 37 != 0 {
                        continue;
                    }
                    let good = values[k];
                    let diagonal = k / order == k % order;
                    values[k] = good - 0.5;
                    let asymmetry = if diagonal { 0.0 } else { 0.5 };
                    assert_eq!(report(&values).asymmetry, asymmetry, "entry {k} of {order}");
                    values[k] = -100.0;
                    assert_eq!(report(&values).largest, 100.0, "entry {k} of {order}");
                    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                        values[k] = bad;
                        assert!(!report(&values).largest.is_finite(), "entry {k} of {order}");
                    }
                    values[k] = good;
                }
            }
        }
    }
}
