//! Matrices of order three, for use inside element loops.

use crate::vector3::{cross, dot};

/// det of the matrix with the columns `c`.
pub(crate) fn determinant(c: &[[f64; 3]; 3]) -> f64 {
    dot(c[0], cross(c[1], c[2]))
}

/// Rows of the inverse of the matrix with the columns `c`, given its determinant.
pub(crate) fn inverse_rows(c: &[[f64; 3]; 3], determinant: f64) -> [[f64; 3]; 3] {
    let scaled = |v: [f64; 3]| v.map(|x| x / determinant);
    [
        scaled(cross(c[1], c[2])),
        scaled(cross(c[2], c[0])),
        scaled(cross(c[0], c[1])),
    ]
}

/// Eigenvalues and eigenvectors (`vectors[k]` belongs to `values[k]`, unit length) of a symmetric
/// matrix of small order, by cyclic Jacobi rotations: accurate to rounding also when eigenvalues
/// coincide or vanish. (Golub, Van Loan: Matrix Computations, section 8.5.)
pub(crate) fn symmetric_eigen<const N: usize>(mut a: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut vectors = [[0.0; N]; N];
    for (k, vector) in vectors.iter_mut().enumerate() {
        vector[k] = 1.0;
    }
    // Quadratic convergence: fewer than ten sweeps in practice.
    for _ in 0..50 {
        let mut rotated = false;
        for p in 0..N {
            for q in p + 1..N {
                let off = a[p][q];
                if off.abs() <= 1e-17 * (a[p][p].abs() + a[q][q].abs()) {
                    continue;
                }
                rotated = true;
                let theta = (a[q][q] - a[p][p]) / (2.0 * off);
                let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                let s = t * c;
                for k in 0..N {
                    (a[k][p], a[k][q]) = (c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]);
                }
                for k in 0..N {
                    (a[p][k], a[q][k]) = (c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]);
                    let (vp, vq) = (vectors[p][k], vectors[q][k]);
                    (vectors[p][k], vectors[q][k]) = (c * vp - s * vq, s * vp + c * vq);
                }
                a[p][q] = 0.0;
                a[q][p] = 0.0;
            }
        }
        if !rotated {
            break;
        }
    }
    (std::array::from_fn(|k| a[k][k]), vectors)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector3::norm;

    #[test]
    fn eigenpairs_of_small_matrices() {
        let a = [[4.0, 1.0, -2.0], [1.0, 2.0, 0.0], [-2.0, 0.0, 3.0]];
        let rank_one = [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [3.0, 6.0, 9.0]];
        for a in [
            a,
            rank_one,
            [[0.0; 3]; 3],
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        ] {
            let (values, vectors) = symmetric_eigen(a);
            for k in 0..3 {
                assert!((norm(vectors[k]) - 1.0).abs() < 1e-14);
                let av: [f64; 3] = a.map(|row| dot(row, vectors[k]));
                for i in 0..3 {
                    assert!(
                        (av[i] - values[k] * vectors[k][i]).abs() < 1e-14 * 15.0,
                        "{a:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_inverse_inverts() {
        let c = [[2.0, 0.5, 0.0], [0.1, 3.0, -1.0], [0.0, 0.3, 1.0]];
        let rows = inverse_rows(&c, determinant(&c));
        for (i, row) in rows.iter().enumerate() {
            for (j, column) in c.iter().enumerate() {
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((dot(*row, *column) - expected).abs() < 1e-15);
            }
        }
    }
}
