//! How far forces and velocities are from solving a problem.

use serde::Serialize;
use tresca_io::fclib::FclibProblem;
use tresca_la::vector::{dot, norm};

use super::law::FclibLaw;
use super::reduced::{Reduced, place};

/// Residuals of the natural map r − P_K(r − ρ û), K the product of the friction cones and
/// û = u + μ‖u_T‖ n (De Saxcé); with Tresca's law K is the product of half-lines and discs and û = u.
/// Zero exactly at a solution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Residuals {
    /// With ρ = 1, relative to ‖q‖ (absolute where q = 0), as Siconos measures; depends on units.
    pub siconos: f64,
    /// With ρ = 1/max W_ii, relative to the larger one of ‖r‖ and ρ‖q‖: does not depend on units.
    pub scaled: f64,
    /// The same with u = ½(W + Wᵀ) r + q, the problem that the solver had. The two differ by as much
    /// as W lacks in symmetry.
    pub symmetrised: f64,
}

impl Residuals {
    pub(super) fn new(
        problem: &FclibProblem,
        law: FclibLaw,
        reduced: &Reduced,
        forces: &[f64],
        velocities: &[f64],
    ) -> Self {
        let order = forces.len();
        let stiffest = (0..order).map(|i| reduced.w[(order + 1) * i]);
        let stiffest = stiffest.fold(0.0, f64::max);
        let rho = if stiffest > 0.0 { 1.0 / stiffest } else { 1.0 };
        let load = norm(&reduced.q);
        let reference = norm(forces).max(rho * load);
        let relative = |value: f64, to: f64| if to > 0.0 { value / to } else { value };
        let place = |i| place(problem.dimension(), problem.contacts(), i);
        let own: Vec<f64> = (0..order).map(|i| forces[place(i)]).collect();
        let mut symmetric = vec![0.0; order];
        for (i, (row, q)) in reduced
            .w
            .chunks_exact(order.max(1))
            .zip(&reduced.q)
            .enumerate()
        {
            symmetric[place(i)] = dot(row, &own) + q;
        }
        let map = |velocities: &[f64], rho| natural_map(problem, law, forces, velocities, rho);
        Self {
            siconos: relative(map(velocities, 1.0), load),
            scaled: relative(map(velocities, rho), reference),
            symmetrised: relative(map(&symmetric, rho), reference),
        }
    }
}

/// ‖r − P_K(r − ρ û)‖.
fn natural_map(
    problem: &FclibProblem,
    law: FclibLaw,
    forces: &[f64],
    velocities: &[f64],
    rho: f64,
) -> f64 {
    let dimension = problem.dimension();
    let contacts = forces
        .chunks(dimension)
        .zip(velocities.chunks(dimension))
        .zip(problem.friction());
    let mut sum = 0.0;
    for ((r, u), &friction) in contacts {
        let shift = match law {
            FclibLaw::Coulomb => friction * norm(&u[1..]),
            FclibLaw::Tresca { .. } => 0.0,
        };
        let mut y: Vec<f64> = r.iter().zip(u).map(|(r, u)| r - rho * u).collect();
        y[0] -= rho * shift;
        match law {
            FclibLaw::Coulomb => project_on_cone(&mut y, friction),
            FclibLaw::Tresca { bound } => project_on_cylinder(&mut y, bound),
        }
        sum += r.iter().zip(&y).map(|(r, y)| (r - y).powi(2)).sum::<f64>();
    }
    sum.sqrt()
}

/// y ← the nearest point of {‖y_T‖ ≤ μ y_N}.
fn project_on_cone(y: &mut [f64], friction: f64) {
    let (normal, size) = (y[0], norm(&y[1..]));
    if size <= friction * normal {
        return;
    }
    if friction * size <= -normal {
        y.fill(0.0);
        return;
    }
    y[0] = (normal + friction * size) / (1.0 + friction * friction);
    let scale = friction * y[0] / size;
    y[1..].iter_mut().for_each(|t| *t *= scale);
}

/// y ← the nearest point of {y_N ≥ 0, ‖y_T‖ ≤ g}.
fn project_on_cylinder(y: &mut [f64], bound: f64) {
    y[0] = y[0].max(0.0);
    let size = norm(&y[1..]);
    if size > bound {
        y[1..].iter_mut().for_each(|t| *t *= bound / size);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_cone(y: [f64; 3], friction: f64) -> Vec<f64> {
        let mut y = y.to_vec();
        project_on_cone(&mut y, friction);
        y
    }

    #[test]
    fn the_cone_its_polar_and_what_lies_between() {
        assert_eq!(on_cone([1.0, 0.3, 0.4], 0.5), [1.0, 0.3, 0.4]);
        // The polar of {‖t‖ ≤ μ n} is {μ‖t‖ ≤ −n}.
        assert_eq!(on_cone([-1.0, 0.6, 0.8], 1.0), [0.0; 3]);
        // In the plane of (n, t) = (0, 1) the ray of μ = 1 is nearest at (½, ½).
        assert_eq!(on_cone([0.0, 1.0, 0.0], 1.0), [0.5, 0.5, 0.0]);
        // Without friction the cone is a half-line.
        assert_eq!(on_cone([2.0, 3.0, 4.0], 0.0), [2.0, 0.0, 0.0]);
        assert_eq!(on_cone([-2.0, 3.0, 4.0], 0.0), [0.0; 3]);
    }
}
