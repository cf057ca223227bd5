//! Products with A are dear: those that were paid for are kept.
//!
//! Every Lanczos and CG direction p comes with its product w = Ap. The products W = AP and the
//! Gram matrix PᵀAP = PᵀW give W (PᵀAP)⁻¹ Wᵀ, the part of A that has been seen: exact on the span
//! of P, and nowhere above A. It belongs to A alone, so that what was learnt under one active set
//! (or one right-hand side) serves the next.
//!
//! The directions are not made orthogonal and not even kept: one sweep over W gives the new row of
//! the Gram matrix, where Gram and Schmidt would need six over W and P to keep WWᵀ accurate.

use faer::Mat;
use tresca_la::vector::dot;

/// A direction of which less than this part (in the squared A-norm) is new is not kept.
const LEAST_NEW: f64 = 1e-6;

/// Products W = AP, each direction of P with the A-norm 1, and the factor of PᵀAP.
#[derive(Clone, Debug)]
pub(crate) struct RecycledProducts {
    capacity: usize,
    products: Vec<Vec<f64>>,
    /// The Cholesky factor of PᵀAP row by row, row i up to the diagonal.
    factor: Vec<Vec<f64>>,
}

impl RecycledProducts {
    /// Keeps at most `capacity` products, the first ones offered.
    pub fn new(capacity: usize) -> Self {
        Self {
            capacity,
            products: Vec::new(),
            factor: Vec::new(),
        }
    }

    /// Keeps at most `capacity` products from now on; those above it go.
    pub fn set_capacity(&mut self, capacity: usize) {
        self.capacity = capacity;
        // The factor of a leading block is the leading block of the factor.
        self.products.truncate(capacity);
        self.factor.truncate(capacity);
    }

    /// Number of products kept.
    pub fn len(&self) -> usize {
        self.products.len()
    }

    /// The products W, one by one.
    pub fn products(&self) -> impl Iterator<Item = &[f64]> {
        self.products.iter().map(Vec::as_slice)
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

    /// Keeps the product of `direction` with A if enough of the direction is new.
    pub fn offer(&mut self, direction: &[f64], product: &[f64]) {
        if self.len() >= self.capacity {
            return;
        }
        let square = dot(direction, product);
        if !(square > 0.0 && square.is_finite()) {
            return;
        }
        let scale = square.sqrt().recip();
        // The new row of the factor: L l = PᵀAp, and what is left of pᵀAp = 1 on the diagonal.
        let mut row: Vec<f64> = Vec::with_capacity(self.len() + 1);
        for (known, above) in self.products.iter().zip(&self.factor) {
            let j = row.len();
            let rest = scale * dot(known, direction) - dot(&above[..j], &row);
            row.push(rest / above[j]);
        }
        let new = 1.0 - dot(&row, &row);
        if !(new > LEAST_NEW) {
            return;
        }
        row.push(new.sqrt());
        self.factor.push(row);
        self.products
            .push(product.iter().map(|w| scale * w).collect());
    }
}
