//! The problem near a point: the directions in which λ may move, and the curvature of the circles.

use super::operator_memory::OperatorMemory;
use super::preconditioner::Preconditioner;
use super::reduced_space::{ReducedOperator, ReducedSpace};
use super::system::conjugate_gradients;
use crate::active_set::ActiveSet;
use crate::error::{QcqpError, check_vector};
use crate::operator::dual_operator::DualOperator;
use crate::point::{Point, gradient_step};
use crate::problem::DualProblem;
use crate::sets::product::ProductSet;
use crate::settings::{InnerSolver, Settings};
use crate::solution::DualSolution;
use faer::ColMut;
use faer::Side;
use faer::linalg::solvers::{Llt, Solve};
use tresca_la::LinearOperator;
use tresca_la::vector::norm;

/// Up to this order factoring the active block costs less than a few multiplications.
const SMALL: usize = 300;

/// The tangent of the dual problem at a point: Z, C, and the factor of ZᵀAZ + C where it is small.
///
/// Z is an orthonormal basis of the directions in which λ may move to first order: every component of a block
/// that is free (closed, sticking), and for each slipping disc with bound g > 0 the tangent t of its circle, t
/// orthogonal to the friction λτ. C is the diagonal matrix of the curvatures
///
/// ```text
/// c̃ = max(−λτᵀrτ, 0)/g²      (the slip per friction force; 0 for components of free blocks).
/// ```
///
/// A step of the reduced semismooth Newton method is Z s with (ZᵀAZ + C) s = −Zᵀ r. At a solution where no
/// block is on the edge between two states (strict complementarity) the same matrix is the derivative of the
/// solution: when b changes by δb,
///
/// ```text
/// δλ = Z (ZᵀAZ + C)⁻¹ Zᵀ δb + o(‖δb‖).
/// ```
///
/// The matrix is symmetric, so that the adjoint of this map is the map itself. Slip bounds, and the multiplier of
/// an equality constraint, count as held.
#[derive(Debug)]
pub struct Tangent {
    space: ReducedSpace,
    factor: Option<Llt<f64>>,
}

impl Tangent {
    /// The tangent at the solution of a problem, as the problem stands after its solve. Costs no multiplication.
    ///
    /// # Errors
    /// When the solution is not one of this problem: its length differs, or it is not finite.
    pub fn at(
        problem: &DualProblem<'_>,
        solution: &DualSolution,
        settings: &Settings,
    ) -> Result<Self, QcqpError> {
        check_vector("λ of the solution", &solution.lambda, problem.dim())?;
        check_vector("the gradient", &solution.gradient, problem.dim())?;
        let point = Point {
            lambda: solution.lambda.clone(),
            gradient: solution.gradient.clone(),
        };
        // Without an estimate of σmax λ = 0 solves the problem, whatever ρ is.
        let rho = match solution.figures.sigma_max {
            0.0 => 1.0,
            sigma => 1.0 / sigma,
        };
        let active = problem.set.classify(&gradient_step(&point, rho));
        let solver = settings.inner_solver;
        let (operator, set) = (&*problem.operator, &problem.set);
        Ok(Self::at_projection(
            operator, solver, set, &active, &point, rho,
        ))
    }

    /// Number of columns of Z.
    pub fn dim(&self) -> usize {
        self.space.dim()
    }

    /// Z s, as long as λ.
    ///
    /// # Panics
    /// When s has not one entry per column of Z.
    pub fn expand(&self, problem: &DualProblem<'_>, s: &[f64]) -> Vec<f64> {
        let mut full = vec![0.0; problem.dim()];
        self.space.expand(s, &mut full);
        full
    }

    /// Zᵀ v.
    ///
    /// # Panics
    /// When v is shorter than λ.
    pub fn restrict(&self, v: &[f64]) -> Vec<f64> {
        let mut reduced = vec![0.0; self.dim()];
        self.space.restrict(v, &mut reduced);
        reduced
    }

    /// The diagonal of C, one entry per column of Z.
    pub fn curvature(&self) -> Vec<f64> {
        self.space
            .columns()
            .map(|column| column.curvature)
            .collect()
    }

    /// (ZᵀAZ + C) s, at the price of one multiplication by A.
    ///
    /// # Panics
    /// When s has not one entry per column of Z.
    pub fn product(&self, problem: &mut DualProblem<'_>, s: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.dim()];
        ReducedOperator::new(&mut *problem.operator, &self.space).apply(s, &mut out);
        out
    }

    /// s with (ZᵀAZ + C) s = `rhs`: by the factor where there is one, else by conjugate gradients to the relative
    /// residual `accuracy`, with all that the problem knows of A.
    ///
    /// # Errors
    /// When `rhs` has the wrong length or is not finite, or the matrix is singular, or conjugate gradients need
    /// more than the iterations that the settings allow.
    pub fn solve(
        &self,
        problem: &mut DualProblem<'_>,
        settings: &Settings,
        rhs: &[f64],
        accuracy: f64,
    ) -> Result<Vec<f64>, QcqpError> {
        check_vector("the right-hand side of the tangent", rhs, self.dim())?;
        let v = self.expand(problem, rhs);
        Ok(self.restrict(&self.response(problem, settings, &v, accuracy)?))
    }

    /// Z (ZᵀAZ + C)⁻¹ Zᵀ v: the change of λ that a change v of b brings about.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub fn response(
        &self,
        problem: &mut DualProblem<'_>,
        settings: &Settings,
        v: &[f64],
        accuracy: f64,
    ) -> Result<Vec<f64>, QcqpError> {
        check_vector("the change of b", v, problem.dim())?;
        let operator = &mut *problem.operator;
        let memory = OperatorMemory::of(&mut problem.memory, operator)?;
        let (response, residual) = self.respond(operator, memory, settings, v, accuracy);
        if residual <= accuracy {
            Ok(response)
        } else {
            Err(QcqpError::Tangent { residual })
        }
    }

    /// Z, C and the factor for this space.
    pub(crate) fn new(
        operator: &dyn DualOperator,
        solver: InnerSolver,
        space: ReducedSpace,
    ) -> Self {
        let factor = factor(operator, solver, &space);
        Self { space, factor }
    }

    /// At x, where slipping pairs are on their circles: c̃ = max(−n̂ᵀr, 0)/g with the normal n̂ = x/g, the slip
    /// per friction force there.
    pub(crate) fn at_point(
        operator: &dyn DualOperator,
        solver: InnerSolver,
        set: &ProductSet,
        active: &ActiveSet,
        x: &Point,
    ) -> Self {
        let Point { lambda, gradient } = x;
        let curvature = |i: usize, bound: f64| {
            let radial = (lambda[i] * gradient[i] + lambda[i + 1] * gradient[i + 1]) / bound;
            f64::max(-radial / bound, 0.0)
        };
        let space = ReducedSpace::with_tangents(set, active, lambda, curvature);
        Self::new(operator, solver, space)
    }

    /// At P(y), y = λ − ρ r: it is on the circle of every slipping pair, also where a loosely solved λ is not.
    pub(crate) fn at_projection(
        operator: &dyn DualOperator,
        solver: InnerSolver,
        set: &ProductSet,
        active: &ActiveSet,
        point: &Point,
        rho: f64,
    ) -> Self {
        let mut lambda = gradient_step(point, rho);
        set.project(&mut lambda);
        let x = Point {
            lambda,
            gradient: point.gradient.clone(),
        };
        Self::at_point(operator, solver, set, active, &x)
    }

    /// Z and C.
    pub(crate) fn space(&self) -> &ReducedSpace {
        &self.space
    }

    /// The Newton step from x by the factor, at the price of one multiplication for the new gradient. `false`, and
    /// `x` unchanged, where there is no factor.
    pub(crate) fn step(&self, operator: &mut dyn DualOperator, x: &mut Point) -> bool {
        let residual: Vec<f64> = x.gradient.iter().map(|r| -r).collect();
        let Some(direction) = self.respond_by_factor(&residual) else {
            return false;
        };
        let mut product = vec![0.0; direction.len()];
        operator.apply(&direction, &mut product);
        x.advance(1.0, &direction, &product);
        true
    }

    /// Z (ZᵀAZ + C)⁻¹ Zᵀ v, and the relative residual (0 by the factor) that it is computed to.
    pub(crate) fn respond(
        &self,
        operator: &mut dyn DualOperator,
        memory: &mut OperatorMemory,
        settings: &Settings,
        v: &[f64],
        accuracy: f64,
    ) -> (Vec<f64>, f64) {
        if let Some(response) = self.respond_by_factor(v) {
            return (response, 0.0);
        }
        let size = norm(&self.restrict(v));
        if size == 0.0 {
            return (vec![0.0; v.len()], 0.0);
        }
        let newton = memory.newton(operator, settings.recycled_directions);
        let mut preconditioner = Preconditioner::new(
            &self.space,
            &newton.model,
            &mut newton.recycled,
            &mut newton.workspace,
        );
        // The Newton step from 0 under the gradient −v. Its products are kept.
        let mut x = Point::zero(v);
        let spent = conjugate_gradients(
            operator,
            &self.space,
            &mut preconditioner,
            &mut x,
            accuracy * size,
            settings.max_inner_iterations,
            |_, step| {
                newton.recycled.offer(step.direction, step.product);
                true
            },
        );
        (x.lambda, spent.residual / size)
    }

    fn respond_by_factor(&self, v: &[f64]) -> Option<Vec<f64>> {
        let factor = self.factor.as_ref()?;
        let mut s = self.restrict(v);
        factor.solve_in_place(ColMut::from_slice_mut(&mut s));
        norm(&s).is_finite().then(|| {
            let mut response = vec![0.0; v.len()];
            self.space.expand(&s, &mut response);
            response
        })
    }
}

/// The factor of ZᵀAZ + C when A is explicit and the settings allow it; `None` when that is not
/// so or the matrix is not positive definite.
fn factor(
    operator: &dyn DualOperator,
    solver: InnerSolver,
    space: &ReducedSpace,
) -> Option<Llt<f64>> {
    let wanted = match solver {
        InnerSolver::Auto => space.dim() <= SMALL,
        InnerSolver::Iterative => false,
        InnerSolver::Direct => true,
    };
    let matrix = operator.explicit().filter(|_| wanted && space.dim() > 0)?;
    let mut block = space.assemble(matrix);
    let shift = operator.shift_of_factors();
    if shift > 0.0 {
        (0..space.dim()).for_each(|i| block[(i, i)] += shift);
    }
    Llt::new(block.as_ref(), Side::Lower).ok()
}
