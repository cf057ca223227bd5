//! Clarabel on the conic form of the dual problem.

use super::Plain;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT, SupportedConeT::*,
};
use tresca_qcqp::sets::BlockSet;

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
    let (mut g, mut h, mut cones) = (Triplets::default(), Vec::new(), Vec::new());
    for block in plain.set.blocks() {
        let i = block.start;
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
    for (row, e) in rows.iter().zip(rhs) {
        for (j, value) in row.iter().enumerate() {
            g.push(h.len(), j, *value);
        }
        h.push(*e);
        cones.push(ZeroConeT(1));
    }
    solve(&p.csc(n, n), plain, &g.csc(h.len(), n), &h, &cones)
}

fn solve(
    p: &CscMatrix<f64>,
    plain: &Plain,
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
    let q: Vec<f64> = plain.b.iter().map(|b| -b).collect();
    let mut solver = DefaultSolver::new(p, &q, g, h, cones, settings).unwrap();
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
