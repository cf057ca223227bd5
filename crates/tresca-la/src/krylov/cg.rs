//! Conjugate gradients, preconditioned, one step at a time.
//!
//! Hestenes and Stiefel (1952); the preconditioned form of Saad, *Iterative
//! Methods for Sparse Linear Systems*, 2nd ed., algorithm 9.1.
//!
//! The step is split in two, because the contact methods must look between the
//! halves: [`ConjugateGradient::propose`] spends the one product A p and fixes
//! the step length α; the caller sees direction, product and α and either lets
//! [`ConjugateGradient::accept`] go there, shortens the step and stops, or
//! stops. [`solve`] is the loop for callers that need none of this.

use crate::operator::LinearOperator;
use crate::vector::{axpy, dot, norm};

/// What the next step would be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Proposal {
    /// x + α p minimises the quadratic along the direction p.
    Step {
        /// Step length α = rᵀz / pᵀAp, positive.
        alpha: f64,
        /// pᵀAp, positive.
        curvature: f64,
    },
    /// The residual is zero: x solves the system exactly.
    Solved,
    /// pᵀAp, or rᵀM⁻¹r, is not positive (or not a number): the operator or the
    /// preconditioner is not positive definite, in floating point at least.
    NotPositiveDefinite,
}

/// State and workspace of the method for the system A x = b.
///
/// Reusable: a later start with another (also smaller) dimension allocates
/// nothing as long as the dimension stays within the capacity.
#[derive(Clone, Debug, Default)]
pub struct ConjugateGradient {
    residual: Vec<f64>,
    preconditioned: Vec<f64>,
    direction: Vec<f64>,
    product: Vec<f64>,
    /// rᵀM⁻¹r of the step before; `None` before the first step.
    last_rz: Option<f64>,
    rz: f64,
    alpha: f64,
}

impl ConjugateGradient {
    /// Workspace for systems up to order `capacity`.
    pub fn with_capacity(capacity: usize) -> Self {
        Self {
            residual: Vec::with_capacity(capacity),
            preconditioned: Vec::with_capacity(capacity),
            direction: Vec::with_capacity(capacity),
            product: Vec::with_capacity(capacity),
            ..Self::default()
        }
    }

    /// Starts from an iterate whose residual b − A x the caller knows. Spends no product.
    pub fn start(&mut self, residual: &[f64]) {
        self.resize(residual.len());
        self.residual.copy_from_slice(residual);
    }

    /// Starts from x. Spends one product.
    pub fn start_at<A: LinearOperator + ?Sized>(&mut self, operator: &mut A, b: &[f64], x: &[f64]) {
        self.resize(b.len());
        operator.apply(x, &mut self.residual);
        for (r, b) in self.residual.iter_mut().zip(b) {
            *r = b - *r;
        }
    }

    fn resize(&mut self, dim: usize) {
        for v in [
            &mut self.residual,
            &mut self.preconditioned,
            &mut self.direction,
            &mut self.product,
        ] {
            v.clear();
            v.resize(dim, 0.0);
        }
        self.last_rz = None;
    }

    /// The residual b − A x, as the recurrence has it.
    pub fn residual(&self) -> &[f64] {
        &self.residual
    }

    /// ‖b − A x‖₂ of the recurrence.
    pub fn residual_norm(&self) -> f64 {
        norm(&self.residual)
    }

    /// The proposed direction p. Meaningful after a [`Proposal::Step`].
    pub fn direction(&self) -> &[f64] {
        &self.direction
    }

    /// A p for the proposed direction. Meaningful after a [`Proposal::Step`].
    pub fn product(&self) -> &[f64] {
        &self.product
    }

    /// Computes direction and step length; spends one product and one
    /// application of the preconditioner (none when the residual is zero).
    pub fn propose<A, M>(&mut self, operator: &mut A, preconditioner: &mut M) -> Proposal
    where
        A: LinearOperator + ?Sized,
        M: LinearOperator + ?Sized,
    {
        debug_assert_eq!(operator.dim(), self.residual.len());
        if self.residual.iter().all(|&r| r == 0.0) {
            return Proposal::Solved;
        }
        preconditioner.apply(&self.residual, &mut self.preconditioned);
        self.rz = dot(&self.residual, &self.preconditioned);
        // Written so that a NaN ends here too.
        if !(self.rz > 0.0 && self.rz.is_finite()) {
            return Proposal::NotPositiveDefinite;
        }
        let beta = self.last_rz.map_or(0.0, |last| self.rz / last);
        for (p, z) in self.direction.iter_mut().zip(&self.preconditioned) {
            *p = z + beta * *p;
        }
        operator.apply(&self.direction, &mut self.product);
        let curvature = dot(&self.direction, &self.product);
        if !(curvature > 0.0 && curvature.is_finite()) {
            return Proposal::NotPositiveDefinite;
        }
        self.alpha = self.rz / curvature;
        Proposal::Step {
            alpha: self.alpha,
            curvature,
        }
    }

    /// Takes the proposed step: x ← x + α p, r ← r − α A p.
    pub fn accept(&mut self, x: &mut [f64]) {
        axpy(self.alpha, &self.direction, x);
        axpy(-self.alpha, &self.product, &mut self.residual);
        self.last_rz = Some(self.rz);
    }
}

/// Why [`solve`] stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CgOutcome {
    /// The residual norm reached the tolerance.
    Converged,
    /// The allowed iterations are spent.
    IterationLimit,
    /// See [`Proposal::NotPositiveDefinite`].
    NotPositiveDefinite,
}

/// What [`solve`] did.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct CgRecord {
    /// Why it stopped.
    pub outcome: CgOutcome,
    /// Steps taken. Products spent: one more for the start, and one more for a
    /// direction that was given up.
    pub iterations: usize,
    /// ‖b − A x‖₂ of the recurrence at the end.
    pub residual_norm: f64,
}

/// Solves A x = b from the given x until ‖b − A x‖₂ ≤ `tolerance` (absolute).
pub fn solve<A, M>(
    operator: &mut A,
    preconditioner: &mut M,
    b: &[f64],
    x: &mut [f64],
    tolerance: f64,
    max_iterations: usize,
    workspace: &mut ConjugateGradient,
) -> CgRecord
where
    A: LinearOperator + ?Sized,
    M: LinearOperator + ?Sized,
{
    workspace.start_at(operator, b, x);
    let mut iterations = 0;
    let outcome = loop {
        if workspace.residual_norm() <= tolerance {
            break CgOutcome::Converged;
        }
        if iterations == max_iterations {
            break CgOutcome::IterationLimit;
        }
        match workspace.propose(operator, preconditioner) {
            Proposal::Step { .. } => workspace.accept(x),
            Proposal::Solved => break CgOutcome::Converged,
            Proposal::NotPositiveDefinite => break CgOutcome::NotPositiveDefinite,
        }
        iterations += 1;
    };
    CgRecord {
        outcome,
        iterations,
        residual_norm: workspace.residual_norm(),
    }
}
