//! The largest eigenvalue of a symmetric operator by a few Lanczos steps.
//!
//! C. Lanczos (1950), with full reorthogonalisation: the steps are few, so its
//! cost does not count, and the basis stays orthonormal. The upper bound
//! θ + ‖residual‖ is the one of Y. Zhou and R.-C. Li, *Bounding the spectrum of
//! large Hermitian matrices*, Linear Algebra Appl. 435 (2011).

use crate::operator::LinearOperator;
use crate::vector::{axpy, dot, norm};
use faer::{Mat, Side};

/// Estimate of the largest eigenvalue, with everything that was paid for.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Estimate {
    /// Largest Ritz value θ: never above the largest eigenvalue (but for rounding).
    pub value: f64,
    /// ‖A y − θ y‖₂ for the normed Ritz vector y: an eigenvalue lies within this
    /// distance of θ.
    pub residual: f64,
    /// Normed Ritz vector y of the value.
    pub vector: Vec<f64>,
    /// Orthonormal basis v₁, v₂, … of the Krylov space, as many as products.
    pub basis: Vec<Vec<f64>>,
    /// The products A v₁, A v₂, …
    pub products: Vec<Vec<f64>>,
}

impl Estimate {
    /// θ + residual. Above the largest eigenvalue unless the start vector was
    /// all but orthogonal to its eigenvector, which the pseudo-random start
    /// makes improbable; no a-posteriori bound from few products can be certain.
    pub fn upper_bound(&self) -> f64 {
        self.value + self.residual
    }
}

/// Estimates the largest eigenvalue of a symmetric operator with at most
/// `max_products` products; stops when the residual is at most
/// `relative_tolerance` · |θ|, or the Krylov space is exhausted.
///
/// `start` need not be normed; without one (or with a zero one) a fixed
/// pseudo-random vector is taken, so that repeated runs agree.
///
/// # Panics
/// When the operator has dimension 0, or `max_products` is 0.
pub fn largest_eigenvalue<A: LinearOperator + ?Sized>(
    operator: &mut A,
    start: Option<&[f64]>,
    max_products: usize,
    relative_tolerance: f64,
) -> Estimate {
    let dim = operator.dim();
    assert!(dim > 0 && max_products > 0, "nothing to estimate");
    let mut next = match start {
        Some(v) if norm(v) > 0.0 => v.to_vec(),
        _ => pseudo_random(dim),
    };
    scale(1.0 / norm(&next), &mut next);

    let (mut basis, mut products) = (Vec::new(), Vec::new());
    let (mut diagonal, mut offdiagonal) = (Vec::new(), Vec::new());
    loop {
        let mut product = vec![0.0; dim];
        operator.apply(&next, &mut product);
        diagonal.push(dot(&next, &product));
        basis.push(next);
        products.push(product);

        // Twice is enough (Kahan and Parlett).
        let mut rest = products[products.len() - 1].clone();
        for _ in 0..2 {
            for v in &basis {
                axpy(-dot(v, &rest), v, &mut rest);
            }
        }
        let beta = norm(&rest);
        let (value, coefficients) = largest_ritz_pair(&diagonal, &offdiagonal);
        let residual = beta * coefficients[coefficients.len() - 1].abs();
        let steps = basis.len();
        let exhausted = steps == dim || beta <= f64::EPSILON * value.abs();
        if exhausted || steps == max_products || residual <= relative_tolerance * value.abs() {
            let mut vector = vec![0.0; dim];
            for (c, v) in coefficients.iter().zip(&basis) {
                axpy(*c, v, &mut vector);
            }
            return Estimate {
                value,
                residual,
                vector,
                basis,
                products,
            };
        }
        offdiagonal.push(beta);
        scale(1.0 / beta, &mut rest);
        next = rest;
    }
}

/// Largest eigenvalue and its normed eigenvector of the tridiagonal Ritz matrix.
fn largest_ritz_pair(diagonal: &[f64], offdiagonal: &[f64]) -> (f64, Vec<f64>) {
    let k = diagonal.len();
    let ritz = Mat::from_fn(k, k, |i, j| match i.abs_diff(j) {
        0 => diagonal[i],
        1 => offdiagonal[i.min(j)],
        _ => 0.0,
    });
    match ritz.self_adjoint_eigen(Side::Lower) {
        // Eigenvalues come in ascending order.
        Ok(eigen) => (
            eigen.S()[k - 1],
            (0..k).map(|i| eigen.U()[(i, k - 1)]).collect(),
        ),
        // Only for entries that are not numbers; hand that on visibly.
        Err(_) => (f64::NAN, vec![f64::NAN; k]),
    }
}

fn scale(a: f64, x: &mut [f64]) {
    for x in x {
        *x *= a;
    }
}

/// Fixed pseudo-random vector, entries in [−1, 1) (SplitMix64, seed 0).
fn pseudo_random(dim: usize) -> Vec<f64> {
    let mut state = 0_u64;
    let next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        // The top 53 bits, as a multiple of 2⁻⁵² in [0, 2), shifted.
        (z >> 11) as f64 * 2.0_f64.powi(-52) - 1.0
    };
    std::iter::repeat_with(next).take(dim).collect()
}
