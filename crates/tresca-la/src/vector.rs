//! Vectors are plain slices; these are the few operations on them.

use crate::kernels::{self, Isa};

/// xᵀy, summed in eight interleaved partial sums (deterministic, and it vectorises).
pub fn dot(x: &[f64], y: &[f64]) -> f64 {
    assert_eq!(x.len(), y.len());
    kernels::dot(Isa::best(), x, y)
}

/// Euclidean norm ‖x‖₂.
pub fn norm(x: &[f64]) -> f64 {
    dot(x, x).sqrt()
}

/// y ← y + a x.
pub fn axpy(a: f64, x: &[f64], y: &mut [f64]) {
    assert_eq!(x.len(), y.len());
    kernels::axpy(Isa::best(), a, x, y);
}
