//! Block Gauss–Seidel for Coulomb's law (and all others): contact by contact, each solved as if alone.

use super::conditions::Conditions;
use crate::campaign::dense::{Cholesky, Rows, add, dot, norm, product, transposed_product};
use crate::campaign::problem::{DualForm, Problem, bounds, is_closed};
use crate::campaign::random::Random;
use tresca::algebraic::PairLaw;

/// A residual of the conditions that is a solution.
const SOLVED: f64 = 1e-7;
/// Sweeps of a start.
const SWEEPS: usize = 2000;
/// Sweeps after which is looked, and what floats is moved.
const AT_ONCE: usize = 5;
/// What holds that which floats, over the largest entry of K's diagonal.
const HELD: f64 = 0.1;

/// Starts: the size of random forces, and the share of each step that is taken.
const STARTS: [(f64, f64); 6] = [
    (0.0, 1.0),
    (0.0, 0.7),
    (1.0, 1.0),
    (1.0, 0.7),
    (1.0, 0.3),
    (3.0, 0.8),
];

/// λ that solves the problem, if the sweeps find it: from nothing, then from random forces, then with shorter
/// steps.
///
/// What floats is held by springs at where it was before (the proximal point method): where it no longer moves,
/// nothing is left of them.
pub fn sweep(problem: &Problem) -> Option<Vec<f64>> {
    let conditions = Conditions::new(problem)?;
    let motions = conditions.motions();
    let mut held = problem.clone();
    let mut k = problem.whole();
    let most = (0..k.len()).map(|i| k[i][i]).fold(0.0, f64::max);
    let spring = HELD * if most > 0.0 { most } else { 1.0 };
    for motion in motions {
        for (row, amount) in k.iter_mut().zip(motion) {
            add(row, spring * amount, motion);
        }
    }
    held.stiffness = vec![k];
    let form = held.dual()?;
    // B (K + σRRᵀ)⁻¹ R, for the motions one by one.
    let moved = Cholesky::new(&held.stiffness[0])?;
    let of_motions: Rows = motions.iter().map(|motion| moved.solve(motion)).collect();
    let contact = problem.contact();
    let mut random = Random::new(problem.pairs() as u64);
    for (start, relaxation) in STARTS {
        let mut form = form.clone();
        let mut amounts = vec![0.0; motions.len()];
        let mut lambda: Vec<f64> = random.normals(form.rhs.len());
        lambda.iter_mut().for_each(|force| *force *= start);
        let normal = &mut lambda[..problem.pairs()];
        normal.iter_mut().for_each(|force| *force = force.abs());
        for round in 0..SWEEPS / AT_ONCE {
            for _ in 0..AT_ONCE {
                once(problem, &form, &mut lambda, relaxation);
            }
            // How far what floats moved.
            let mut acting = problem.load.clone();
            add(
                &mut acting,
                -1.0,
                &transposed_product(&contact, &lambda, problem.dofs()),
            );
            let mut steps = vec![0.0; motions.len()];
            if !motions.is_empty() {
                for (motion, amount) in motions.iter().zip(&amounts) {
                    add(&mut acting, spring * amount, motion);
                }
                let u = moved.solve(&acting);
                for ((motion, amount), step) in motions.iter().zip(&mut amounts).zip(&mut steps) {
                    let now = dot(motion, &u);
                    *step = now - *amount;
                    *amount = now;
                }
            }
            let residual = conditions.residual(&lambda, &form.relative(&lambda));
            let pulled = spring * norm(&steps) / norm(&lambda).max(norm(&problem.load));
            if residual <= SOLVED && (motions.is_empty() || pulled <= SOLVED) {
                return Some(lambda);
            }
            if residual.is_nan() || motions.is_empty() && round > 100 && residual > 1e-2 {
                break;
            }
            for (image, step) in of_motions.iter().zip(&steps) {
                add(&mut form.rhs, spring * step, &product(&contact, image));
            }
        }
    }
    None
}

fn once(problem: &Problem, form: &DualForm, lambda: &mut [f64], relaxation: f64) {
    let (m, tangents) = (problem.pairs(), problem.tangents);
    for pair in 0..m {
        let rows: Vec<usize> = std::iter::once(pair)
            .chain((0..tangents).map(|t| m + tangents * pair + t))
            .collect();
        let w: Rows = rows
            .iter()
            .map(|&i| rows.iter().map(|&j| form.matrix[i][j]).collect())
            .collect();
        // w r + q: the gap left, and minus the slip.
        let q: Vec<f64> = rows
            .iter()
            .zip(&w)
            .map(|(&i, own)| {
                let theirs: f64 = rows.iter().zip(own).map(|(&j, w)| w * lambda[j]).sum();
                dot(&form.matrix[i], lambda) - theirs - form.rhs[i]
            })
            .collect();
        let before: Vec<f64> = rows.iter().map(|&i| lambda[i]).collect();
        let own = local(&problem.laws[pair], &w, &q)
            .unwrap_or_else(|| projected(&problem.laws[pair], &w, &q, &before));
        for ((&i, x), b) in rows.iter().zip(own).zip(before) {
            lambda[i] = (1.0 - relaxation) * b + relaxation * x;
        }
    }
}

/// The exact solution of one contact with isotropic Coulomb friction: open, sticking or slipping.
fn local(law: &PairLaw, w: &Rows, q: &[f64]) -> Option<Vec<f64>> {
    let PairLaw::Coulomb {
        coefficients: [mu, other],
        limit,
    } = *law
    else {
        return None;
    };
    let tangents = q.len() - 1;
    if limit.is_finite() || tangents == 2 && mu != other {
        return None;
    }
    if q[0] >= 0.0 {
        return Some(vec![0.0; q.len()]);
    }
    if let Some(r) = solve(w, q)
        && r[0] >= 0.0
        && dot(&r[1..], &r[1..]).sqrt() <= mu * r[0]
    {
        return Some(r);
    }
    let slipping = |direction: &[f64]| {
        let lever = w[0][0] + mu * dot(&w[0][1..], direction);
        let normal = -q[0] / lever;
        let mut r = vec![normal];
        r.extend(direction.iter().map(|c| mu * normal * c));
        // Minus the slip.
        let motion: Vec<f64> = (1..q.len()).map(|i| dot(&w[i], &r) + q[i]).collect();
        (r, motion)
    };
    if tangents == 1 {
        return [-1.0, 1.0].into_iter().find_map(|sign| {
            let (r, motion) = slipping(&[sign]);
            (r[0] > 0.0 && motion[0] * sign <= 0.0).then_some(r)
        });
    }
    // The angle at which the motion lies along the force.
    let at = |angle: f64| {
        let (c, s) = (angle.cos(), angle.sin());
        let (r, motion) = slipping(&[c, s]);
        let along = motion[0] * c + motion[1] * s;
        (motion[0] * s - motion[1] * c, along, r)
    };
    let steps = 90;
    let angle = |k: usize| std::f64::consts::TAU * k as f64 / steps as f64;
    let mut before = at(angle(0)).0;
    for k in 1..=steps {
        let value = at(angle(k)).0;
        if before * value <= 0.0 {
            let (mut low, mut high) = (angle(k - 1), angle(k));
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if before * at(middle).0 <= 0.0 {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            let (across, along, r) = at(0.5 * (low + high));
            let size = q.iter().map(|q| q.abs()).sum::<f64>();
            if r[0] > 0.0 && along <= 1e-12 * size && across.abs() <= 1e-8 * size {
                return Some(r);
            }
        }
        before = value;
    }
    None
}

/// w r = −q, by elimination.
fn solve(w: &Rows, q: &[f64]) -> Option<Vec<f64>> {
    let factor = Cholesky::new(w)?;
    let minus: Vec<f64> = q.iter().map(|q| -q).collect();
    Some(factor.solve(&minus))
}

/// One contact of any law, by projections that follow the normal force.
fn projected(law: &PairLaw, w: &Rows, q: &[f64], before: &[f64]) -> Vec<f64> {
    let trace: f64 = (0..q.len()).map(|i| w[i][i]).sum();
    if trace <= 0.0 {
        return before.to_vec();
    }
    let rho = 1.0 / trace;
    let mut r = before.to_vec();
    for _ in 0..100 {
        let motion: Vec<f64> = (0..q.len()).map(|i| dot(&w[i], &r) + q[i]).collect();
        for (r, motion) in r.iter_mut().zip(&motion) {
            *r -= rho * motion;
        }
        if !is_closed(law) {
            r[0] = r[0].max(0.0);
        }
        let Some(bounds) = bounds(law, r[0]) else {
            continue;
        };
        let own = super::conditions::onto(law, &r[1..], bounds);
        r[1..].copy_from_slice(&own);
    }
    r
}
