//! Can the contact forces balance the load on what floats? A conic programme in the forces alone.

use tresca::algebraic::PairLaw;

use super::conditions::motions;
use super::program::Program;
use crate::campaign::dense::{norm, product};
use crate::campaign::problem::{Problem, bounds, is_closed};

/// Part of the load on what floats, left over: below the first it is balanced, above the second it is not.
const BALANCED: f64 = 1e-7;
const UNBALANCED: f64 = 1e-4;

/// Is there an equilibrium? `Err` where that is too close to call.
pub fn is_balanced(problem: &Problem) -> Result<bool, String> {
    let motions = motions(problem).ok_or("no eigenvalues")?;
    let load = product(&motions, &problem.load);
    let size = norm(&load);
    // What rounding makes of a load that acts on no motion.
    if size <= 1e-14 * norm(&problem.load) {
        return Ok(true);
    }
    let contact = problem.contact();
    let unknowns = contact.len();
    let mut program = Program::new(unknowns + 1);
    program.linear[unknowns] = 1.0;
    let mut distance = vec![(vec![(unknowns, -1.0)], 0.0)];
    for (motion, e) in motions.iter().zip(&load) {
        let row = product(&contact, motion);
        let row = row.into_iter().enumerate().map(|(j, g)| (j, g / size));
        distance.push((row.collect(), e / size));
    }
    program.in_cone(distance);
    let (m, tangents) = (problem.pairs(), problem.tangents);
    for (pair, law) in problem.laws.iter().enumerate() {
        if !is_closed(law) {
            program.at_most((vec![(pair, -1.0)], 0.0));
        }
        let row = |t: usize| m + tangents * pair + t;
        // Σ (λ_t / w_t)² ≤ radius², w the bounds over the larger one.
        let (figures, radius): ([f64; 2], Vec<(usize, f64)>) = match *law {
            PairLaw::Tied => continue,
            PairLaw::Coulomb {
                coefficients,
                limit,
            } => {
                let most = coefficients[0].max(coefficients[1]);
                let figures = coefficients.map(|f| if most > 0.0 { f / most } else { 0.0 });
                if limit.is_finite() && most > 0.0 {
                    let mut cone = vec![(Vec::new(), limit)];
                    let moving = (0..tangents).filter(|&t| figures[t] > 0.0);
                    cone.extend(moving.map(|t| (vec![(row(t), -1.0 / figures[t])], 0.0)));
                    program.in_cone(cone);
                }
                (figures, vec![(pair, -most)])
            }
            _ => (bounds(law, 0.0).unwrap_or([0.0; 2]), Vec::new()),
        };
        let constant = if radius.is_empty() { 1.0 } else { 0.0 };
        let mut cone = vec![(radius, constant)];
        for (t, figure) in figures.into_iter().enumerate().take(tangents) {
            if figure > 0.0 {
                cone.push((vec![(row(t), -1.0 / figure)], 0.0));
            } else {
                program.equal((vec![(row(t), 1.0)], 0.0));
            }
        }
        if cone.len() > 1 {
            program.in_cone(cone);
        }
    }
    let left = program.minimise()?.objective;
    if left <= BALANCED {
        Ok(true)
    } else if left >= UNBALANCED {
        Ok(false)
    } else {
        Err(format!("{left:.0e} of the load is left unbalanced"))
    }
}
