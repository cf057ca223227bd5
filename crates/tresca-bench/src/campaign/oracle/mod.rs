//! What is true of a problem, found without the solver.

mod conditions;
mod conic;
mod gauss_seidel;
mod program;
mod statics;
mod ties;

pub use conditions::{Conditions, residual};
pub use gauss_seidel::sweep;

use super::problem::Problem;
use conic::Feasible;

/// What is true of a problem.
#[derive(Debug, Clone)]
pub enum Truth {
    /// It has a solution; the smallest energy, and displacements of it.
    Solution {
        /// Of these displacements.
        energy: f64,
        /// u.
        displacement: Vec<f64>,
    },
    /// With Coulomb's law: nothing in the way of a solution was found. An answer has to meet the conditions.
    Conditions,
    /// It has none.
    None {
        /// No displacement meets the constraints.
        infeasible: bool,
        /// No contact forces balance the load on what floats.
        unbalanced: bool,
    },
    /// The oracle cannot say, for this reason.
    Unknown(String),
}

impl Truth {
    /// In words.
    pub fn name(&self) -> String {
        match self {
            Truth::Solution { energy, .. } => format!("solution of energy {energy:.6e}"),
            Truth::Conditions => "Coulomb's conditions can be met".into(),
            Truth::None {
                infeasible,
                unbalanced,
            } => match (infeasible, unbalanced) {
                (true, true) => "infeasible, and no equilibrium".into(),
                (true, false) => "infeasible".into(),
                _ => "no equilibrium".into(),
            },
            Truth::Unknown(why) => format!("undecided: {why}"),
        }
    }
}

/// Asks the oracles.
pub fn truth(problem: &Problem) -> Truth {
    let (feasible, balanced) = (conic::feasible(problem), statics::is_balanced(problem));
    match (&feasible, &balanced) {
        (Feasible::Unclear(why), _) | (_, Err(why)) => return Truth::Unknown(why.clone()),
        _ => {}
    }
    let (Feasible::Yes(reduced), Ok(true)) = (&feasible, &balanced) else {
        return Truth::None {
            infeasible: matches!(feasible, Feasible::No),
            unbalanced: balanced == Ok(false),
        };
    };
    if problem.is_coulomb() {
        return Truth::Conditions;
    }
    match reduced.minimise(problem) {
        Ok(displacement) => Truth::Solution {
            energy: problem.energy(&displacement),
            displacement,
        },
        Err(why) => Truth::Unknown(why),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::campaign::dense::Rows;
    use tresca::algebraic::PairLaw;

    /// One dof on a spring of stiffness 2, rows ±1.
    fn spring(rows: &[(f64, f64, PairLaw)], load: f64) -> Problem {
        Problem {
            tangents: 1,
            stiffness: vec![vec![vec![2.0]]],
            normal: rows.iter().map(|row| vec![row.0]).collect(),
            tangential: rows.iter().map(|_| vec![0.0]).collect(),
            load: vec![load],
            gap: rows.iter().map(|row| row.1).collect(),
            origin: vec![0.0; rows.len()],
            laws: rows.iter().map(|row| row.2).collect(),
        }
    }

    fn solution(problem: &Problem) -> (f64, Vec<f64>) {
        match truth(problem) {
            Truth::Solution {
                energy,
                displacement,
            } => (energy, displacement),
            other => panic!("{}", other.name()),
        }
    }

    #[test]
    fn a_wall_with_and_without_touch() {
        for (gap, u) in [(1.0, 1.0), (2.0, 1.5), (-1.0, -1.0)] {
            let (energy, found) = solution(&spring(&[(1.0, gap, PairLaw::Frictionless)], 3.0));
            assert!((found[0] - u).abs() < 1e-7, "gap {gap}: {found:?}");
            assert!((energy - (u * u - 3.0 * u)).abs() < 1e-7);
        }
    }

    #[test]
    fn friction_takes_its_bound() {
        // Pulled by 3 along a wall that is held off: u = (3 − g)/2, 0 from g = 3 on.
        for (bound, u) in [(0.0, 1.5), (1.0, 1.0), (4.0, 0.0)] {
            let mut problem = spring(&[(0.0, 1.0, PairLaw::tresca(bound))], 3.0);
            problem.tangential = vec![vec![1.0]];
            let (energy, found) = solution(&problem);
            assert!((found[0] - u).abs() < 1e-6, "bound {bound}: {found:?}");
            assert!((energy - (u * u - 3.0 * u + bound * u)).abs() < 1e-8);
            // The same as slip that counts from 1.
            problem.origin = vec![1.0];
            problem.load = vec![5.0];
            assert!((solution(&problem).1[0] - 1.0 - u).abs() < 1e-6);
        }
    }

    #[test]
    fn an_ellipse_in_space() {
        let identity: Rows = (0..3)
            .map(|i| (0..3).map(|j| f64::from(u8::from(i == j))).collect())
            .collect();
        let problem = Problem {
            tangents: 2,
            stiffness: vec![identity.clone()],
            normal: vec![identity[0].clone()],
            tangential: identity[1..].to_vec(),
            load: vec![1.0, 3.0, 0.0],
            gap: vec![0.0],
            origin: vec![0.0; 2],
            laws: vec![PairLaw::Orthotropic { bounds: [2.0, 0.5] }],
        };
        let (energy, u) = solution(&problem);
        assert!((u[1] - 1.0).abs() < 1e-6 && u[0].abs() < 1e-7 && u[2].abs() < 1e-6);
        assert!((energy + 0.5).abs() < 1e-8);
    }

    #[test]
    fn contradictions_are_seen() {
        let tie = PairLaw::Bilateral { bound: 0.0 };
        let free = PairLaw::Frictionless;
        let is_infeasible = |rows: &[(f64, f64, PairLaw)]| {
            let found = truth(&spring(rows, 1.0));
            matches!(
                found,
                Truth::None {
                    infeasible: true,
                    unbalanced: false
                }
            )
        };
        assert!(is_infeasible(&[(1.0, 0.2, tie), (1.0, -0.94, tie)]));
        assert!(is_infeasible(&[(1.0, -0.2, free), (-1.0, 0.1, free)]));
        assert!(is_infeasible(&[
            (1.0, 0.2, tie),
            (-1.0, -0.3, PairLaw::coulomb(0.3))
        ]));
        assert!(!is_infeasible(&[(1.0, -0.2, free), (-1.0, 0.2, free)]));
        assert!(!is_infeasible(&[
            (1.0, 0.2, tie),
            (1.0, 0.2, tie),
            (2.0, 0.4, free)
        ]));
    }

    #[test]
    fn what_floats_is_balanced_or_not() {
        // A mass on nothing but a wall, friction and a tie along it.
        let floats = |law: PairLaw, load: [f64; 2]| {
            let problem = Problem {
                tangents: 1,
                stiffness: vec![vec![
                    vec![1.0, -1.0, 0.0, 0.0],
                    vec![-1.0, 1.0, 0.0, 0.0],
                    vec![0.0, 0.0, 1.0, -1.0],
                    vec![0.0, 0.0, -1.0, 1.0],
                ]],
                normal: vec![vec![1.0, 0.0, 0.0, 0.0]],
                tangential: vec![vec![0.0, 0.0, 1.0, 0.0]],
                load: vec![0.0, load[0], 0.0, load[1]],
                gap: vec![0.5],
                origin: vec![0.0],
                laws: vec![law],
            };
            let swept = sweep(&problem);
            match truth(&problem) {
                Truth::None {
                    infeasible: false,
                    unbalanced: true,
                } => {
                    assert!(swept.is_none());
                    None
                }
                Truth::Solution { displacement, .. } => Some(displacement),
                Truth::Conditions => {
                    let lambda = swept.unwrap();
                    assert!((lambda[0] - load[0]).abs() < 1e-5);
                    assert!((lambda[1] - load[1]).abs() < 1e-5);
                    Some(Vec::new())
                }
                other => panic!("{}", other.name()),
            }
        };
        let u = floats(PairLaw::tresca(0.4), [1.0, 0.3]).unwrap();
        assert!((u[0] - 0.5).abs() < 1e-6 && (u[1] - 1.5).abs() < 1e-6);
        assert!((u[3] - 0.3).abs() < 1e-6);
        assert!(floats(PairLaw::tresca(0.4), [1.0, 0.5]).is_none());
        assert!(floats(PairLaw::tresca(0.4), [-1.0, 0.3]).is_none());
        assert!(floats(PairLaw::Tied, [-1.0, 7.0]).is_some());
        assert!(floats(PairLaw::coulomb(0.4), [1.0, 0.3]).is_some());
        assert!(floats(PairLaw::coulomb(0.4), [1.0, 0.5]).is_none());
        let limited = PairLaw::Coulomb {
            coefficients: [5.0; 2],
            limit: 0.2,
        };
        assert!(floats(limited, [1.0, 0.1]).is_some());
        assert!(floats(limited, [1.0, 0.3]).is_none());
    }

    /// The two contacts of which fixed points of the bounds go in circles: the first opens, the second slides.
    #[test]
    fn gauss_seidel_finds_what_fixed_points_miss() {
        let w = [
            [0.399, -0.348, -0.292, -0.011],
            [-0.348, 0.573, 0.166, 0.187],
            [-0.292, 0.166, 0.786, -0.565],
            [-0.011, 0.187, -0.565, 0.693],
        ];
        let q = [0.341, -1.42, -0.83, 1.623];
        let order = [0, 2, 1, 3];
        // K = W⁻¹ and B = 1: then A = W.
        let matrix: Rows = order
            .iter()
            .map(|&i| order.map(|j| w[i][j]).to_vec())
            .collect();
        let factor = crate::campaign::dense::Cholesky::new(&matrix).unwrap();
        let unit = |i: usize| {
            (0..4)
                .map(|j| f64::from(u8::from(i == j)))
                .collect::<Vec<_>>()
        };
        let k: Rows = (0..4).map(|i| factor.solve(&unit(i))).collect();
        let rhs: Vec<f64> = order.iter().map(|&i| -q[i]).collect();
        let problem = Problem {
            tangents: 1,
            load: crate::campaign::dense::product(&k, &rhs),
            stiffness: vec![k],
            normal: vec![unit(0), unit(1)],
            tangential: vec![unit(2), unit(3)],
            gap: vec![0.0; 2],
            origin: vec![0.0; 2],
            laws: vec![PairLaw::coulomb(0.7726), PairLaw::coulomb(1.4329)],
        };
        let lambda = sweep(&problem).unwrap();
        assert!(lambda[0].abs() < 1e-9 && lambda[2].abs() < 1e-9);
        assert!(lambda[1] > 0.1 && (lambda[3] + 1.4329 * lambda[1]).abs() < 1e-9);
    }
}
