//! Matrices for the tests.

use faer::Mat;
use faer::sparse::{SparseColMat, Triplet};
use tresca_la::{LinearOperator, SymmetricMatrix};

/// Pseudo-random numbers in [−1, 1): a linear congruential generator, Knuth's constants.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 2.0_f64.powi(52) - 1.0
    }

    pub fn vector(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.next()).collect()
    }
}

/// A grid of nodes with `components` dofs each, numbered node by node; every
/// node is coupled to its neighbours (diagonal ones too) by random symmetric
/// blocks, and the diagonal makes the matrix strictly dominant, hence SPD.
pub fn grid(nodes: [usize; 3], components: usize, seed: u64) -> SymmetricMatrix {
    let mut random = Random::new(seed);
    let [nx, ny, nz] = nodes;
    let n = nx * ny * nz * components;
    let position = |node: usize| [node % nx, node / nx % ny, node / nx / ny];
    let mut triplets = Vec::new();
    let mut dominance = vec![1.0; n];
    for j in 0..n {
        for i in j + 1..n {
            let (p, q) = (position(i / components), position(j / components));
            if p.iter().zip(&q).all(|(p, q)| p.abs_diff(*q) <= 1) {
                let value = random.next();
                triplets.push(Triplet::new(i, j, value));
                dominance[i] += value.abs();
                dominance[j] += value.abs();
            }
        }
    }
    triplets.extend((0..n).map(|i| Triplet::new(i, i, dominance[i])));
    from_triplets(n, &triplets)
}

pub fn from_triplets(n: usize, lower: &[Triplet<usize, usize, f64>]) -> SymmetricMatrix {
    SymmetricMatrix::from_lower(SparseColMat::try_new_from_triplets(n, n, lower).unwrap())
}

pub fn dense(matrix: &SymmetricMatrix) -> Mat<f64> {
    let n = matrix.order();
    let mut result = Mat::zeros(n, n);
    let lower = matrix.lower();
    for j in 0..n {
        for (i, &value) in lower.row_idx_of_col(j).zip(lower.val_of_col(j)) {
            result[(i, j)] = value;
            result[(j, i)] = value;
        }
    }
    result
}

/// A dense matrix as an operator that counts its products.
pub struct DenseOperator {
    pub matrix: Mat<f64>,
    pub products: usize,
}

impl DenseOperator {
    pub fn new(matrix: Mat<f64>) -> Self {
        Self {
            matrix,
            products: 0,
        }
    }

    pub fn diagonal(values: &[f64]) -> Self {
        let n = values.len();
        Self::new(Mat::from_fn(
            n,
            n,
            |i, j| if i == j { values[i] } else { 0.0 },
        ))
    }
}

impl LinearOperator for DenseOperator {
    fn dim(&self) -> usize {
        self.matrix.nrows()
    }

    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        self.products += 1;
        for (i, y) in y.iter_mut().enumerate() {
            *y = (0..x.len()).map(|j| self.matrix[(i, j)] * x[j]).sum();
        }
    }
}

/// An orthogonal matrix: a product of Householder reflections.
pub fn orthogonal(n: usize, seed: u64) -> Mat<f64> {
    let mut random = Random::new(seed);
    let mut q = Mat::from_fn(n, n, |i, j| if i == j { 1.0 } else { 0.0 });
    for _ in 0..n.min(5) {
        let v = random.vector(n);
        let length2: f64 = v.iter().map(|v| v * v).sum();
        for j in 0..n {
            let projection: f64 = (0..n).map(|i| v[i] * q[(i, j)]).sum();
            for i in 0..n {
                q[(i, j)] -= 2.0 * projection / length2 * v[i];
            }
        }
    }
    q
}

/// Q diag(values) Qᵀ with a random orthogonal Q.
pub fn with_spectrum(values: &[f64], seed: u64) -> Mat<f64> {
    let q = orthogonal(values.len(), seed);
    let d = DenseOperator::diagonal(values).matrix;
    &q * d * q.transpose()
}

#[track_caller]
pub fn assert_close(actual: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(actual.len(), expected.len());
    let scale = expected.iter().fold(1.0_f64, |s, e| s.max(e.abs()));
    for (i, (a, e)) in actual.iter().zip(expected).enumerate() {
        assert!(
            (a - e).abs() <= tolerance * scale,
            "entry {i}: {a} instead of {e}"
        );
    }
}
