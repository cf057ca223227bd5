//! BiCGSTAB for nonsymmetric systems, preconditioned from the right.
//!
//! H. A. van der Vorst, *Bi-CGSTAB: a fast and smoothly converging variant of
//! Bi-CG for the solution of nonsymmetric linear systems*, SIAM J. Sci. Stat.
//! Comput. 13 (1992). Two products per iteration (one when the first half
//! already reaches the goal).

use crate::operator::LinearOperator;
use crate::vector::{axpy, dot, norm};

/// Why the method stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BicgstabOutcome {
    /// The caller's criterion was met.
    Converged,
    /// The allowed iterations are spent.
    IterationLimit,
    /// A scalar of the recurrence vanished or is not a number. The iterate is
    /// the best that was reached safely; a restart from it may go on.
    Breakdown,
}

/// What the method did.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct BicgstabRecord {
    /// Why it stopped.
    pub outcome: BicgstabOutcome,
    /// Iterations begun and finished, the half ones included.
    pub iterations: usize,
    /// Products with A, the one for the first residual included.
    pub products: usize,
    /// ‖b − A x‖₂ of the recurrence at the end.
    pub residual_norm: f64,
}

/// Workspace; reusable, allocates only when a system is larger than all before.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    residual: Vec<f64>,
    shadow: Vec<f64>,
    direction: Vec<f64>,
    direction_product: Vec<f64>,
    residual_product: Vec<f64>,
    preconditioned: Vec<f64>,
}

impl Workspace {
    /// Workspace for systems up to order `capacity`.
    pub fn with_capacity(capacity: usize) -> Self {
        let mut workspace = Self::default();
        workspace.resize(capacity);
        workspace
    }

    fn resize(&mut self, dim: usize) {
        for v in [
            &mut self.residual,
            &mut self.shadow,
            &mut self.direction,
            &mut self.direction_product,
            &mut self.residual_product,
            &mut self.preconditioned,
        ] {
            v.clear();
            v.resize(dim, 0.0);
        }
    }
}

/// Solves A x = b from the given x. `stop` sees ‖b − A x‖₂ of the recurrence
/// (first for the start, then after every half step) and ends the loop with `true`.
pub fn solve<A, M>(
    operator: &mut A,
    preconditioner: &mut M,
    b: &[f64],
    x: &mut [f64],
    max_iterations: usize,
    mut stop: impl FnMut(f64) -> bool,
    workspace: &mut Workspace,
) -> BicgstabRecord
where
    A: LinearOperator + ?Sized,
    M: LinearOperator + ?Sized,
{
    workspace.resize(b.len());
    let Workspace {
        residual: r,
        shadow,
        direction: p,
        direction_product: v,
        residual_product: t,
        preconditioned: z,
    } = workspace;

    operator.apply(x, r);
    for (r, b) in r.iter_mut().zip(b) {
        *r = b - *r;
    }
    shadow.copy_from_slice(r);
    let mut record = BicgstabRecord {
        outcome: BicgstabOutcome::Converged,
        iterations: 0,
        products: 1,
        residual_norm: norm(r),
    };
    let (mut rho, mut alpha, mut omega) = (1.0, 0.0, 1.0);

    while record.residual_norm != 0.0 && !stop(record.residual_norm) {
        if record.iterations == max_iterations {
            record.outcome = BicgstabOutcome::IterationLimit;
            break;
        }
        let rho_next = dot(shadow, r);
        let beta = (rho_next / rho) * (alpha / omega);
        if !usable(rho_next) || !beta.is_finite() {
            record.outcome = BicgstabOutcome::Breakdown;
            break;
        }
        rho = rho_next;
        for ((p, r), v) in p.iter_mut().zip(&*r).zip(&*v) {
            *p = r + beta * (*p - omega * v);
        }

        preconditioner.apply(p, z);
        operator.apply(z, v);
        record.products += 1;
        let shadow_v = dot(shadow, v);
        alpha = rho / shadow_v;
        if !usable(shadow_v) || !alpha.is_finite() {
            record.outcome = BicgstabOutcome::Breakdown;
            break;
        }
        record.iterations += 1;
        axpy(alpha, z, x);
        axpy(-alpha, v, r);
        record.residual_norm = norm(r);
        if record.residual_norm == 0.0 || stop(record.residual_norm) {
            break;
        }

        preconditioner.apply(r, z);
        operator.apply(z, t);
        record.products += 1;
        omega = dot(t, r) / dot(t, t);
        if !usable(omega) {
            record.outcome = BicgstabOutcome::Breakdown;
            break;
        }
        axpy(omega, z, x);
        axpy(-omega, t, r);
        record.residual_norm = norm(r);
    }
    record
}

/// Neither zero nor infinite nor NaN.
fn usable(value: f64) -> bool {
    value != 0.0 && value.is_finite()
}
