//! SSN: the semismooth Newton method as it stands.
//!
//! Newton's method for λ = P_Λ(λ − ρ r(λ)) with the slanting function G of P_Λ:
//! (I − G (I − ρA)) δ = P_Λ(y) − λ at y = λ − ρ r(λ). Nonsymmetric where pairs
//! slip, so BiCGSTAB: two multiplications per inner iteration.

use super::inner::full_accuracy;
use super::run::Step;
use super::{Point, Run};
use crate::{DualOperator, ProductSet, Status};
use tresca_la::LinearOperator;
use tresca_la::krylov::{Identity, bicgstab};

/// δ ↦ δ − G(y)(δ − ρ A δ).
pub(crate) struct NewtonOperator<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub set: &'a ProductSet,
    pub y: &'a [f64],
    pub rho: f64,
    pub slanted: Vec<f64>,
}

impl LinearOperator for NewtonOperator<'_> {
    fn dim(&self) -> usize {
        self.y.len()
    }

    fn apply(&mut self, delta: &[f64], out: &mut [f64]) {
        self.operator.apply(delta, out);
        for ((slanted, d), a) in self.slanted.iter_mut().zip(delta).zip(&*out) {
            *slanted = d - self.rho * a;
        }
        self.set.slant(self.y, &mut self.slanted);
        for ((out, d), s) in out.iter_mut().zip(delta).zip(&self.slanted) {
            *out = d - s;
        }
    }
}

/// λ⁺ = λ + δ. Iterates may leave Λ; the projected ones are judged and returned.
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut x = start;
    let mut step = Step::START;
    let mut workspace = bicgstab::Workspace::with_capacity(run.rhs.len());
    loop {
        let feasible = run.projected(&x);
        if let Some(status) = run.judge(&feasible, step) {
            return status;
        }
        let y = run.y(&x);
        let mut rhs = y.clone();
        run.set.project(&mut rhs);
        for (rhs, l) in rhs.iter_mut().zip(&x.lambda) {
            *rhs -= l;
        }
        let (delta, iterations) = newton_direction(run, &y, &rhs, &mut workspace);
        let lambda = x.lambda.iter().zip(&delta).map(|(l, d)| l + d).collect();
        x = run.point(lambda);
        step = Step::full(iterations);
    }
}

/// Solves (I − G (I − ρA)) δ = rhs; returns δ and the number of inner iterations.
fn newton_direction(
    run: &mut Run,
    y: &[f64],
    rhs: &[f64],
    workspace: &mut bicgstab::Workspace,
) -> (Vec<f64>, usize) {
    // The rows are those of the reduced gradient times ρ.
    let tolerance = full_accuracy(run) * run.rho;
    let limit = run.settings.max_inner_iterations;
    let (rho, set) = (run.rho, run.set);
    let slanted = vec![0.0; y.len()];
    let mut system = NewtonOperator {
        operator: &mut *run.operator,
        set,
        y,
        rho,
        slanted,
    };
    // Bound rows read δ = rhs: started from there they stay solved, and BiCGSTAB works on the rest.
    let mut delta = rhs.to_vec();
    let mut iterations = 0;
    // After a breakdown a fresh shadow residual helps; without an iteration gained it is final.
    loop {
        let record = bicgstab::solve(
            &mut system,
            &mut Identity(y.len()),
            rhs,
            &mut delta,
            limit - iterations,
            |norm| norm <= tolerance,
            workspace,
        );
        iterations += record.iterations;
        let broken = record.outcome == bicgstab::Outcome::Breakdown;
        if !broken || record.iterations == 0 || iterations >= limit {
            return (delta, iterations);
        }
    }
}
