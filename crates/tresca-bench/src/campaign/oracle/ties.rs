//! Equations between displacements, eliminated by orthogonalisation: u = u0 + Z v.

use crate::campaign::dense::{self, Rows, dot, norm};

/// A row shorter than this part of itself, once the others are projected out, depends on them.
const DEPENDENT: f64 = 1e-10;
/// A dependent row is met up to this part of its length times that of u; beyond `CONTRADICTS` it is not.
const MET: f64 = 1e-9;
const CONTRADICTS: f64 = 1e-6;

/// All u that meet the equations.
#[derive(Debug)]
pub struct Affine {
    /// The shortest of them.
    pub origin: Vec<f64>,
    /// An orthonormal basis Z of their differences, vector by vector.
    pub basis: Rows,
}

/// What there is to say of equations.
#[derive(Debug)]
pub enum Ties {
    /// They have solutions.
    Met(Affine),
    /// They contradict each other.
    Contradict,
    /// By too little to say.
    Unclear,
}

/// Takes v to its part orthogonal to orthonormal vectors; their shares are handed to `also`.
fn project(v: &mut [f64], basis: &Rows, mut also: impl FnMut(usize, f64)) {
    for _ in 0..2 {
        for (k, q) in basis.iter().enumerate() {
            let share = dot(v, q);
            dense::add(v, -share, q);
            also(k, share);
        }
    }
}

/// Solves rows · u = values.
pub fn eliminate(rows: &[(Vec<f64>, f64)], dofs: usize) -> Ties {
    // Every row, projected on what is orthogonal to the pivots so far, with its value.
    let mut left: Vec<(Vec<f64>, f64)> = rows.to_vec();
    let mut basis: Rows = Vec::new();
    let mut values: Vec<f64> = Vec::new();
    let whole: Vec<f64> = rows.iter().map(|(row, _)| norm(row)).collect();
    let relative = |left: &[(Vec<f64>, f64)], i: usize| {
        if whole[i] > 0.0 {
            norm(&left[i].0) / whole[i]
        } else {
            0.0
        }
    };
    loop {
        let pivot =
            (0..left.len()).max_by(|&i, &j| relative(&left, i).total_cmp(&relative(&left, j)));
        let Some(pivot) = pivot.filter(|&i| relative(&left, i) > DEPENDENT) else {
            break;
        };
        let length = norm(&left[pivot].0);
        let q: Vec<f64> = left[pivot].0.iter().map(|x| x / length).collect();
        basis.push(q);
        values.push(left[pivot].1 / length);
        for (row, value) in &mut left {
            project(row, &basis, |k, share| *value -= share * values[k]);
        }
        left[pivot] = (vec![0.0; dofs], 0.0);
    }
    let mut origin = vec![0.0; dofs];
    for (q, value) in basis.iter().zip(&values) {
        dense::add(&mut origin, *value, q);
    }
    let mut worst: f64 = 0.0;
    for (row, value) in rows {
        let terms = value.abs() + norm(row) * norm(&origin);
        let apart = (value - dot(row, &origin)).abs();
        if apart > 0.0 {
            worst = worst.max(apart / terms);
        }
    }
    if worst >= CONTRADICTS {
        return Ties::Contradict;
    }
    if worst > MET {
        return Ties::Unclear;
    }
    let ties = basis.len();
    while basis.len() < dofs {
        let rest = |j: usize| 1.0 - basis.iter().map(|q| q[j] * q[j]).sum::<f64>();
        let next = (0..dofs)
            .max_by(|&i, &j| rest(i).total_cmp(&rest(j)))
            .unwrap_or(0);
        let mut v = vec![0.0; dofs];
        v[next] = 1.0;
        project(&mut v, &basis, |_, _| {});
        let length = norm(&v);
        basis.push(v.into_iter().map(|x| x / length).collect());
    }
    Ties::Met(Affine {
        origin,
        basis: basis.split_off(ties),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_of_a_zero_is_no_contradiction() {
        let rows = [(vec![0.0, -1.0], 0.0), (vec![-1.0, -1.0], -0.27)];
        assert!(matches!(eliminate(&rows, 2), Ties::Met(_)));
    }

    #[test]
    fn equations_are_solved_or_contradict() {
        let rows = [(vec![1.0, 0.0, 1.0], 2.0), (vec![2.0, 0.0, 2.0], 4.0)];
        let Ties::Met(affine) = eliminate(&rows, 3) else {
            panic!()
        };
        assert_eq!(affine.basis.len(), 2);
        assert!((affine.origin[0] - 1.0).abs() < 1e-15 && (affine.origin[2] - 1.0).abs() < 1e-15);
        let rows = [(vec![1.0], 0.2), (vec![1.0], -0.94)];
        assert!(matches!(eliminate(&rows, 1), Ties::Contradict));
        let rows = [(vec![1.0], 0.2), (vec![1.0], 0.2 + 1e-8)];
        assert!(matches!(eliminate(&rows, 1), Ties::Unclear));
        // Two directions 1e-7 apart are two.
        let rows = [(vec![1.0, 0.0], 1.0), (vec![1.0, 1e-7], 1.0 + 2e-7)];
        let Ties::Met(affine) = eliminate(&rows, 2) else {
            panic!()
        };
        assert!((affine.origin[1] - 2.0).abs() < 1e-8);
    }
}
