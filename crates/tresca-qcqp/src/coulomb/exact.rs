//! The exact Newton method for the whole law, bounds and all.
//!
//! ```text
//! F(λ) = λ − P(y),   y = λ − ρ r(λ),   P onto half-lines, lines, and discs of radius min(F max(y_n, 0), limit)
//! ```
//!
//! With an equality constraint G̃λ = ẽ its multiplier is one more unknown, and r(λ) = Aλ − b − G̃ᵀβ.
//! (P. Alart, A. Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991).) Its generalised derivative is not symmetric, as
//! the bound depends on the normal force: a dense LU factorisation in each step, with a line search on ‖F‖. It has no
//! guarantee, but from a point near a solution it is there in a few steps: sweeps offer such points.

use super::frictional::Frictional;
use super::law::CoulombBound;
use crate::operator::dual_operator::DualOperator;
use crate::point::{Point, point_at};
use crate::sets::block::BlockSet;
use faer::linalg::solvers::Solve;
use faer::{ColMut, Mat};
use tresca_la::SymmetricEntries;
use tresca_la::vector::norm;

/// Up to this order the factorisations cost less than the sweeps that they spare.
const LARGEST: usize = 600;
const MAX_STEPS: usize = 30;
const MAX_HALVINGS: usize = 12;
/// ‖F‖ relative to that at the start that counts as solved.
const SOLVED: f64 = 1e-14;

/// What one block of Λ asks for, in terms of y.
struct Row<'a> {
    set: BlockSet,
    start: usize,
    law: Option<&'a CoulombBound>,
    /// ρ of its unknowns.
    rho: f64,
}

/// λ and β after some Newton steps, as long as ‖F‖ falls; `None` where A has no entries, or too many.
pub(super) fn solve(
    operator: &mut dyn DualOperator,
    problem: &Frictional,
    lambda: &[f64],
    beta: &[f64],
) -> Option<(Vec<f64>, Vec<f64>)> {
    if operator.dim() > LARGEST {
        return None;
    }
    let rows = rows(operator.explicit()?, problem);
    let rho_of = rho_of(&rows, operator.dim());
    let mut at = station(operator, problem, lambda.to_vec(), beta.to_vec());
    let mut residual = defect(problem, &rows, &rho_of, &at);
    let first = norm(&residual);
    for _ in 0..MAX_STEPS {
        let size = norm(&residual);
        if size <= SOLVED * first {
            break;
        }
        let matrix = derivative(operator.explicit()?, problem, &rows, &rho_of, &at);
        let mut step: Vec<f64> = residual.iter().map(|f| -f).collect();
        matrix
            .partial_piv_lu()
            .solve_in_place(ColMut::from_slice_mut(&mut step));
        if !norm(&step).is_finite() {
            break;
        }
        let mut length = 1.0;
        let mut next = None;
        for _ in 0..MAX_HALVINGS {
            let moved = at.point.lambda.iter().chain(&at.beta).zip(&step);
            let mut moved: Vec<f64> = moved.map(|(x, s)| x + length * s).collect();
            let beta = moved.split_off(at.point.lambda.len());
            let trial = station(operator, problem, moved, beta);
            let value = defect(problem, &rows, &rho_of, &trial);
            if norm(&value) <= (1.0 - 1e-4 * length) * size {
                next = Some((trial, value));
                break;
            }
            length *= 0.5;
        }
        let Some((trial, value)) = next else { break };
        (at, residual) = (trial, value);
    }
    Some((at.point.lambda, at.beta))
}

/// λ and β with the gradient there.
struct Station {
    point: Point,
    beta: Vec<f64>,
}

fn station(
    operator: &mut dyn DualOperator,
    problem: &Frictional,
    lambda: Vec<f64>,
    beta: Vec<f64>,
) -> Station {
    let mut point = point_at(operator, problem.rhs, lambda);
    if let Some(balance) = problem.balance {
        let minus: Vec<f64> = beta.iter().map(|b| -b).collect();
        balance.add_transposed(&minus, &mut point.gradient);
    }
    Station { point, beta }
}

fn rows<'a>(a: &dyn SymmetricEntries, problem: &Frictional<'a>) -> Vec<Row<'a>> {
    let mut laws: Vec<Option<&CoulombBound>> = vec![None; problem.set.blocks().len()];
    for bound in problem.law.bounds_of_blocks() {
        laws[bound.block] = Some(bound);
    }
    let blocks = problem.set.blocks().iter().zip(laws);
    blocks
        .map(|(block, law)| {
            let size = block.range().map(|i| a.entry(i, i)).fold(0.0, f64::max);
            Row {
                set: block.set,
                start: block.start,
                law,
                rho: if size > 0.0 { 1.0 / size } else { 1.0 },
            }
        })
        .collect()
}

/// ρ of every unknown.
fn rho_of(rows: &[Row], dim: usize) -> Vec<f64> {
    let mut rho = vec![1.0; dim];
    for row in rows {
        rho[row.start] = row.rho;
        if matches!(row.set, BlockSet::Disc(_)) {
            rho[row.start + 1] = row.rho;
        }
    }
    rho
}

/// The radius of a disc or interval, and whether it follows the normal force.
fn radius(row: &Row, y: impl Fn(usize) -> f64) -> (f64, bool) {
    match row.law {
        None => (row.set.bound().unwrap_or(0.0), false),
        Some(law) => {
            let follows = law.coefficient * y(law.normal).max(0.0);
            (follows.min(law.limit), follows > 0.0 && follows < law.limit)
        }
    }
}

/// F, and ẽ − G̃λ below it.
fn defect(problem: &Frictional, rows: &[Row], rho: &[f64], station: &Station) -> Vec<f64> {
    let at = &station.point;
    let y = |i: usize| at.lambda[i] - rho[i] * at.gradient[i];
    let mut f = at.lambda.clone();
    for row in rows {
        let i = row.start;
        match row.set {
            BlockSet::Line(_) => f[i] -= y(i),
            BlockSet::HalfLine(_) => f[i] -= y(i).max(0.0),
            BlockSet::Origin(_) => {}
            BlockSet::Interval(_) => {
                let (g, _) = radius(row, y);
                f[i] -= y(i).clamp(-g, g);
            }
            BlockSet::Disc(_) => {
                let (g, _) = radius(row, y);
                let size = y(i).hypot(y(i + 1));
                let share = if size > g { g / size } else { 1.0 };
                f[i] -= share * y(i);
                f[i + 1] -= share * y(i + 1);
            }
        }
    }
    if let Some(balance) = problem.balance {
        f.extend(balance.shortfall(&at.lambda));
    }
    f
}

/// F'.
fn derivative(
    a: &dyn SymmetricEntries,
    problem: &Frictional,
    rows: &[Row],
    rho: &[f64],
    station: &Station,
) -> Mat<f64> {
    let at = &station.point;
    let unknowns = at.lambda.len();
    let constraints: &[Vec<f64>] = problem.balance.map_or(&[], |balance| &balance.rows);
    let dim = unknowns + constraints.len();
    let y = |i: usize| at.lambda[i] - rho[i] * at.gradient[i];
    // ∂y_i/∂λ_j, and ∂y_i/∂β after them.
    let dy = |i: usize, j: usize| {
        if j >= unknowns {
            return rho[i] * constraints[j - unknowns][i];
        }
        let own = if i == j { 1.0 } else { 0.0 };
        own - rho[i] * a.entry(i.max(j), i.min(j))
    };
    let mut matrix = Mat::identity(dim, dim);
    for (k, row) in constraints.iter().enumerate() {
        matrix[(unknowns + k, unknowns + k)] = 0.0;
        for (j, g) in row.iter().enumerate() {
            matrix[(unknowns + k, j)] = -g;
        }
    }
    for row in rows {
        let i = row.start;
        match row.set {
            BlockSet::Line(_) => (0..dim).for_each(|j| matrix[(i, j)] -= dy(i, j)),
            BlockSet::HalfLine(_) if y(i) > 0.0 => {
                (0..dim).for_each(|j| matrix[(i, j)] -= dy(i, j));
            }
            BlockSet::HalfLine(_) | BlockSet::Origin(_) => {}
            BlockSet::Interval(_) => {
                let (g, follows) = radius(row, y);
                if y(i).abs() <= g {
                    (0..dim).for_each(|j| matrix[(i, j)] -= dy(i, j));
                } else if let Some(law) = row.law.filter(|_| follows) {
                    let slope = law.coefficient.copysign(y(i));
                    (0..dim).for_each(|j| matrix[(i, j)] -= slope * dy(law.normal, j));
                }
            }
            BlockSet::Disc(_) => {
                let (g, follows) = radius(row, y);
                let size = y(i).hypot(y(i + 1));
                let d = [y(i) / size, y(i + 1) / size];
                for j in 0..dim {
                    let own = [dy(i, j), dy(i + 1, j)];
                    if size <= g {
                        matrix[(i, j)] -= own[0];
                        matrix[(i + 1, j)] -= own[1];
                        continue;
                    }
                    let radial = d[0] * own[0] + d[1] * own[1];
                    let grows = row.law.filter(|_| follows);
                    let grows = grows.map_or(0.0, |law| law.coefficient * dy(law.normal, j));
                    for k in 0..2 {
                        let turns = g / size * (own[k] - radial * d[k]);
                        matrix[(i + k, j)] -= turns + grows * d[k];
                    }
                }
            }
        }
    }
    matrix
}
