//! Dual bases of multipliers on a face (Wohlmuth 2000), biorthogonal over what the master covers
//! (Cichosz, Bischoff 2011; Popp, Wohlmuth, Gitterle, Wall 2012).
//!
//! Three steps lead from the shape functions φ of a face to its multipliers ψ:
//!
//! 1. φ⁺ = P φ, a basis without negative parts: ∫ φ⁺_j > 0 over whatever part of the face. For linear faces
//!    P = I, for quadratic ones φ⁺ are Bernstein's polynomials.
//! 2. φ̃ = S φ⁺, one for each node that keeps a multiplier; the share of a node that has none goes to the
//!    others in equal parts, so that still Σ φ̃ = 1.
//! 3. ψ = C φ, C = D̃ M̃⁻¹ S P with M̃ = ∫ φ̃ φ̃ᵀ and D̃ = diag ∫ φ̃, so that ∫ ψ_j φ̃_k = δ_jk ∫ φ̃_j.
//!
//! All integrals are over the covered part. Since M̃ 1 = D̃ 1, Σ ψ = 1 everywhere on the face: a constant
//! pressure is among the multipliers, whatever is covered and whoever is left out.

// Small matrices are written as in the formulas.
#![allow(clippy::needless_range_loop)]

use tresca_fem::mesh::CellKind;

use super::integrals::Square;
use crate::geometry::face::MAX_NODES;

/// A Cholesky pivot of the scaled M̃ below this says that the covered part is too small to tell the
/// functions on it apart; then one node less has a multiplier there.
const SMALLEST_PIVOT: f64 = 1e-6;

/// The multipliers on a face.
#[derive(Debug, Clone)]
pub(crate) struct DualBasis {
    /// The face's nodes (local numbers) that have a multiplier, ascending.
    pub kept: Vec<usize>,
    /// ψ_j = Σ_k C_jk φ_k, a row for each of `kept`.
    pub coefficients: Vec<[f64; MAX_NODES]>,
}

/// P: the rows of a basis of the face's functions that is nowhere negative.
///
/// On lines, triangles and tensor products these are Bernstein's polynomials, (1−ξ)²/4 and
/// (1−ξ²)/2 on a line: a corner takes a quarter of each adjacent mid-edge function. (Popp et al. 2012
/// take a fifth, enough for whole faces, but not for covered parts.) For the serendipity quad8 the same
/// share makes ∫ φ⁺ > 0 over the whole face.
pub(crate) fn positive_basis(kind: CellKind) -> Square {
    let mut rows = [[0.0; MAX_NODES]; MAX_NODES];
    let count = kind.node_count();
    if kind.order() == 1 {
        for (k, row) in rows.iter_mut().enumerate().take(count) {
            row[k] = 1.0;
        }
        return rows;
    }
    // A mid node passes a quarter to each of the two corners next to it.
    const LINE: &[[usize; 2]] = &[[0, 1]];
    const TRIANGLE: &[[usize; 2]] = &[[0, 1], [1, 2], [2, 0]];
    const SQUARE: &[[usize; 2]] = &[[0, 1], [1, 2], [2, 3], [3, 0]];
    let edges = match count {
        3 => LINE,
        6 => TRIANGLE,
        _ => SQUARE,
    };
    // VTK numbers corners first, then mid nodes of edges, then the centre.
    let corners = count - edges.len() - usize::from(count == 9);
    for (k, row) in rows.iter_mut().enumerate().take(corners) {
        row[k] = 1.0;
    }
    for (i, ends) in edges.iter().enumerate() {
        let mid = corners + i;
        rows[mid][mid] = 0.5;
        for &end in ends {
            rows[end][mid] = 0.25;
        }
    }
    if count == 9 {
        // The product of two lines.
        for corner in 0..4 {
            rows[corner][8] = 1.0 / 16.0;
            rows[4 + corner][8] = 1.0 / 8.0;
        }
        rows[8][8] = 0.25;
    }
    rows
}

/// ∫ φ⁺_j from the mass matrix.
pub(crate) fn positive_measures(kind: CellKind, mass: &Square) -> [f64; MAX_NODES] {
    let count = kind.node_count();
    let rows = positive_basis(kind);
    let measure: [f64; MAX_NODES] = std::array::from_fn(|k| mass[k][..count].iter().sum());
    std::array::from_fn(|j| (0..count).map(|k| rows[j][k] * measure[k]).sum())
}

/// The dual basis on a face with the given ∫ φ φᵀ, for the nodes in `keep` (one at least).
///
/// Where too little is covered for so many, the nodes with the least share are left out as well.
pub(crate) fn dual_basis(kind: CellKind, mass: &Square, keep: &[bool; MAX_NODES]) -> DualBasis {
    let count = kind.node_count();
    let positive = positive_basis(kind);
    let mut kept: Vec<usize> = (0..count).filter(|&k| keep[k]).collect();
    loop {
        let rows = shared(&positive, count, &kept);
        let n = kept.len();
        // φ̃ φᵀ, D̃ and M̃.
        let mut mixed = [[0.0; MAX_NODES]; MAX_NODES];
        let mut measures = [0.0; MAX_NODES];
        let mut gram = [[0.0; MAX_NODES]; MAX_NODES];
        for i in 0..n {
            for l in 0..count {
                mixed[i][l] = (0..count).map(|k| rows[i][k] * mass[k][l]).sum();
            }
            measures[i] = mixed[i][..count].iter().sum();
        }
        for i in 0..n {
            for j in 0..n {
                gram[i][j] = (0..count).map(|l| mixed[i][l] * rows[j][l]).sum();
            }
        }
        let least = (0..n).min_by(|&a, &b| measures[a].total_cmp(&measures[b]));
        match (Cholesky::new(&gram, n), least) {
            (None, Some(least)) if n > 1 => {
                kept.remove(least);
            }
            (Some(factor), _) => {
                let solution = factor.solve(&gram, &rows, count);
                let coefficients = (0..n)
                    .map(|i| solution[i].map(|x| measures[i] * x))
                    .collect();
                return DualBasis { kept, coefficients };
            }
            // A single function 1 on a part without area: nothing is transmitted.
            (None, _) => {
                return DualBasis {
                    kept: Vec::new(),
                    coefficients: Vec::new(),
                };
            }
        }
    }
}

/// S P: the rows of P of the kept nodes, with an equal part of all other rows each.
fn shared(positive: &Square, count: usize, kept: &[usize]) -> Square {
    let mut rest = [0.0; MAX_NODES];
    for j in (0..count).filter(|j| !kept.contains(j)) {
        for k in 0..count {
            rest[k] += positive[j][k] / kept.len() as f64;
        }
    }
    let mut rows = [[0.0; MAX_NODES]; MAX_NODES];
    for (row, &j) in rows.iter_mut().zip(kept) {
        for k in 0..count {
            row[k] = positive[j][k] + rest[k];
        }
    }
    rows
}

/// L of the matrix scaled to a diagonal of ones.
struct Cholesky {
    n: usize,
    scale: [f64; MAX_NODES],
    lower: Square,
}

impl Cholesky {
    /// `None` where a pivot is too small, or the diagonal not positive.
    fn new(matrix: &Square, n: usize) -> Option<Self> {
        let mut scale = [0.0; MAX_NODES];
        for i in 0..n {
            scale[i] = matrix[i][i].sqrt().recip();
            if !(matrix[i][i] > 0.0 && scale[i].is_finite()) {
                return None;
            }
        }
        let mut lower = [[0.0; MAX_NODES]; MAX_NODES];
        for i in 0..n {
            for j in 0..=i {
                let known: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
                let rest = matrix[i][j] * scale[i] * scale[j] - known;
                if i > j {
                    lower[i][j] = rest / lower[j][j];
                } else if rest > SMALLEST_PIVOT {
                    lower[i][i] = rest.sqrt();
                } else {
                    return None;
                }
            }
        }
        Some(Self { n, scale, lower })
    }

    /// The solution of matrix · X = right, with one step of refinement: rows of X add up to what they
    /// should, to rounding, also where M̃ is near to singular.
    fn solve(&self, matrix: &Square, right: &Square, columns: usize) -> Square {
        let mut x = [[0.0; MAX_NODES]; MAX_NODES];
        for _ in 0..2 {
            for c in 0..columns {
                let mut residual = [0.0; MAX_NODES];
                for i in 0..self.n {
                    let product: f64 = (0..self.n).map(|j| matrix[i][j] * x[j][c]).sum();
                    residual[i] = right[i][c] - product;
                }
                let correction = self.column(residual);
                for i in 0..self.n {
                    x[i][c] += correction[i];
                }
            }
        }
        x
    }

    fn column(&self, mut y: [f64; MAX_NODES]) -> [f64; MAX_NODES] {
        for i in 0..self.n {
            let known: f64 = (0..i).map(|k| self.lower[i][k] * y[k]).sum();
            y[i] = (y[i] * self.scale[i] - known) / self.lower[i][i];
        }
        for i in (0..self.n).rev() {
            let known: f64 = (i + 1..self.n).map(|k| self.lower[k][i] * y[k]).sum();
            y[i] = (y[i] - known) / self.lower[i][i];
        }
        for i in 0..self.n {
            y[i] *= self.scale[i];
        }
        y
    }
}

#[cfg(test)]
mod tests {
    use super::super::rules::face_rule;
    use super::*;

    const KINDS: [CellKind; 7] = [
        CellKind::Line2,
        CellKind::Line3,
        CellKind::Tri3,
        CellKind::Tri6,
        CellKind::Quad4,
        CellKind::Quad8,
        CellKind::Quad9,
    ];

    /// ∫ φ φᵀ over an affine image of the reference element (into itself): ξ₀ + size ξ.
    fn mass(kind: CellKind, start: [f64; 3], size: f64) -> Square {
        let mut mass = [[0.0; MAX_NODES]; MAX_NODES];
        let rule = face_rule(kind);
        for (xi, weight) in rule.points.iter().zip(&rule.weights) {
            let at = std::array::from_fn(|k| start[k] + size * xi[k]);
            let mut values = [0.0; MAX_NODES];
            kind.element().shape(at, &mut values[..kind.node_count()]);
            for k in 0..MAX_NODES {
                for l in 0..MAX_NODES {
                    mass[k][l] += weight * values[k] * values[l];
                }
            }
        }
        mass
    }

    /// The reference element itself, and a part of it.
    fn parts(kind: CellKind) -> [([f64; 3], f64); 2] {
        match kind {
            CellKind::Tri3 | CellKind::Tri6 => [([0.0; 3], 1.0), ([0.3, 0.1, 0.0], 0.6)],
            _ => [([0.0; 3], 1.0), ([0.4, -0.5, 0.0], 0.5)],
        }
    }

    fn keeps(count: usize) -> Vec<[bool; MAX_NODES]> {
        let all: [bool; MAX_NODES] = std::array::from_fn(|k| k < count);
        let mut keeps = vec![all];
        for out in 0..count {
            let mut keep = all;
            keep[out] = false;
            keep[(out + 2) % count] &= count == 2;
            keeps.push(keep);
        }
        keeps
    }

    #[test]
    fn bases_are_biorthogonal_and_sum_to_one() {
        for kind in KINDS {
            let count = kind.node_count();
            for (part, (start, size)) in parts(kind).into_iter().enumerate() {
                let mass = mass(kind, start, size);
                for keep in keeps(count) {
                    let basis = dual_basis(kind, &mass, &keep);
                    let n = basis.kept.len();
                    // The whole face carries everyone who asks; a part of a quadratic one may not.
                    if part == 0 {
                        assert_eq!(n, keep.iter().filter(|&&k| k).count());
                    }
                    let rows = shared(&positive_basis(kind), count, &basis.kept);
                    let total: f64 = mass.iter().flatten().sum();
                    for i in 0..n {
                        let psi = &basis.coefficients[i];
                        // On a part M̃ is near to singular.
                        let tolerance = if part == 0 { 1e-13 } else { 1e-9 };
                        let against = |j: usize| -> f64 {
                            let entries = (0..count).flat_map(|k| (0..count).map(move |l| (k, l)));
                            entries.map(|(k, l)| psi[k] * mass[k][l] * rows[j][l]).sum()
                        };
                        let measure: f64 = (0..n).map(against).sum();
                        for j in (0..n).filter(|&j| j != i) {
                            let error = against(j).abs() / total;
                            assert!(error < tolerance, "{kind}, part {part}, {i} {j}: {error:e}");
                        }
                        assert!((against(i) - measure).abs() < n as f64 * tolerance * total);
                        assert!(measure > 0.0 || kind == CellKind::Quad8 && part == 1);
                    }
                    // Σ ψ = Σ_k (Σ_j C_jk) φ_k = 1.
                    for k in 0..count {
                        let column = || basis.coefficients.iter().map(|row| row[k]);
                        let steep: f64 = column().map(f64::abs).fold(10.0, f64::max);
                        let error = (column().sum::<f64>() - 1.0).abs();
                        assert!(error < 1e-14 * steep, "{kind} {keep:?}: {error:e}");
                    }
                }
            }
        }
    }

    #[test]
    fn positive_bases_are_positive() {
        for kind in KINDS {
            let count = kind.node_count();
            let rows = positive_basis(kind);
            let rule = face_rule(kind);
            for &xi in &rule.points {
                let mut values = [0.0; MAX_NODES];
                kind.element().shape(xi, &mut values[..count]);
                let positive = rows.map(|row| (0..count).map(|k| row[k] * values[k]).sum::<f64>());
                assert!((positive.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                let least = positive.iter().copied().fold(0.0, f64::min);
                assert!(
                    least > -1e-15 || kind == CellKind::Quad8,
                    "{kind}: {positive:?}"
                );
            }
            let measures = positive_measures(kind, &mass(kind, [0.0; 3], 1.0));
            assert!(measures[..count].iter().all(|&measure| measure > 0.05));
        }
    }
}
