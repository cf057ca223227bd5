//! Products with A are dear: those that were paid for are kept and make the
//! preconditioner of the next inner systems.
//!
//! Every Lanczos and CG direction p comes with its product Ap. Made
//! A-orthonormal, PᵀAP = I, the products W = AP give WWᵀ = AP(PᵀAP)⁻¹PᵀA, the
//! part of A that has been seen: exact on the span of P, and nowhere above A.
//! With D ≈ diag(A) for the rest, the reduced system (ZᵀAZ + C) s = … is
//! preconditioned by
//!
//! ```text
//! M = ZᵀDZ + C + ZᵀWWᵀZ,
//! ```
//!
//! whatever its active set Z: what was learnt under one set serves the next.

use crate::reduced::ReducedSpace;
use faer::linalg::matmul::matmul;
use faer::linalg::solvers::{Llt, Solve};
use faer::{Accum, Col, ColMut, ColRef, Mat, Par, Side};
use tresca_la::LinearOperator;
use tresca_la::vector::{axpy, dot};

/// A direction of which less than this part (in the squared A-norm) is new is not kept.
const LEAST_NEW: f64 = 1e-6;

/// A-orthonormal directions P and their products W = AP.
#[derive(Clone, Debug)]
pub(super) struct RecycledProducts {
    capacity: usize,
    directions: Vec<Vec<f64>>,
    products: Vec<Vec<f64>>,
}

impl RecycledProducts {
    /// Keeps at most `capacity` directions, the first ones offered.
    pub fn new(capacity: usize) -> Self {
        Self { capacity, directions: Vec::new(), products: Vec::new() }
    }

    /// Number of directions kept.
    pub fn len(&self) -> usize {
        self.directions.len()
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

/// M⁻¹ by the Woodbury formula.
pub(super) struct RecycledPreconditioner {
    inverse_diagonal: Vec<f64>,
    low_rank: Option<LowRank>,
}

/// V = ZᵀW, D⁻¹V, and the factor of I + VᵀD⁻¹V.
struct LowRank {
    v: Mat<f64>,
    scaled: Mat<f64>,
    capacitance: Llt<f64>,
    share: Col<f64>,
}

impl RecycledPreconditioner {
    /// M for the space of Z and C, `diagonal` being D.
    pub fn new(space: &ReducedSpace, diagonal: &[f64], recycled: &RecycledProducts) -> Self {
        let inverse_diagonal: Vec<f64> = space.diagonal(diagonal).iter().map(|d| d.recip()).collect();
        let low_rank = LowRank::new(space, &inverse_diagonal, recycled);
        Self { inverse_diagonal, low_rank }
    }
}

impl LowRank {
    /// `None` when nothing is kept yet (or the small matrix is not finite: D alone then serves).
    fn new(space: &ReducedSpace, inverse: &[f64], recycled: &RecycledProducts) -> Option<Self> {
        let (rows, rank) = (space.dim(), recycled.len());
        if rank == 0 || rows == 0 {
            return None;
        }
        let mut v = Mat::zeros(rows, rank);
        let mut column = vec![0.0; rows];
        for (j, product) in recycled.products.iter().enumerate() {
            space.restrict(product, &mut column);
            v.col_mut(j).copy_from(ColRef::from_slice(&column));
        }
        let scaled = Mat::from_fn(rows, rank, |i, j| inverse[i] * v[(i, j)]);
        let mut capacitance = Mat::identity(rank, rank);
        matmul(capacitance.as_mut(), Accum::Add, v.transpose(), scaled.as_ref(), 1.0, Par::Seq);
        let capacitance = Llt::new(capacitance.as_ref(), Side::Lower).ok()?;
        Some(Self { v, scaled, capacitance, share: Col::zeros(rank) })
    }

    /// z ← z − D⁻¹V (I + VᵀD⁻¹V)⁻¹ Vᵀ z, for z = D⁻¹ r.
    fn correct(&mut self, z: &mut [f64]) {
        let share = self.share.as_mut();
        matmul(share, Accum::Replace, self.v.transpose(), ColRef::from_slice(z), 1.0, Par::Seq);
        self.capacitance.solve_in_place(self.share.as_mut());
        let z = ColMut::from_slice_mut(z);
        matmul(z, Accum::Add, self.scaled.as_ref(), self.share.as_ref(), -1.0, Par::Seq);
    }
}

impl LinearOperator for RecycledPreconditioner {
    fn dim(&self) -> usize {
        self.inverse_diagonal.len()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        for ((z, r), d) in z.iter_mut().zip(r).zip(&self.inverse_diagonal) {
            *z = d * r;
        }
        if let Some(low_rank) = &mut self.low_rank {
            low_rank.correct(z);
        }
    }
}
