//! The compliance of the contact in rigid motions.
//!
//! ```text
//! H = G Z (ZᵀAZ + C)⁻¹ Zᵀ Gᵀ
//! ```
//!
//! with Z and C at the solution λ(α) for a frozen multiplier: a change δα of it changes λ by
//! Z (ZᵀAZ + C)⁻¹ ZᵀGᵀ δα, and Gλ by H δα. −H is the generalised Hessian of the dual function.

use super::Point;
use super::grssn::tangent_space;
use super::inner::direct_factor;
use super::point::gradient_step;
use super::preconditioner::Preconditioner;
use crate::reduced::{ReducedOperator, ReducedSpace};
use crate::session::{Ending, Session};
use faer::linalg::solvers::Solve;
use faer::{ColMut, Mat};
use tresca_la::krylov::cg::{ConjugateGradient, Proposal};
use tresca_la::vector::{dot, norm};

/// H, and what it is made of.
pub(crate) struct Compliance {
    /// H, both triangles.
    pub matrix: Mat<f64>,
    /// Z (ZᵀAZ + C)⁻¹ ZᵀG_jᵀ for every row G_j, in the space of λ.
    pub responses: Vec<Vec<f64>>,
}

/// H at the end of an inner problem, for the `rows` of G; systems solved iteratively are solved
/// to the relative residual `accuracy`.
pub(crate) fn compliance(
    session: &mut Session,
    ending: &Ending,
    rows: &[Vec<f64>],
    accuracy: f64,
) -> Compliance {
    // P(y) is on the circle of every slipping pair, also where a loosely solved λ is not.
    let mut y = gradient_step(&ending.point, 1.0 / session.memory.spectrum.sigma);
    ending.set.project(&mut y);
    let x = Point {
        lambda: y,
        gradient: ending.point.gradient.clone(),
    };
    let space = tangent_space(&ending.set, &ending.active, &x);
    let responses = responses(session, &space, rows, accuracy);
    let order = rows.len();
    let product = |i: usize, j: usize| dot(&rows[i], &responses[j]);
    // Symmetric but for the accuracy of the responses.
    let matrix = Mat::from_fn(order, order, |i, j| 0.5 * (product(i, j) + product(j, i)));
    Compliance { matrix, responses }
}

fn responses(
    session: &mut Session,
    space: &ReducedSpace,
    rows: &[Vec<f64>],
    accuracy: f64,
) -> Vec<Vec<f64>> {
    let dim = session.operator.dim();
    let factor = direct_factor(session.operator, session.settings.inner_solver, space);
    let one = |row: &Vec<f64>| {
        let mut s = vec![0.0; space.dim()];
        space.restrict(row, &mut s);
        if let Some(factor) = &factor {
            factor.solve_in_place(ColMut::from_slice_mut(&mut s));
        } else {
            s = iterative(session, space, &s, accuracy);
        }
        let mut response = vec![0.0; dim];
        space.expand(&s, &mut response);
        response
    };
    rows.iter().map(one).collect()
}

/// (ZᵀAZ + C)⁻¹ rhs by preconditioned CG. The products are kept: the rows of G are few and
/// smooth, and change with Z only.
fn iterative(session: &mut Session, space: &ReducedSpace, rhs: &[f64], accuracy: f64) -> Vec<f64> {
    let capacity = session.settings.recycled_directions;
    let newton = session.memory.newton(session.operator, capacity);
    let mut preconditioner = Preconditioner::new(
        space,
        &newton.model,
        &mut newton.recycled,
        &mut newton.workspace,
    );
    let mut system = ReducedOperator::new(&mut *session.operator, space);
    let mut s = vec![0.0; space.dim()];
    let mut cg = ConjugateGradient::with_capacity(space.dim());
    cg.start(rhs);
    let tolerance = accuracy * norm(rhs);
    let limit = session.settings.max_inner_iterations.min(10 * space.dim());
    for _ in 0..limit {
        if cg.residual_norm() <= tolerance {
            break;
        }
        let Proposal::Step { .. } = cg.propose(&mut system, &mut preconditioner) else {
            break;
        };
        newton.recycled.offer(&system.expanded, &system.product);
        cg.accept(&mut s);
    }
    s
}
