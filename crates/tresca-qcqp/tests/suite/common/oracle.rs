//! Clarabel on the conic form of the dual problem, and on what statics and geometry ask.

use super::Plain;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT, SupportedConeT::*,
};
use tresca_qcqp::sets::BlockSet;
use tresca_qcqp::{CoulombBound, ProductSet};

/// The minimiser: ½ xᵀAx − bᵀx subject to s = h − Gx in a product of cones.
pub fn minimiser(plain: &Plain) -> Vec<f64> {
    constrained_minimiser(plain, &[], &[]).expect("Λ is not empty")
}

/// The minimiser under `rows` x = `rhs` besides; `None` when Clarabel proves that there is none.
pub fn constrained_minimiser(plain: &Plain, rows: &[Vec<f64>], rhs: &[f64]) -> Option<Vec<f64>> {
    let n = plain.dim();
    let mut p = Triplets::default();
    for j in 0..n {
        for i in 0..=j {
            p.push(i, j, plain.a[i][j]);
        }
    }
    let (mut g, mut h, mut cones) = of_set(&plain.set, &[]);
    for (row, e) in rows.iter().zip(rhs) {
        for (j, value) in row.iter().enumerate() {
            g.push(h.len(), j, *value);
        }
        h.push(*e);
        cones.push(ZeroConeT(1));
    }
    let q: Vec<f64> = plain.b.iter().map(|b| -b).collect();
    solve(&p.csc(n, n), &q, &g.csc(h.len(), n), &h, &cones)
}

/// Limit analysis: the largest τ ≤ 2 such that some λ in reach has `rows` λ = τ `rhs`. Below 1 there is
/// no equilibrium. The bounds of the `law` follow their normal forces, in the place of those of the set.
pub fn load_factor(set: &ProductSet, law: &[CoulombBound], rows: &[Vec<f64>], rhs: &[f64]) -> f64 {
    let n = set.dimension();
    let (mut g, mut h, mut cones) = of_set(set, law);
    for (row, e) in rows.iter().zip(rhs) {
        for (j, value) in row.iter().enumerate() {
            g.push(h.len(), j, *value);
        }
        g.push(h.len(), n, -e);
        h.push(0.0);
        cones.push(ZeroConeT(1));
    }
    largest_last(n + 1, 2.0, g, h, cones)
}

/// The largest t ≤ 1 such that `rows` u + t ≤ `gaps` for some u: positive where all gaps can be open.
pub fn clearance(rows: &[Vec<f64>], gaps: &[f64]) -> f64 {
    let n = rows.first().map_or(0, Vec::len);
    let (mut g, mut h, mut cones) = (Triplets::default(), Vec::new(), Vec::new());
    for (row, gap) in rows.iter().zip(gaps) {
        for (j, value) in row.iter().enumerate() {
            g.push(h.len(), j, *value);
        }
        g.push(h.len(), n, 1.0);
        h.push(*gap);
    }
    cones.push(NonnegativeConeT(h.len()));
    largest_last(n + 1, 1.0, g, h, cones)
}

/// The largest value of the last of n unknowns, which is at most `most`.
fn largest_last(
    n: usize,
    most: f64,
    mut g: Triplets,
    mut h: Vec<f64>,
    mut cones: Vec<SupportedConeT<f64>>,
) -> f64 {
    g.push(h.len(), n - 1, 1.0);
    h.push(most);
    cones.push(NonnegativeConeT(1));
    let mut q = vec![0.0; n];
    q[n - 1] = -1.0;
    let nothing = Triplets::default().csc(n, n);
    solve(&nothing, &q, &g.csc(h.len(), n), &h, &cones).expect("0 will do")[n - 1]
}

/// s = h − Gx in a product of cones that says x ∈ Λ, with the friction cones of a law.
fn of_set(
    set: &ProductSet,
    law: &[CoulombBound],
) -> (Triplets, Vec<f64>, Vec<SupportedConeT<f64>>) {
    let (mut g, mut h, mut cones) = (Triplets::default(), Vec::new(), Vec::new());
    for (number, block) in set.blocks().iter().enumerate() {
        let i = block.start;
        if let Some(bound) = law.iter().find(|bound| bound.block == number) {
            // ‖t‖ ≤ F n.
            assert!(bound.limit.is_infinite());
            g.push(h.len(), bound.normal, -bound.coefficient);
            h.push(0.0);
            for j in block.range() {
                g.push(h.len(), j, -1.0);
                h.push(0.0);
            }
            cones.push(SecondOrderConeT(1 + block.range().len()));
            continue;
        }
        match block.set {
            BlockSet::Line(_) => {}
            BlockSet::HalfLine(_) => {
                g.push(h.len(), i, -1.0);
                h.push(0.0);
                cones.push(NonnegativeConeT(1));
            }
            BlockSet::Origin(_) => {
                g.push(h.len(), i, 1.0);
                h.push(0.0);
                cones.push(ZeroConeT(1));
            }
            BlockSet::Interval(interval) => {
                g.push(h.len(), i, 1.0);
                g.push(h.len() + 1, i, -1.0);
                h.extend([interval.bound; 2]);
                cones.push(NonnegativeConeT(2));
            }
            BlockSet::Disc(disc) if disc.bound == 0.0 => {
                g.push(h.len(), i, 1.0);
                g.push(h.len() + 1, i + 1, 1.0);
                h.extend([0.0; 2]);
                cones.push(ZeroConeT(2));
            }
            BlockSet::Disc(disc) => {
                g.push(h.len() + 1, i, -1.0);
                g.push(h.len() + 2, i + 1, -1.0);
                h.extend([disc.bound, 0.0, 0.0]);
                cones.push(SecondOrderConeT(3));
            }
        }
    }
    (g, h, cones)
}

fn solve(
    p: &CscMatrix<f64>,
    q: &[f64],
    g: &CscMatrix<f64>,
    h: &[f64],
    cones: &[SupportedConeT<f64>],
) -> Option<Vec<f64>> {
    let settings = DefaultSettings {
        verbose: false,
        max_iter: 200,
        tol_gap_abs: 1e-13,
        tol_gap_rel: 1e-13,
        tol_feas: 1e-13,
        ..DefaultSettings::default()
    };
    let mut solver = DefaultSolver::new(p, q, g, h, cones, settings).unwrap();
    solver.solve();
    let status = solver.solution.status;
    let infeasible = matches!(
        status,
        SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible
    );
    // The status may be "almost solved" at such tolerances: the caller judges the point.
    (!infeasible).then(|| std::mem::take(&mut solver.solution.x))
}

#[derive(Default)]
struct Triplets(Vec<(usize, usize, f64)>);

impl Triplets {
    fn push(&mut self, row: usize, column: usize, value: f64) {
        self.0.push((column, row, value));
    }

    fn csc(mut self, rows: usize, columns: usize) -> CscMatrix<f64> {
        self.0.sort_by_key(|&(j, i, _)| (j, i));
        let mut start = vec![0; columns + 1];
        for &(j, _, _) in &self.0 {
            start[j + 1] += 1;
        }
        for j in 0..columns {
            start[j + 1] += start[j];
        }
        let rows_of = self.0.iter().map(|t| t.1).collect();
        CscMatrix::new(
            rows,
            columns,
            start,
            rows_of,
            self.0.iter().map(|t| t.2).collect(),
        )
    }
}
