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
    /// Directions, A-norm 1, with their products, that are not in W yet.
    offered: Vec<(Vec<f64>, Vec<f64>)>,
}

impl RecycledProducts {
    /// Keeps at most `capacity` products, the first ones offered.
    pub fn new(capacity: usize) -> Self {
        Self {
            capacity,
            products: Vec::new(),
            factor: Vec::new(),
            offered: Vec::new(),
        }
    }

    /// Keeps at most `capacity` products from now on; those above it go.
    pub fn set_capacity(&mut self, capacity: usize) {
        self.capacity = capacity;
        // The factor of a leading block is the leading block of the factor.
        self.products.truncate(capacity);
        self.factor.truncate(capacity);
        let room = capacity - self.len();
        self.offered.truncate(room);
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

    /// Offers the product of `direction` with A, to be kept if there is room and enough of the direction is new.
    pub fn offer(&mut self, direction: &[f64], product: &[f64]) {
        if self.len() + self.offered.len() >= self.capacity {
            return;
        }
        let square = dot(direction, product);
        if !(square > 0.0 && square.is_finite()) {
            return;
        }
        let scale = square.sqrt().recip();
        let scaled = |v: &[f64]| v.iter().map(|v| scale * v).collect();
        self.offered.push((scaled(direction), scaled(product)));
    }

    /// Takes into W what has been offered since the last time.
    pub fn settle(&mut self) {
        let offered = std::mem::take(&mut self.offered);
        // PᵀAp of every offered p with the P before the offer, each product of W read once.
        let mut known = vec![Vec::with_capacity(self.capacity); offered.len()];
        for product in &self.products {
            for (known, (direction, _)) in known.iter_mut().zip(&offered) {
                known.push(dot(product, direction));
            }
        }
        for (mut gram, (direction, product)) in known.into_iter().zip(offered) {
            let newer = &self.products[gram.len()..];
            gram.extend(newer.iter().map(|product| dot(product, &direction)));
            if let Some(row) = self.factor_row(gram) {
                self.factor.push(row);
                self.products.push(product);
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
