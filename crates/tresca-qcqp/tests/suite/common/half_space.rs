//! A rigid block on an elastic half-space: contact whose matrices are closed forms.
#![allow(clippy::needless_range_loop)] // loops over indices, as in the formulas

use super::{Plain, dot};
use tresca_qcqp::operator::Dense;
use tresca_qcqp::{CoulombBound, DualProblem, Equality, ProductSet};

/// A square of `side`² contact points on the half-space, unit length, shear modulus 1.
///
/// K. L. Johnson, *Contact Mechanics* (1985), eqs. 3.18, 3.75: displacements of the surface under
/// point forces, the own force spread over a cell. λ = [λν; λτ]: λν presses on the half-space,
/// λτ acts on the block, and rows of B measure the motion of the block relative to the half-space.
pub struct HalfSpace {
    pub points: Vec<[f64; 2]>,
    pub compliance: Vec<Vec<f64>>,
}

impl HalfSpace {
    pub fn new(side: usize, poisson: f64) -> Self {
        let h = 1.0 / side as f64;
        let at = |i: usize| (i as f64 + 0.5) * h - 0.5;
        let points: Vec<[f64; 2]> = (0..side * side)
            .map(|k| [at(k % side), at(k / side)])
            .collect();
        let m = points.len();
        let mut a = vec![vec![0.0; 3 * m]; 3 * m];
        let quarter = 1.0 / (4.0 * std::f64::consts::PI);
        for i in 0..m {
            for j in 0..m {
                // Displacement at i by a force at j.
                let [x, y] = [points[i][0] - points[j][0], points[i][1] - points[j][1]];
                let r = x.hypot(y);
                let inverse = if i == j { 3.525 / h } else { 1.0 / r };
                let (cx, cy) = if i == j {
                    (0.5_f64.sqrt(), 0.5_f64.sqrt())
                } else {
                    (x / r, y / r)
                };
                let direct = 2.0 * (1.0 - poisson);
                let cross = if i == j {
                    0.0
                } else {
                    (1.0 - 2.0 * poisson) * quarter * inverse
                };
                a[i][j] = direct * quarter * inverse;
                let (tx, ty) = (m + 2 * i, m + 2 * i + 1);
                let (sx, sy) = (m + 2 * j, m + 2 * j + 1);
                a[tx][sx] = quarter * inverse * (direct + 2.0 * poisson * cx * cx);
                a[ty][sy] = quarter * inverse * (direct + 2.0 * poisson * cy * cy);
                if i != j {
                    a[tx][sy] = quarter * inverse * 2.0 * poisson * cx * cy;
                    a[ty][sx] = a[tx][sy];
                    a[i][sx] = cross * cx;
                    a[i][sy] = cross * cy;
                    a[tx][j] = -cross * cx;
                    a[ty][j] = -cross * cy;
                }
            }
        }
        Self {
            points,
            compliance: a,
        }
    }

    pub fn pairs(&self) -> usize {
        self.points.len()
    }

    /// Motions of the block (three translations, three rotations about the origin) as they appear
    /// at the contact: the rows of G.
    pub fn motions(&self) -> Vec<Vec<f64>> {
        let m = self.pairs();
        let motion = |number: usize| {
            let mut row = vec![0.0; 3 * m];
            for (i, &[x, y]) in self.points.iter().enumerate() {
                // u = t + ω × (x, y, 0)
                let u = match number {
                    0 => [1.0, 0.0, 0.0],
                    1 => [0.0, 1.0, 0.0],
                    2 => [0.0, 0.0, 1.0],
                    3 => [0.0, 0.0, y],
                    4 => [0.0, 0.0, -x],
                    _ => [-y, x, 0.0],
                };
                row[i] = -u[2];
                row[m + 2 * i] = u[0];
                row[m + 2 * i + 1] = u[1];
            }
            row
        };
        (0..6).map(motion).collect()
    }

    /// The block under the force (fx, fy, fz) at (0, 0, height), floating; `gap` at the points.
    pub fn block(&self, force: [f64; 3], height: f64, gap: impl Fn([f64; 2]) -> f64) -> Floating {
        let m = self.pairs();
        let rows = self.motions();
        let [fx, fy, fz] = force;
        let load = vec![fx, fy, fz, -height * fy, height * fx, 0.0];
        // The size of S is free: here about the compliance of the whole contact.
        let metric: Vec<Vec<f64>> = (0..6)
            .map(|i| {
                (0..6)
                    .map(|j| {
                        if i == j {
                            [0.5, 0.5, 0.5, 4.0, 4.0, 4.0][i]
                        } else {
                            0.0
                        }
                    })
                    .collect()
            })
            .collect();
        let mut gaps = vec![0.0; 3 * m];
        for (gap_of, &point) in gaps.iter_mut().zip(&self.points) {
            *gap_of = gap(point);
        }
        Floating::new(
            self.compliance.clone(),
            gaps.iter().map(|d| -d).collect(),
            ProductSet::contact_3d(&vec![0.0; m]).unwrap(),
            Equality {
                rows,
                rhs: load,
                metric,
            },
        )
    }

    /// Coulomb's law with one coefficient.
    pub fn law(&self, coefficient: f64) -> Vec<CoulombBound> {
        let m = self.pairs();
        (0..m)
            .map(|i| CoulombBound {
                block: m + i,
                normal: i,
                coefficient,
                limit: f64::INFINITY,
            })
            .collect()
    }
}

/// A problem with an equality constraint as plain data: A and b hold GᵀSG and GᵀSe.
pub struct Floating {
    pub plain: Plain,
    pub equality: Equality,
}

impl Floating {
    /// From A and b of the deformable parts alone.
    pub fn new(mut a: Vec<Vec<f64>>, mut b: Vec<f64>, set: ProductSet, equality: Equality) -> Self {
        let n = b.len();
        let spread: Vec<Vec<f64>> = equality
            .metric
            .iter()
            .map(|weights| {
                let mut row = vec![0.0; n];
                for (w, g) in weights.iter().zip(&equality.rows) {
                    row.iter_mut().zip(g).for_each(|(r, g)| *r += w * g);
                }
                row
            })
            .collect();
        for (row, spread) in equality.rows.iter().zip(&spread) {
            for i in 0..n {
                for j in 0..n {
                    a[i][j] += row[i] * spread[j];
                }
            }
        }
        for (spread, e) in spread.iter().zip(&equality.rhs) {
            b.iter_mut().zip(spread).for_each(|(b, s)| *b += s * e);
        }
        Self {
            plain: Plain { a, b, set },
            equality,
        }
    }

    pub fn problem(&self) -> DualProblem<'static> {
        let Plain { b, set, .. } = &self.plain;
        DualProblem::new(Dense::new(self.plain.packed()), b.clone(), set.clone())
            .unwrap()
            .with_equality(&self.equality)
            .unwrap()
    }

    /// Gλ − e.
    pub fn residual(&self, lambda: &[f64]) -> Vec<f64> {
        let rows = self.equality.rows.iter().zip(&self.equality.rhs);
        rows.map(|(row, e)| dot(row, lambda) - e).collect()
    }
}
