//! Conic programmes, solved by Clarabel: min ½xᵀPx + qᵀx over b − Ax in a product of cones.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT, SupportedConeT::*,
};

/// A conic programme that grows row by row.
#[derive(Debug, Default)]
pub struct Program {
    /// The upper triangle of P.
    pub quadratic: Vec<(usize, usize, f64)>,
    /// q; its length is the number of unknowns.
    pub linear: Vec<f64>,
    entries: Vec<(usize, usize, f64)>,
    rhs: Vec<f64>,
    cones: Vec<SupportedConeT<f64>>,
}

/// A row of A, sparse, and its entry of b.
pub type Row = (Vec<(usize, f64)>, f64);

/// Where Clarabel ended.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// The point.
    pub x: Vec<f64>,
    /// The objective there.
    pub objective: f64,
}

/// Relative residuals and gap that are good enough, whatever status they come with.
const GOOD: f64 = 1e-8;

impl Program {
    /// With so many unknowns, all of no weight.
    pub fn new(unknowns: usize) -> Self {
        Self {
            linear: vec![0.0; unknowns],
            ..Self::default()
        }
    }

    fn push(&mut self, rows: Vec<Row>) {
        for (row, b) in rows {
            let at = self.rhs.len();
            self.entries
                .extend(row.into_iter().map(|(j, a)| (at, j, a)));
            self.rhs.push(b);
        }
    }

    /// a x = b.
    pub fn equal(&mut self, row: Row) {
        self.push(vec![row]);
        self.cones.push(ZeroConeT(1));
    }

    /// a x ≤ b.
    pub fn at_most(&mut self, row: Row) {
        self.push(vec![row]);
        self.cones.push(NonnegativeConeT(1));
    }

    /// b − Ax in the second-order cone.
    pub fn in_cone(&mut self, rows: Vec<Row>) {
        self.cones.push(SecondOrderConeT(rows.len()));
        self.push(rows);
    }

    /// The minimum; `Err` says why there is none to be relied on.
    pub fn minimise(&self) -> Result<Minimum, String> {
        let n = self.linear.len();
        let p = csc(&self.quadratic, n, n);
        let a = csc(&self.entries, self.rhs.len(), n);
        // First as exact as can be: near its limit the iteration may lose what it had.
        let mut last = String::new();
        for (tolerance, equilibrate_enable) in [
            (1e-12, true),
            (1e-10, true),
            (1e-9, true),
            (1e-12, false),
            (1e-9, false),
        ] {
            let settings = DefaultSettings {
                verbose: false,
                equilibrate_enable,
                max_iter: 200,
                tol_gap_abs: tolerance,
                tol_gap_rel: tolerance,
                tol_feas: tolerance,
                ..DefaultSettings::default()
            };
            let solver = DefaultSolver::new(&p, &self.linear, &a, &self.rhs, &self.cones, settings);
            let mut solver = solver.map_err(|error| error.to_string())?;
            solver.solve();
            let found = &solver.solution;
            let gap = (found.obj_val - found.obj_val_dual).abs();
            let certificate = matches!(
                found.status,
                SolverStatus::PrimalInfeasible
                    | SolverStatus::AlmostPrimalInfeasible
                    | SolverStatus::DualInfeasible
                    | SolverStatus::AlmostDualInfeasible
            );
            let good = gap <= GOOD * found.obj_val.abs().max(1.0)
                && found.r_prim <= GOOD
                && found.r_dual <= GOOD;
            if good && !certificate {
                return Ok(Minimum {
                    x: found.x.clone(),
                    objective: found.obj_val,
                });
            }
            last = format!(
                "Clarabel: {:?}, gap {gap:.0e}, residuals {:.0e} and {:.0e}",
                found.status, found.r_prim, found.r_dual
            );
        }
        Err(last)
    }
}

fn csc(entries: &[(usize, usize, f64)], rows: usize, columns: usize) -> CscMatrix<f64> {
    let mut entries: Vec<_> = entries.iter().filter(|entry| entry.2 != 0.0).collect();
    entries.sort_by_key(|&&(i, j, _)| (j, i));
    let mut starts = vec![0; columns + 1];
    entries.iter().for_each(|&&(_, j, _)| starts[j + 1] += 1);
    (0..columns).for_each(|j| starts[j + 1] += starts[j]);
    let (index, value) = entries.iter().map(|&&(i, _, v)| (i, v)).unzip();
    CscMatrix::new(rows, columns, starts, index, value)
}
