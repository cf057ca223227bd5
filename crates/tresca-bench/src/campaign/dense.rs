//! Small dense matrices, row by row, for problems and oracles: nothing of it is shared with the solver.

/// A matrix as its rows.
pub type Rows = Vec<Vec<f64>>;

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// The largest magnitude; NaN where one is.
pub fn largest(values: &[f64]) -> f64 {
    let more = |most: f64, x: &f64| {
        if x.abs() > most || x.is_nan() {
            x.abs()
        } else {
            most
        }
    };
    values.iter().fold(0.0, more)
}

/// M x.
pub fn product(matrix: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| dot(row, x)).collect()
}

/// y + s x.
pub fn add(y: &mut [f64], s: f64, x: &[f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += s * x);
}

/// Mᵀ x, with as many columns as said.
pub fn transposed_product(matrix: &[Vec<f64>], x: &[f64], columns: usize) -> Vec<f64> {
    let mut y = vec![0.0; columns];
    for (row, x) in matrix.iter().zip(x) {
        add(&mut y, *x, row);
    }
    y
}

/// Square blocks on one diagonal.
pub fn block_diagonal(blocks: &[Rows]) -> Rows {
    let order = blocks.iter().map(Vec::len).sum();
    let mut whole = Vec::new();
    for block in blocks {
        let first = whole.len();
        for row in block {
            let mut long = vec![0.0; order];
            long[first..first + row.len()].copy_from_slice(row);
            whole.push(long);
        }
    }
    whole
}

/// Eigenvalues, ascending, and the eigenvectors that belong to them.
pub fn eigen(matrix: &[Vec<f64>]) -> Option<(Vec<f64>, Rows)> {
    let n = matrix.len();
    let whole = faer::Mat::from_fn(n, n, |i, j| matrix[i][j]);
    let eigen = whole.self_adjoint_eigen(faer::Side::Lower).ok()?;
    let values = (0..n).map(|i| eigen.S()[i]).collect();
    let vectors = (0..n).map(|j| (0..n).map(|i| eigen.U()[(i, j)]).collect());
    Some((values, vectors.collect()))
}

/// Eigenvalues below this part of the largest are those of the kernel.
const KERNEL: f64 = 1e-10;

/// An orthonormal basis of the kernel of a positive semidefinite matrix.
pub fn kernel(matrix: &[Vec<f64>]) -> Option<Rows> {
    let (values, vectors) = eigen(matrix)?;
    let most = largest(&values);
    let pairs = values.iter().zip(vectors);
    Some(
        pairs
            .filter(|(value, _)| **value <= KERNEL * most)
            .map(|(_, vector)| vector)
            .collect(),
    )
}

/// L of a positive definite matrix LLᵀ.
pub struct Cholesky(Rows);

impl Cholesky {
    /// `None` unless all pivots are positive.
    pub fn new(matrix: &[Vec<f64>]) -> Option<Self> {
        let mut l: Rows = Vec::new();
        for (i, row) in matrix.iter().enumerate() {
            let mut own = vec![0.0; i + 1];
            for j in 0..i {
                own[j] = (row[j] - dot(&own[..j], &l[j][..j])) / l[j][j];
            }
            let pivot = row[i] - dot(&own[..i], &own[..i]);
            if pivot.is_nan() || pivot <= 0.0 {
                return None;
            }
            own[i] = pivot.sqrt();
            l.push(own);
        }
        Some(Self(l))
    }

    /// L⁻¹ x.
    pub fn forward(&self, x: &[f64]) -> Vec<f64> {
        let mut y: Vec<f64> = Vec::new();
        for (row, x) in self.0.iter().zip(x) {
            let i = y.len();
            y.push((x - dot(&row[..i], &y)) / row[i]);
        }
        y
    }

    /// (LLᵀ)⁻¹ x.
    pub fn solve(&self, x: &[f64]) -> Vec<f64> {
        let mut y = self.forward(x);
        for i in (0..y.len()).rev() {
            for k in i + 1..y.len() {
                y[i] -= self.0[k][i] * y[k];
            }
            y[i] /= self.0[i][i];
        }
        y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_small_system_is_solved() {
        let k = vec![vec![4.0, 2.0], vec![2.0, 3.0]];
        let x = Cholesky::new(&k).unwrap().solve(&[8.0, 8.0]);
        assert!((x[0] - 1.0).abs() < 1e-14 && (x[1] - 2.0).abs() < 1e-14);
        let floating = vec![vec![1.0, -1.0], vec![-1.0, 1.0]];
        assert!(Cholesky::new(&floating).is_none());
        let kernel = kernel(&floating).unwrap();
        assert_eq!(kernel.len(), 1);
        assert!((kernel[0][0] - kernel[0][1]).abs() < 1e-14);
    }
}
