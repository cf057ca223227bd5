//! Dense lower triangles, packed so that one sweep reads them front to back.
//!
//! Solving with a dense triangular factor and multiplying by a dense symmetric
//! matrix are bound by memory: each entry of the triangle is used once or twice.
//! The triangle is therefore cut into panels of eight columns, each panel into
//! 8×8 tiles from the diagonal down, and everything is stored in the order in
//! which it is read.

mod pages;

use crate::kernels::{self, Chunk, Isa, LANES as EDGE, Tile};
use crate::operator::SymmetricEntries;
use faer::{Mat, MatRef};

/// A lower triangle of order n in n(n + 8)/2 entries: of a triangular matrix L,
/// or standing for the symmetric matrix S with this lower triangle.
#[derive(Clone, Debug)]
pub struct PackedLower {
    order: usize,
    tiles: Vec<Tile>,
    isa: Isa,
}

impl PackedLower {
    /// Zero of order n.
    pub fn zeros(order: usize) -> Self {
        let edges = order.div_ceil(EDGE);
        let count = edges * (edges + 1) / 2;
        let mut tiles = pages::room_for(count);
        tiles.resize(count, Tile::ZERO);
        Self {
            order,
            tiles,
            isa: Isa::best(),
        }
    }

    /// Copies the lower triangle of a square matrix; what lies above is not read.
    ///
    /// # Panics
    /// When the matrix is not square.
    pub fn from_lower(matrix: MatRef<'_, f64>) -> Self {
        assert_eq!(matrix.nrows(), matrix.ncols(), "a triangle is square");
        let mut packed = Self::zeros(matrix.nrows());
        for j in 0..matrix.ncols() {
            for i in j..matrix.nrows() {
                packed.set(i, j, matrix[(i, j)]);
            }
        }
        packed
    }

    /// Order n.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The entry (i, j), i ≥ j.
    pub fn get(&self, i: usize, j: usize) -> f64 {
        assert!(j <= i && i < self.order, "outside the lower triangle");
        self.tiles[self.tile_index(i, j)].0[j % EDGE][i % EDGE]
    }

    /// Sets the entry (i, j), i ≥ j.
    pub fn set(&mut self, i: usize, j: usize, value: f64) {
        assert!(j <= i && i < self.order, "outside the lower triangle");
        let index = self.tile_index(i, j);
        self.tiles[index].0[j % EDGE][i % EDGE] = value;
    }

    /// The lower triangle as a dense matrix, zero above the diagonal.
    pub fn to_dense(&self) -> Mat<f64> {
        Mat::from_fn(self.order, self.order, |i, j| {
            if i >= j { self.get(i, j) } else { 0.0 }
        })
    }

    /// Bytes that one sweep reads.
    pub fn bytes(&self) -> usize {
        std::mem::size_of_val(&self.tiles[..])
    }

    fn tile_index(&self, i: usize, j: usize) -> usize {
        self.panel_start(j / EDGE) + i / EDGE - j / EDGE
    }

    /// Index of the first (diagonal) tile of a panel.
    fn panel_start(&self, panel: usize) -> usize {
        let edges = self.order.div_ceil(EDGE);
        panel * edges - panel * panel.saturating_sub(1) / 2
    }

    /// Diagonal tile and the tiles below it.
    fn panel(&self, panel: usize) -> (&Tile, &[Tile]) {
        let tiles = &self.tiles[self.panel_start(panel)..self.panel_start(panel + 1)];
        (&tiles[0], &tiles[1..])
    }

    /// x ← L⁻¹ x. Entries on the diagonal must not be zero.
    ///
    /// # Panics
    /// When x has not the length n.
    pub fn solve_lower_in_place(&self, x: &mut [f64]) {
        assert_eq!(x.len(), self.order);
        with_whole_chunks(x, |chunks, mut last| {
            for panel in 0..chunks.len() {
                let (diagonal, below) = self.panel(panel);
                let (head, tail) = chunks.split_at_mut(panel + 1);
                let own = &mut head[panel];
                forward_substitute(diagonal, own, EDGE);
                let (full, rest) = below.split_at(tail.len());
                kernels::subtract_product(self.isa, full, own, tail);
                if let (Some(last), [tile]) = (last.as_deref_mut(), rest) {
                    kernels::subtract_product(
                        self.isa,
                        std::slice::from_ref(tile),
                        own,
                        std::slice::from_mut(last),
                    );
                }
            }
            if let Some(last) = last {
                let (diagonal, _) = self.panel(chunks.len());
                forward_substitute(diagonal, last, self.order % EDGE);
            }
        });
    }

    /// x ← L⁻ᵀ x. Entries on the diagonal must not be zero.
    ///
    /// # Panics
    /// When x has not the length n.
    pub fn solve_upper_in_place(&self, x: &mut [f64]) {
        assert_eq!(x.len(), self.order);
        with_whole_chunks(x, |chunks, mut last| {
            if let Some(last) = last.as_deref_mut() {
                let (diagonal, _) = self.panel(chunks.len());
                backward_substitute(diagonal, last, self.order % EDGE);
            }
            for panel in (0..chunks.len()).rev() {
                let (diagonal, below) = self.panel(panel);
                let (head, tail) = chunks.split_at_mut(panel + 1);
                let own = &mut head[panel];
                let (full, rest) = below.split_at(tail.len());
                subtract(own, &kernels::transposed_product(self.isa, full, tail));
                if let (Some(last), [tile]) = (last.as_deref(), rest) {
                    let tile = std::slice::from_ref(tile);
                    let last = std::slice::from_ref(last);
                    subtract(own, &kernels::transposed_product(self.isa, tile, last));
                }
                backward_substitute(diagonal, own, EDGE);
            }
        });
    }

    /// y ← S x for the symmetric matrix S with this lower triangle, reading the
    /// triangle once.
    ///
    /// # Panics
    /// When x or y has not the length n.
    pub fn symmetric_mul(&self, x: &[f64], y: &mut [f64]) {
        assert_eq!(x.len(), self.order);
        assert_eq!(y.len(), self.order);
        y.fill(0.0);
        let (x_chunks, x_rest) = x.as_chunks::<EDGE>();
        let mut x_last = [0.0; EDGE];
        x_last[..x_rest.len()].copy_from_slice(x_rest);
        with_whole_chunks(y, |y_chunks, mut y_last| {
            for panel in 0..y_chunks.len() {
                let (diagonal, below) = self.panel(panel);
                let own = &x_chunks[panel];
                let (head, tail) = y_chunks.split_at_mut(panel + 1);
                let (full, rest) = below.split_at(tail.len());
                let x_tail = &x_chunks[panel + 1..];
                let mut sum = kernels::both_products(self.isa, full, own, x_tail, tail);
                if let (Some(y_last), [tile]) = (y_last.as_deref_mut(), rest) {
                    let more = kernels::both_products(
                        self.isa,
                        std::slice::from_ref(tile),
                        own,
                        std::slice::from_ref(&x_last),
                        std::slice::from_mut(y_last),
                    );
                    add(&mut sum, &more);
                }
                symmetric_tile_product(diagonal, own, &mut sum);
                add(&mut head[panel], &sum);
            }
            if let Some(y_last) = y_last {
                let (diagonal, _) = self.panel(y_chunks.len());
                symmetric_tile_product(diagonal, &x_last, y_last);
            }
        });
    }
}

impl SymmetricEntries for PackedLower {
    fn entry(&self, i: usize, j: usize) -> f64 {
        self.get(i, j)
    }
}

/// Runs `work` on the whole chunks of x and on its zero-padded remainder, if any.
fn with_whole_chunks(x: &mut [f64], work: impl FnOnce(&mut [Chunk], Option<&mut Chunk>)) {
    let (chunks, rest) = x.as_chunks_mut::<EDGE>();
    if rest.is_empty() {
        return work(chunks, None);
    }
    let mut last = [0.0; EDGE];
    last[..rest.len()].copy_from_slice(rest);
    work(chunks, Some(&mut last));
    rest.copy_from_slice(&last[..rest.len()]);
}

/// x ← T⁻¹ x with the lower triangle of the first `size` rows and columns of T.
fn forward_substitute(tile: &Tile, x: &mut Chunk, size: usize) {
    for k in 0..size {
        x[k] /= tile.0[k][k];
        for i in k + 1..size {
            x[i] -= tile.0[k][i] * x[k];
        }
    }
}

/// x ← T⁻ᵀ x with the lower triangle of the first `size` rows and columns of T.
fn backward_substitute(tile: &Tile, x: &mut Chunk, size: usize) {
    for k in (0..size).rev() {
        let column = &tile.0[k];
        let below = column[k + 1..size].iter().zip(&x[k + 1..size]);
        let sum: f64 = below.map(|(a, x)| a * x).sum();
        x[k] = (x[k] - sum) / column[k];
    }
}

/// y ← y + S x for the symmetric tile S with this lower triangle.
fn symmetric_tile_product(tile: &Tile, x: &Chunk, y: &mut Chunk) {
    for k in 0..EDGE {
        y[k] += tile.0[k][k] * x[k];
        for i in k + 1..EDGE {
            y[i] += tile.0[k][i] * x[k];
            y[k] += tile.0[k][i] * x[i];
        }
    }
}

fn add(y: &mut Chunk, x: &Chunk) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += x;
    }
}

fn subtract(y: &mut Chunk, x: &Chunk) {
    for (y, x) in y.iter_mut().zip(x) {
        *y -= x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ORDERS: [usize; 14] = [0, 1, 2, 7, 8, 9, 15, 16, 17, 63, 64, 65, 129, 257];

    /// Entries that no symmetry of an index error can hide, diagonal dominant.
    fn entry(i: usize, j: usize) -> f64 {
        if i == j {
            2.0 + (i % 5) as f64
        } else {
            ((i * 31 + j * 17) % 23) as f64 / 400.0 - 0.02
        }
    }

    fn vector(n: usize) -> Vec<f64> {
        (0..n).map(|i| ((i * 13) % 29) as f64 / 7.0 - 2.0).collect()
    }

    fn packed(n: usize, isa: Isa) -> PackedLower {
        // NaN above the diagonal: it must not be read.
        let dense = Mat::from_fn(n, n, |i, j| if i >= j { entry(i, j) } else { f64::NAN });
        let mut packed = PackedLower::from_lower(dense.as_ref());
        packed.isa = isa;
        packed
    }

    fn assert_close(actual: &[f64], expected: &[f64], what: &str, isa: Isa) {
        for (i, (a, e)) in actual.iter().zip(expected).enumerate() {
            let bound = 1e-12 * (1.0 + e.abs());
            assert!(
                (a - e).abs() <= bound,
                "{what}, {isa:?}, n = {}, entry {i}: {a} instead of {e}",
                expected.len()
            );
        }
    }

    #[test]
    fn triangular_solves_invert_naive_products() {
        for isa in Isa::available() {
            for n in ORDERS {
                let l = packed(n, isa);
                let x = vector(n);
                let mut lower: Vec<f64> = (0..n)
                    .map(|i| (0..=i).map(|j| entry(i, j) * x[j]).sum())
                    .collect();
                l.solve_lower_in_place(&mut lower);
                assert_close(&lower, &x, "L⁻¹", isa);
                let mut upper: Vec<f64> = (0..n)
                    .map(|j| (j..n).map(|i| entry(i, j) * x[i]).sum())
                    .collect();
                l.solve_upper_in_place(&mut upper);
                assert_close(&upper, &x, "L⁻ᵀ", isa);
            }
        }
    }

    #[test]
    fn symmetric_product_is_the_naive_one() {
        for isa in Isa::available() {
            for n in ORDERS {
                let s = packed(n, isa);
                let x = vector(n);
                let expected: Vec<f64> = (0..n)
                    .map(|i| (0..n).map(|j| entry(i.max(j), i.min(j)) * x[j]).sum())
                    .collect();
                let mut y = vec![f64::NAN; n];
                s.symmetric_mul(&x, &mut y);
                assert_close(&y, &expected, "S x", isa);
            }
        }
    }

    #[test]
    fn large_triangles_are_zero_and_hold_what_is_set() {
        // Above the size from which large pages are asked for.
        let n = 1500;
        let mut triangle = PackedLower::zeros(n);
        assert!(triangle.bytes() > 8 << 20);
        let mut y = vec![f64::NAN; n];
        triangle.symmetric_mul(&vec![1.0; n], &mut y);
        assert_eq!(y, vec![0.0; n]);
        triangle.set(n - 1, 3, 2.0);
        triangle.symmetric_mul(&vec![1.0; n], &mut y);
        assert_eq!((y[3], y[n - 1], y.iter().sum::<f64>()), (2.0, 2.0, 4.0));
    }

    #[test]
    fn dense_copy_is_the_lower_triangle() {
        for n in [0, 1, 8, 19] {
            let dense = packed(n, Isa::best()).to_dense();
            for i in 0..n {
                for j in 0..n {
                    assert_eq!(dense[(i, j)], if i >= j { entry(i, j) } else { 0.0 });
                }
            }
        }
    }
}
