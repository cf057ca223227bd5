//! Vectors are plain slices; these are the few operations on them.

use crate::kernels::{self, Isa};

/// xᵀy, summed in eight interleaved partial sums (deterministic, and it vectorises).
pub fn dot(x: &[f64], y: &[f64]) -> f64 {
    assert_eq!(x.len(), y.len());
    kernels::dot(Isa::best(), x, y)
}

/// Euclidean norm ‖x‖₂, of numbers of any size.
pub fn norm(x: &[f64]) -> f64 {
    let square = dot(x, x);
    if square.is_nan() || (SMALLEST_SQUARE..f64::INFINITY).contains(&square) {
        return square.sqrt();
    }
    // The squares over- or underflow: in units of the largest entry, a power of two, they do not.
    let size = x.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
    if size == 0.0 || size.is_infinite() {
        return size;
    }
    let unit = size.log2().floor().exp2();
    let sum: f64 = x.iter().map(|x| (x / unit).powi(2)).sum();
    unit * sum.sqrt()
}

/// Sums of squares below this have lost digits of theirs.
const SMALLEST_SQUARE: f64 = 1e-280;

/// y ← y + a x.
pub fn axpy(a: f64, x: &[f64], y: &mut [f64]) {
    assert_eq!(x.len(), y.len());
    kernels::axpy(Isa::best(), a, x, y);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn norms_of_numbers_of_any_size() {
        for size in [1e-320, 1e-200, 1e-150, 1.0, 1e200, 1e307] {
            let found = norm(&[3.0 * size, -4.0 * size]);
            assert!(
                (found / (5.0 * size) - 1.0).abs() < 1e-3,
                "{size:e}: {found:e}"
            );
        }
        assert_eq!(norm(&[0.0; 3]), 0.0);
        assert!(norm(&[1.0, f64::NAN]).is_nan());
        assert_eq!(norm(&[1e200, f64::INFINITY]), f64::INFINITY);
    }
}
