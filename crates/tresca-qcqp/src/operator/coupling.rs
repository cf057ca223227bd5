//! B_i: how the contact rows hang on the dofs of one body.

use faer::sparse::SparseRowMat;

/// The rows of B on one body: one row per unknown of λ, one column per dof.
/// Sparse: a row touches the few dofs of its contact pair.
#[derive(Clone, Debug)]
pub struct Coupling {
    matrix: SparseRowMat<usize, f64>,
}

impl Coupling {
    /// From the matrix.
    pub fn new(matrix: SparseRowMat<usize, f64>) -> Self {
        Self { matrix }
    }

    /// Number of unknowns of λ.
    pub fn rows(&self) -> usize {
        self.matrix.nrows()
    }

    /// Number of dofs.
    pub fn dofs(&self) -> usize {
        self.matrix.ncols()
    }

    /// The dofs that any row touches, ascending: the contact dofs of the body.
    pub fn touched(&self) -> Vec<usize> {
        let mut dofs: Vec<usize> = self.matrix.symbolic().col_idx().to_vec();
        dofs.sort_unstable();
        dofs.dedup();
        dofs
    }

    /// The same rows on `dofs` alone, which become columns 0, 1, … in the order given.
    /// Entries on other dofs are dropped.
    pub fn restricted(&self, dofs: &[usize]) -> Self {
        let mut column = vec![usize::MAX; self.dofs()];
        for (new, &old) in dofs.iter().enumerate() {
            column[old] = new;
        }
        let mut row_start = vec![0];
        let (mut columns, mut values) = (Vec::new(), Vec::new());
        for i in 0..self.rows() {
            let mut row: Vec<_> = self.row(i).map(|(j, b)| (column[j], b)).collect();
            row.retain(|(j, _)| *j != usize::MAX);
            row.sort_unstable_by_key(|(j, _)| *j);
            columns.extend(row.iter().map(|(j, _)| *j));
            values.extend(row.iter().map(|(_, b)| *b));
            row_start.push(columns.len());
        }
        let symbolic = faer::sparse::SymbolicSparseRowMat::new_checked(
            self.rows(),
            dofs.len(),
            row_start,
            None,
            columns,
        );
        Self {
            matrix: SparseRowMat::new(symbolic, values),
        }
    }

    /// Entries (dof, coefficient) of a row.
    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> {
        let matrix = self.matrix.as_ref();
        matrix
            .col_idx_of_row(i)
            .zip(matrix.val_of_row(i))
            .map(|(j, b)| (j, *b))
    }

    /// v ← v + B_iᵀ λ.
    ///
    /// # Panics
    /// When λ has more entries than there are rows, or v fewer than there are dofs.
    pub fn add_transposed_product(&self, lambda: &[f64], v: &mut [f64]) {
        for (i, &l) in lambda.iter().enumerate().filter(|(_, l)| **l != 0.0) {
            for (j, b) in self.row(i) {
                v[j] += b * l;
            }
        }
    }

    /// v ← v + |B_i|ᵀ |λ|: what the sums of [`add_transposed_product`](Self::add_transposed_product) are made of.
    ///
    /// # Panics
    /// When λ has more entries than there are rows, or v fewer than there are dofs.
    pub fn add_transposed_sizes(&self, lambda: &[f64], v: &mut [f64]) {
        for (i, &l) in lambda.iter().enumerate().filter(|(_, l)| **l != 0.0) {
            for (j, b) in self.row(i) {
                v[j] += (b * l).abs();
            }
        }
    }

    /// out ← out + B_i v.
    ///
    /// # Panics
    /// When `out` has more entries than there are rows, or v fewer than there are dofs.
    pub fn add_product(&self, v: &[f64], out: &mut [f64]) {
        for (i, out) in out.iter_mut().enumerate() {
            *out += self.row(i).map(|(j, b)| b * v[j]).sum::<f64>();
        }
    }

    /// v ← B_iᵀ λ.
    pub(super) fn transposed_mul(&self, lambda: &[f64], v: &mut [f64]) {
        v.fill(0.0);
        self.add_transposed_product(lambda, v);
    }

    /// out ← B_i v.
    pub(super) fn mul(&self, v: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        self.add_product(v, out);
    }
}
