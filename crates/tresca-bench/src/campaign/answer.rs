//! The solver's answer to a problem that was drawn.

use std::panic::{AssertUnwindSafe, catch_unwind};

use tresca::algebraic::{self, Dual, Matrix, Operator, Solution};
use tresca::{IterationRecord, Silent, Status};

use super::dense::Rows;
use super::problem::{Drawn, Form};

/// What came back.
#[derive(Debug, Clone)]
pub struct Answer {
    /// How the run ended.
    pub end: End,
    /// u in the units of the truth; empty for the dual form.
    pub displacement: Vec<f64>,
    /// λ = [λν; λτ] in the units of the truth.
    pub forces: Vec<f64>,
    /// n_A.
    pub multiplications: usize,
    /// The worst figure of the certificate.
    pub certificate: f64,
    /// The iterations.
    pub records: Vec<IterationRecord>,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// With a status.
    Status(Status),
    /// The input was refused.
    Refused(String),
    /// It panicked.
    Panicked,
}

impl End {
    /// In a word.
    pub fn name(&self) -> &str {
        match self {
            End::Status(status) => status.name(),
            End::Refused(_) => "refused",
            End::Panicked => "panicked",
        }
    }
}

/// Asks the solver.
pub fn answer(drawn: &Drawn) -> Answer {
    let nothing = |end| Answer {
        end,
        displacement: Vec::new(),
        forces: Vec::new(),
        multiplications: 0,
        certificate: f64::NAN,
        records: Vec::new(),
    };
    match catch_unwind(AssertUnwindSafe(|| solution(drawn))) {
        Err(_) => nothing(End::Panicked),
        Ok(Err(error)) => nothing(End::Refused(error)),
        Ok(Ok(solution)) => in_own_units(drawn, solution),
    }
}

fn in_own_units(drawn: &Drawn, solution: Solution) -> Answer {
    let units = &drawn.units;
    let force = units.of_stiffness() * units.of_length();
    let forces = [&solution.normal_force[..], &solution.tangential_force].concat();
    let rows = units.of_rows(drawn.truth.tangents);
    Answer {
        end: End::Status(solution.status),
        displacement: solution
            .displacement
            .iter()
            .map(|u| u / units.of_length())
            .collect(),
        forces: forces
            .iter()
            .zip(rows)
            .map(|(force_there, row)| force_there * row / force)
            .collect(),
        multiplications: solution.figures.n_a,
        certificate: solution.certificate.worst(),
        records: solution.records,
    }
}

fn matrix(rows: &Rows, columns: usize) -> Result<Matrix, String> {
    Matrix::from_dense((rows.len(), columns), &rows.concat()).map_err(|error| error.to_string())
}

fn solution(drawn: &Drawn) -> Result<Solution, String> {
    match drawn.form {
        Form::Primal => primal(drawn),
        Form::Dual => dual(drawn),
    }
}

fn primal(drawn: &Drawn) -> Result<Solution, String> {
    let problem = drawn.units.of(drawn.posed());
    let n = problem.dofs();
    let blocks = problem
        .stiffness
        .iter()
        .map(|block| matrix(block, block.len()))
        .collect::<Result<Vec<_>, _>>()?;
    let mut asked =
        algebraic::MatrixProblem::new(blocks, matrix(&problem.normal, n)?, problem.load)
            .with_gap(problem.gap)
            .with_friction(problem.laws);
    if problem.tangents > 0 {
        asked = asked
            .with_tangential(matrix(&problem.tangential, n)?)
            .with_previous_slip(problem.origin);
    }
    algebraic::solve(&asked, &drawn.settings, &mut Silent).map_err(|error| error.to_string())
}

fn dual(drawn: &Drawn) -> Result<Solution, String> {
    let problem = drawn.posed();
    let form = problem.dual().ok_or("a floating body has no dual form")?;
    let (k, l) = (drawn.units.of_stiffness(), drawn.units.of_length());
    let rows = drawn.units.of_rows(problem.tangents);
    let order = rows.len();
    let entries: Vec<f64> = (0..order * order)
        .map(|at| {
            let (i, j) = (at / order, at % order);
            form.matrix[i.max(j)][i.min(j)] * (rows[i] * (rows[j] / k))
        })
        .collect();
    let rhs = form.rhs.iter().zip(&rows).map(|(b, r)| b * r * l).collect();
    let operator = Operator::dense(order, &entries).map_err(|error| error.to_string())?;
    let laws = drawn.units.of(problem).laws;
    let asked = Dual::new(operator, rhs, problem.tangents, laws);
    algebraic::solve_dual(asked, &drawn.settings, &mut Silent).map_err(|error| error.to_string())
}
