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
