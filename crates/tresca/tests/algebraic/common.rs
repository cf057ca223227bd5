//! Comparison, random matrices.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use tresca::algebraic::Matrix;

pub fn rng(seed: u64) -> StdRng {
    StdRng::seed_from_u64(seed)
}

/// Uniform in (−1, 1).
pub fn uniform(rng: &mut StdRng) -> f64 {
    2.0 * rng.random::<f64>() - 1.0
}

pub fn uniforms(rng: &mut StdRng, count: usize) -> Vec<f64> {
    (0..count).map(|_| uniform(rng)).collect()
}

pub fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a: f64, x| a.max(x.abs()))
}

/// Every entry, relative to the largest.
#[track_caller]
pub fn assert_close(found: &[f64], expected: &[f64], relative: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let difference: Vec<f64> = found.iter().zip(expected).map(|(a, b)| a - b).collect();
    let scale = largest(expected).max(f64::MIN_POSITIVE);
    let error = largest(&difference) / scale;
    assert!(
        error <= relative,
        "{what}: off by {error:.1e} of the largest, {scale:.3e}"
    );
}

/// A dense matrix.
pub fn dense(rows: &[Vec<f64>]) -> Matrix {
    let columns = rows.first().map_or(0, Vec::len);
    Matrix::from_dense((rows.len(), columns), &rows.concat()).unwrap()
}
