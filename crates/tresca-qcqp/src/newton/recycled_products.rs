//! Products with A are dear: those that were paid for are kept.
//!
//! Every Lanczos and CG direction p comes with its product w = Ap. The products W = AP and the
//! Gram matrix PᵀAP = PᵀW give W (PᵀAP)⁻¹ Wᵀ, the part of A that has been seen: exact on the span
//! of P, and nowhere above A. It belongs to A alone, so that what was learnt under one active set
//! (or one right-hand side) serves the next.
//!
//! The directions are not made orthogonal and not even kept: one sweep over W gives the new rows of
//! the Gram matrix, where Gram and Schmidt would need six over W and P for each of them. Nobody asks
//! for what a CG run has shown before its end, so one sweep serves the whole run.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};
use tresca_la::vector::dot;

/// A direction of which less than this part (in the squared A-norm) is new is not kept.
const LEAST_NEW: f64 = 1e-6;

/// Products W = AP, each direction of P with the A-norm 1, and the factor of PᵀAP.
#[derive(Clone, Debug)]
pub(crate) struct RecycledProducts {
    capacity: usize,
    products: Columns,
    /// The Cholesky factor of PᵀAP row by row, row i up to the diagonal.
    factor: Vec<Vec<f64>>,
    /// Directions, A-norm 1, and their products that are not in W yet.
    offered: [Columns; 2],
}

/// Vectors of one length, one after another.
#[derive(Clone, Debug, Default)]
struct Columns {
    rows: usize,
    values: Vec<f64>,
}

impl Columns {
    fn len(&self) -> usize {
        self.values.len().checked_div(self.rows).unwrap_or(0)
    }

    fn push(&mut self, column: impl ExactSizeIterator<Item = f64>) {
        self.rows = column.len();
        self.values.extend(column);
    }

    fn truncate(&mut self, count: usize) {
        self.values.truncate(count * self.rows);
    }

    fn iter(&self) -> impl Iterator<Item = &[f64]> {
        // A vector without entries is never pushed: nothing is new in it.
        self.values.chunks_exact(self.rows.max(1))
    }

    fn matrix(&self) -> MatRef<'_, f64> {
        MatRef::from_column_major_slice(&self.values, self.rows, self.len())
    }
}

impl RecycledProducts {
    /// Keeps at most `capacity` products, the first ones offered.
    pub fn new(capacity: usize) -> Self {
        Self {
            capacity,
            products: Columns::default(),
            factor: Vec::new(),
            offered: Default::default(),
        }
    }

    /// Keeps at most `capacity` products from now on; those above it go.
    pub fn set_capacity(&mut self, capacity: usize) {
        self.capacity = capacity;
        // The factor of a leading block is the leading block of the factor.
        self.products.truncate(capacity);
        self.factor.truncate(capacity);
        let room = capacity - self.len();
        self.offered.iter_mut().for_each(|o| o.truncate(room));
    }

    /// Number of products kept.
    pub fn len(&self) -> usize {
        self.products.len()
    }

    /// The products W, one by one.
    pub fn products(&self) -> impl Iterator<Item = &[f64]> {
        self.products.iter()
    }

    /// PᵀAP, its lower triangle.
    pub fn gram(&self) -> Mat<f64> {
        let row = |i: usize| &self.factor[i];
        Mat::from_fn(self.len(), self.len(), |i, j| {
            if i >= j {
                dot(&row(i)[..=j], row(j))
            } else {
                0.0
            }
        })
    }

    /// Offers the product of `direction` with A, to be kept if there is room and enough of the direction is new.
    pub fn offer(&mut self, direction: &[f64], product: &[f64]) {
        if self.len() + self.offered[0].len() >= self.capacity {
            return;
        }
        let square = dot(direction, product);
        if !(square > 0.0 && square.is_finite()) {
            return;
        }
        let scale = square.sqrt().recip();
        for (offered, v) in self.offered.iter_mut().zip([direction, product]) {
            offered.push(v.iter().map(|v| scale * v));
        }
    }

    /// Takes into W what has been offered since the last time.
    pub fn settle(&mut self) {
        let [directions, products] = std::mem::take(&mut self.offered);
        if directions.len() == 0 {
            return;
        }
        self.products.rows = products.rows;
        // WᵀP for the offered P, with the W before the offer and with what is offered.
        let product = |w: &Columns| {
            let mut product = Mat::zeros(w.len(), directions.len());
            let (w, p) = (w.matrix().transpose(), directions.matrix());
            matmul(product.as_mut(), Accum::Replace, w, p, 1.0, Par::Seq);
            product
        };
        let (known, new) = (product(&self.products), product(&products));
        self.products.values.reserve_exact(products.values.len());
        let mut taken: Vec<usize> = Vec::with_capacity(products.len());
        for (j, product) in products.iter().enumerate() {
            let old = known.col(j).iter().copied();
            let gram = old.chain(taken.iter().map(|&i| new[(i, j)])).collect();
            if let Some(row) = self.factor_row(gram) {
                self.factor.push(row);
                self.products.push(product.iter().copied());
                taken.push(j);
            }
        }
    }

    /// The row of the factor for a direction with this PᵀAp and pᵀAp = 1; `None` when too little of it is new.
    fn factor_row(&self, gram: Vec<f64>) -> Option<Vec<f64>> {
        let mut row = gram;
        for (j, above) in self.factor.iter().enumerate() {
            row[j] = (row[j] - dot(&above[..j], &row[..j])) / above[j];
        }
        let new = 1.0 - dot(&row, &row);
        (new > LEAST_NEW).then(|| {
            row.push(new.sqrt());
            row
        })
    }
}
