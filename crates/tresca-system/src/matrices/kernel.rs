//! The null space of a connected part of K: found, or checked.
//!
//! Everything is measured after scaling K̂ = D^(−½) K D^(−½) with D = diag(K): displacements and rotations,
//! soft and stiff bodies then compare, and an eigenvalue is small when it is small beside 1.

use faer::Mat;
use faer::Side;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use tresca_la::vector::{axpy, dot, norm};
use tresca_la::{BodySolver, Ordering, Parallelism, SparseCholesky, SymmetricMatrix};

/// Eigenvalues of K̂ below this are zero. Rounding leaves some 1e-16 of a zero; no matrix that is to be
/// solved with has true eigenvalues as small.
const ZERO: f64 = 1e-13;

/// A Cholesky factor of K̂ without a pivot below this belongs to a regular matrix; else its eigenvalues decide.
const SAFE_PIVOT: f64 = 1e-9;

/// K̂ + SHIFT·I is factored to find the kernel: far above rounding, far below the elastic eigenvalues of most
/// bodies (others take more iterations).
const SHIFT: f64 = 1e-9;

/// Vectors iterated on at once: the six rigid motions of a body, and two more to see where they end.
const VECTORS: usize = 8;

/// Most kernel vectors that are looked for in one part.
pub(super) const MOST: usize = 32;

const MOST_ITERATIONS: usize = 60;

/// Residual of a given kernel vector up to which it is one.
const ALLOWED_RESIDUAL: f64 = 1e-8;

/// Why there is no kernel to be had.
pub(super) enum KernelFailure {
    /// The matrix has a negative eigenvalue; this dof (of the part) shows it.
    Indefinite(usize),
    /// More than [`MOST`] vectors.
    TooLarge,
}

/// √diag(K), 1 where that is zero.
pub(super) fn scales(k: &SymmetricMatrix) -> Vec<f64> {
    let root = |d: f64| if d > 0.0 { d.sqrt() } else { 1.0 };
    k.diagonal().into_iter().map(root).collect()
}

/// The kernel of a small matrix by its eigenvalues; scaled vectors R̂ = D^½ R, orthonormal.
pub(super) fn of_small(k: &SymmetricMatrix) -> Result<Vec<Vec<f64>>, KernelFailure> {
    let scales = scales(k);
    let n = k.order();
    let mut dense: Mat<f64> = Mat::zeros(n, n);
    for j in 0..n {
        for (i, value) in k.lower().row_idx_of_col(j).zip(k.lower().val_of_col(j)) {
            let scaled = value / (scales[i] * scales[j]);
            dense[(i, j)] = scaled;
            dense[(j, i)] = scaled;
        }
    }
    if let Ok(factor) = dense.llt(Side::Lower) {
        let pivots = (0..n).map(|i| factor.L()[(i, i)].powi(2));
        if pivots.fold(f64::INFINITY, f64::min) > SAFE_PIVOT {
            return Ok(Vec::new());
        }
    }
    let Ok(eigen) = dense.self_adjoint_eigen(Side::Lower) else {
        return Err(KernelFailure::Indefinite(0));
    };
    let mut kernel = Vec::new();
    for (value, vector) in eigen.S().column_vector().iter().zip(eigen.U().col_iter()) {
        let vector: Vec<f64> = vector.iter().copied().collect();
        if *value < -ZERO.sqrt() {
            let largest = |a: usize, b: usize| {
                if vector[b].abs() > vector[a].abs() {
                    b
                } else {
                    a
                }
            };
            return Err(KernelFailure::Indefinite((0..n).fold(0, largest)));
        }
        if *value < ZERO {
            kernel.push(vector);
        }
    }
    Ok(kernel)
}

/// Whether a factored matrix is singular up to rounding, by a few steps of inverse iteration.
pub(super) fn is_singular(k: &SymmetricMatrix, solver: &dyn BodySolver) -> bool {
    let scales = scales(k);
    let mut x = start(k.order(), 0);
    for _ in 0..3 {
        x.iter_mut().zip(&scales).for_each(|(x, s)| *x *= s);
        solver.solve_in_place(&mut x);
        x.iter_mut().zip(&scales).for_each(|(x, s)| *x *= s);
        let length = norm(&x);
        if !(length.is_finite() && length > 0.0) {
            return true;
        }
        x.iter_mut().for_each(|x| *x /= length);
    }
    let eigenvalue = dot(&x, &product(k, &scales, &x));
    eigenvalue.is_nan() || eigenvalue <= ZERO
}

/// The kernel of a large matrix by subspace iteration with (K̂ + εI)⁻¹; scaled vectors, orthonormal.
pub(super) fn of_large(
    k: &SymmetricMatrix,
    parallelism: Parallelism,
) -> Result<Vec<Vec<f64>>, KernelFailure> {
    let scales = scales(k);
    let shifted = shifted(k, &scales);
    let factor = Ordering::nested_dissection(&shifted)
        .map_err(|_| KernelFailure::Indefinite(0))
        .and_then(|ordering| {
            SparseCholesky::factor(&shifted, ordering, parallelism).map_err(|error| match error {
                tresca_la::FactorError::NotPositiveDefinite { dof } => {
                    KernelFailure::Indefinite(dof)
                }
                _ => KernelFailure::Indefinite(0),
            })
        })?;
    let mut count = VECTORS.min(k.order());
    loop {
        let kernel = iterate(k, &scales, &factor, count);
        if kernel.len() < count || count == k.order() {
            return Ok(kernel);
        }
        if count >= MOST {
            return Err(KernelFailure::TooLarge);
        }
        count = (2 * count).min(k.order());
    }
}

fn iterate(
    k: &SymmetricMatrix,
    scales: &[f64],
    solver: &dyn BodySolver,
    count: usize,
) -> Vec<Vec<f64>> {
    let mut vectors: Vec<_> = (0..count).map(|seed| start(k.order(), seed)).collect();
    // Number of zeros and the size of K̂ on their vectors, as they were.
    let mut before = (usize::MAX, f64::INFINITY);
    let mut zeros = 0;
    for _ in 0..MOST_ITERATIONS {
        for v in &mut vectors {
            v.iter_mut().zip(scales).for_each(|(v, s)| *v *= s);
            solver.solve_in_place(v);
            v.iter_mut().zip(scales).for_each(|(v, s)| *v *= s);
        }
        orthonormalise(&mut vectors, 0.0);
        let (values, rotated) = ritz(k, scales, &vectors);
        vectors = rotated;
        zeros = values.iter().filter(|value| **value < ZERO).count();
        let size = vectors[..zeros]
            .iter()
            .map(|v| norm(&product(k, scales, v)))
            .fold(0.0, f64::max);
        if zeros == before.0 && size > 0.5 * before.1 {
            break;
        }
        before = (zeros, size);
    }
    vectors.truncate(zeros);
    vectors
}

/// Ritz values of K̂, ascending, and vectors.
fn ritz(k: &SymmetricMatrix, scales: &[f64], vectors: &[Vec<f64>]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let products: Vec<_> = vectors.iter().map(|v| product(k, scales, v)).collect();
    let count = vectors.len();
    let entry = |i: usize, j: usize| {
        0.5 * (dot(&vectors[i], &products[j]) + dot(&vectors[j], &products[i]))
    };
    let projected = Mat::from_fn(count, count, entry);
    let Ok(eigen) = projected.self_adjoint_eigen(Side::Lower) else {
        // Not finite: no eigenvalue is seen to be zero.
        return (vec![f64::INFINITY; count], vectors.to_vec());
    };
    let combine = |column: usize| {
        let mut sum = vec![0.0; vectors[0].len()];
        for (i, v) in vectors.iter().enumerate() {
            axpy(eigen.U()[(i, column)], v, &mut sum);
        }
        sum
    };
    let values = eigen.S().column_vector().iter().copied().collect();
    (values, (0..count).map(combine).collect())
}

/// K̂ x.
fn product(k: &SymmetricMatrix, scales: &[f64], x: &[f64]) -> Vec<f64> {
    let unscaled: Vec<f64> = x.iter().zip(scales).map(|(x, s)| x / s).collect();
    let mut y = vec![0.0; x.len()];
    k.mul(&unscaled, &mut y);
    y.iter_mut().zip(scales).for_each(|(y, s)| *y /= s);
    y
}

/// K + SHIFT·D.
fn shifted(k: &SymmetricMatrix, scales: &[f64]) -> SymmetricMatrix {
    let lower = k.lower();
    let mut values = Vec::with_capacity(lower.compute_nnz());
    for (j, scale) in scales.iter().enumerate() {
        let column = lower.row_idx_of_col(j).zip(lower.val_of_col(j));
        values.extend(column.map(|(i, value)| {
            if i == j {
                value + SHIFT * scale * scale
            } else {
                *value
            }
        }));
    }
    let pattern = SymbolicSparseColMat::new_checked(
        k.order(),
        k.order(),
        lower.col_ptr().to_vec(),
        None,
        lower.row_idx().to_vec(),
    );
    SymmetricMatrix::from_lower(SparseColMat::new(pattern, values))
}

/// Orthonormalises in place, twice for rounding; drops vectors that keep no more than `least` of their length.
fn orthonormalise(vectors: &mut Vec<Vec<f64>>, least: f64) {
    let mut kept: Vec<Vec<f64>> = Vec::with_capacity(vectors.len());
    for mut v in vectors.drain(..) {
        let length = norm(&v);
        if length == 0.0 {
            continue;
        }
        for _ in 0..2 {
            for q in &kept {
                let along = dot(q, &v);
                axpy(-along, q, &mut v);
            }
        }
        let rest = norm(&v);
        if rest > least * length && rest > 0.0 {
            v.iter_mut().for_each(|x| *x /= rest);
            kept.push(v);
        }
    }
    *vectors = kept;
}

/// What is left of given kernel vectors on a part of K: scaled, orthonormal.
///
/// # Errors
/// The number of a vector that is none, with its residual.
pub(super) fn checked(
    k: &SymmetricMatrix,
    given: &[Vec<f64>],
) -> Result<Vec<Vec<f64>>, (usize, f64)> {
    let scales = scales(k);
    let mut absolute = vec![0.0; k.order()];
    let mut kernel = Vec::new();
    for (number, r) in given.iter().enumerate() {
        let largest = crate::measures::largest(r);
        if largest == 0.0 {
            continue;
        }
        let mut product = vec![0.0; r.len()];
        k.mul(r, &mut product);
        // |K||r|, what Kr would be without any cancellation.
        absolute.fill(0.0);
        for j in 0..k.order() {
            for (i, value) in k.lower().row_idx_of_col(j).zip(k.lower().val_of_col(j)) {
                absolute[i] += (value * r[j]).abs();
                if i != j {
                    absolute[j] += (value * r[i]).abs();
                }
            }
        }
        let size = crate::measures::largest(&absolute);
        let residual = crate::measures::largest(&product) / size.max(f64::MIN_POSITIVE);
        if residual > ALLOWED_RESIDUAL {
            return Err((number, residual));
        }
        kernel.push(
            r.iter()
                .zip(&scales)
                .map(|(r, s)| r * s / largest)
                .collect(),
        );
    }
    orthonormalise(&mut kernel, 1e-9);
    Ok(kernel)
}

/// A pseudo-random vector, the same in every run.
fn start(order: usize, seed: usize) -> Vec<f64> {
    // The integers of splitmix64.
    let mut state = 0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(seed as u64 + 1);
    let mut next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    (0..order).map(|_| next()).collect()
}
