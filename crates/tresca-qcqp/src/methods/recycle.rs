//! Products with A are dear: those that were paid for are kept.
//!
//! Every Lanczos and CG direction p comes with its product Ap. Made
//! A-orthonormal, PᵀAP = I, the products W = AP give WWᵀ = AP(PᵀAP)⁻¹PᵀA, the
//! part of A that has been seen: exact on the span of P, and nowhere above A.
//! It belongs to A alone, so that what was learnt under one active set (or one
//! right-hand side) serves the next.

use tresca_la::vector::{axpy, dot};

/// A direction of which less than this part (in the squared A-norm) is new is not kept.
const LEAST_NEW: f64 = 1e-6;

/// A-orthonormal directions P and their products W = AP.
#[derive(Clone, Debug)]
pub(crate) struct RecycledProducts {
    capacity: usize,
    directions: Vec<Vec<f64>>,
    products: Vec<Vec<f64>>,
}

impl RecycledProducts {
    /// Keeps at most `capacity` directions, the first ones offered.
    pub fn new(capacity: usize) -> Self {
        Self {
            capacity,
            directions: Vec::new(),
            products: Vec::new(),
        }
    }

    /// Keeps at most `capacity` directions from now on; those above it go.
    pub fn set_capacity(&mut self, capacity: usize) {
        self.capacity = capacity;
        // A leading part of an A-orthonormal set is one.
        self.directions.truncate(capacity);
        self.products.truncate(capacity);
    }

    /// Number of directions kept.
    pub fn len(&self) -> usize {
        self.directions.len()
    }

    /// The directions P, one by one.
    #[cfg(test)]
    pub fn directions(&self) -> impl Iterator<Item = &[f64]> {
        self.directions.iter().map(Vec::as_slice)
    }

    /// The products W, one by one.
    pub fn products(&self) -> impl Iterator<Item = &[f64]> {
        self.products.iter().map(Vec::as_slice)
    }

    /// Keeps what is new in `direction`, whose product with A is `product`.
    pub fn offer(&mut self, direction: &[f64], product: &[f64]) {
        if self.len() >= self.capacity {
            return;
        }
        let (mut p, mut w) = (direction.to_vec(), product.to_vec());
        if !normalise(&mut p, &mut w, 0.0) {
            return;
        }
        // Gram–Schmidt in the A inner product; twice is enough.
        for _ in 0..2 {
            let shares: Vec<f64> = self.products.iter().map(|known| dot(known, &p)).collect();
            for (k, share) in shares.iter().enumerate() {
                axpy(-share, &self.directions[k], &mut p);
                axpy(-share, &self.products[k], &mut w);
            }
            if !normalise(&mut p, &mut w, LEAST_NEW) {
                return;
            }
        }
        self.directions.push(p);
        self.products.push(w);
    }
}

/// Scales p and w = Ap so that pᵀw = 1; `false` when pᵀw is not above `least`.
fn normalise(p: &mut [f64], w: &mut [f64], least: f64) -> bool {
    let square = dot(p, w);
    if !(square > least && square.is_finite()) {
        return false;
    }
    let scale = square.sqrt().recip();
    p.iter_mut().for_each(|p| *p *= scale);
    w.iter_mut().for_each(|w| *w *= scale);
    true
}
