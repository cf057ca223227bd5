//! Is there an equilibrium?
//!
//! Whether Gλ = e has a solution in Λ is asked of statics alone, before any elasticity: the
//! distance ½‖ẽ − G̃λ‖² is made smallest over Λ by the proximal point method,
//!
//! ```text
//! λ⁺ = argmin ½‖ẽ − G̃λ‖² + δ/2 ‖λ − λᵏ‖²  =  P_Λ(λᵏ + G̃ᵀv/δ)   where   v = ẽ − G̃ P_Λ(λᵏ + G̃ᵀv/δ),
//! ```
//!
//! δ falling. The equation for v has as many unknowns as there are rigid motions, and is solved by
//! a semismooth Newton method with line search (X. Zhao, D. Sun, K.-C. Toh, *A Newton–CG augmented
//! Lagrangian method*, SIAM J. Optim. 20 (2010)). Either the distance falls to rounding, or v
//! becomes a proof: ẽᵀv > sup λᵀG̃ᵀv over Λ.

use super::{Balance, Reach};
use faer::linalg::solvers::{Llt, Solve};
use faer::{ColMut, Mat, Side};
use tresca_la::vector::{axpy, dot, norm};

/// ‖ẽ − G̃λ‖/‖ẽ‖ that counts as equilibrium.
const BALANCED: f64 = 1e-12;
/// Part of the load, as power on v, that must remain for the proof.
const LEAST_POWER: f64 = 1e-8;
/// What an entry of G̃ᵀv may be wrong by, relative to the length of its column.
const SLACK: f64 = 1e-10;
const MAX_PROXIMAL_STEPS: usize = 40;
const MAX_NEWTON_STEPS: usize = 60;

/// What statics say.
pub(crate) enum Equilibrium {
    /// Some λ ∈ Λ balances the load, or nothing proves the contrary.
    Possible,
    /// None does: the motion v in scaled coordinates, and the λ ∈ Λ that comes nearest.
    Impossible { motion: Vec<f64>, lambda: Vec<f64> },
}

/// Looks for a λ in `reach` that balances the load.
pub(crate) fn find(balance: &Balance, reach: &Reach) -> Equilibrium {
    let dim = balance.rows.first().map_or(0, Vec::len);
    let load = norm(&balance.load);
    if load == 0.0 {
        return Equilibrium::Possible;
    }
    let columns: Vec<f64> = (0..dim)
        .map(|i| {
            balance
                .rows
                .iter()
                .map(|row| row[i] * row[i])
                .sum::<f64>()
                .sqrt()
        })
        .collect();
    let largest = columns.iter().copied().fold(0.0, f64::max);
    // With no contact row at all any δ will do.
    let stiffest = if largest > 0.0 {
        largest * largest
    } else {
        1.0
    };
    let mut delta = 0.1 * stiffest;
    let mut lambda = vec![0.0; dim];
    let mut v = balance.load.clone();
    for _ in 0..MAX_PROXIMAL_STEPS {
        proximal_motion(balance, reach, &lambda, delta, load, &mut v);
        lambda = step_along(balance, reach, &lambda, delta, &v).1;
        if norm(&balance.shortfall(&lambda)) <= BALANCED * load {
            return Equilibrium::Possible;
        }
        if proves_impossible(balance, reach, &columns, load, &v) {
            return Equilibrium::Impossible { motion: v, lambda };
        }
        delta = f64::max(0.1 * delta, 1e-9 * stiffest);
    }
    Equilibrium::Possible
}

/// ẽᵀv > sup λᵀG̃ᵀv.
fn proves_impossible(
    balance: &Balance,
    reach: &Reach,
    columns: &[f64],
    load: f64,
    v: &[f64],
) -> bool {
    let mut driven = vec![0.0; columns.len()];
    balance.add_transposed(v, &mut driven);
    let size = norm(v);
    let held = reach.support(&driven, |i| SLACK * columns[i] * size);
    dot(&balance.load, v) - held > LEAST_POWER * load * size
}

/// y = λ + G̃ᵀv/δ and P(y).
fn step_along(
    balance: &Balance,
    reach: &Reach,
    lambda: &[f64],
    delta: f64,
    v: &[f64],
) -> (Vec<f64>, Vec<f64>) {
    let mut y = vec![0.0; lambda.len()];
    balance.add_transposed(v, &mut y);
    for (y, l) in y.iter_mut().zip(lambda) {
        *y = l + *y / delta;
    }
    let mut near = y.clone();
    reach.project(&mut near);
    (y, near)
}

/// Solves v + G̃P(λ + G̃ᵀv/δ) = ẽ for v, from the v given: the stationary point of the convex
/// function ½‖v‖² − ẽᵀv + δ M(λ + G̃ᵀv/δ) with ∇M = P.
fn proximal_motion(
    balance: &Balance,
    reach: &Reach,
    lambda: &[f64],
    delta: f64,
    load: f64,
    v: &mut Vec<f64>,
) {
    let evaluate = |v: &[f64]| {
        let (y, near) = step_along(balance, reach, lambda, delta, v);
        let mut residual = balance.shortfall(&near);
        residual.iter_mut().zip(v).for_each(|(r, v)| *r -= v);
        let envelope = delta * (dot(&y, &near) - 0.5 * dot(&near, &near));
        let value = 0.5 * dot(v, v) - dot(&balance.load, v) + envelope;
        (y, residual, value)
    };
    let (mut y, mut residual, mut value) = evaluate(v);
    for _ in 0..MAX_NEWTON_STEPS {
        let wanted = f64::max(1e-9 * norm(v), 1e-15 * load);
        if norm(&residual) <= wanted {
            return;
        }
        let Some(step) = newton_step(balance, reach, &y, delta, &residual) else {
            return;
        };
        let slope = dot(&residual, &step);
        let mut alpha = 1.0;
        loop {
            let mut trial = v.clone();
            axpy(alpha, &step, &mut trial);
            let next = evaluate(&trial);
            let falls = next.2 <= value - 1e-4 * alpha * slope;
            // Near the end the value is rounding; the residual is not.
            if falls || norm(&next.1) <= 0.5 * norm(&residual) {
                *v = trial;
                (y, residual, value) = next;
                break;
            }
            alpha *= 0.5;
            if alpha < 1e-10 {
                return;
            }
        }
    }
}

/// (I + G̃ P'(y) G̃ᵀ/δ)⁻¹ residual.
fn newton_step(
    balance: &Balance,
    reach: &Reach,
    y: &[f64],
    delta: f64,
    residual: &[f64],
) -> Option<Vec<f64>> {
    let slanted: Vec<Vec<f64>> = balance
        .rows
        .iter()
        .map(|row| {
            let mut row = row.clone();
            reach.slant(y, &mut row);
            row
        })
        .collect();
    let order = residual.len();
    let matrix = Mat::from_fn(order, order, |i, j| {
        f64::from(u8::from(i == j)) + dot(&balance.rows[i], &slanted[j]) / delta
    });
    let factor = Llt::new(matrix.as_ref(), Side::Lower).ok()?;
    let mut step = residual.to_vec();
    factor.solve_in_place(ColMut::from_slice_mut(&mut step));
    norm(&step).is_finite().then_some(step)
}
