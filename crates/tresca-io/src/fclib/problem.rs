//! The problems as plain data.

use crate::error::WriteError;
use crate::fclib::error::Defect;
use crate::fclib::matrix::FclibMatrix;

/// What a file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The problem.
    pub problem: FclibProblem,
    /// What its author says about it.
    pub info: Info,
    /// A solution that comes with it.
    pub solution: Option<State>,
    /// States to start from.
    pub guesses: Vec<State>,
}

/// A problem in one of its two forms.
#[derive(Clone, Debug, PartialEq)]
pub enum FclibProblem {
    /// Reduced to the contacts.
    Local(LocalProblem),
    /// With the velocities of the bodies.
    Global(GlobalProblem),
}

/// u = W r + q with friction coefficients μ.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalProblem {
    /// 2 or 3.
    pub dimension: usize,
    /// W, m × m with m = dimension × contacts; symmetric positive semidefinite up to rounding.
    pub w: FclibMatrix,
    /// q, length m.
    pub q: Vec<f64>,
    /// μ ≥ 0, one per contact.
    pub friction: Vec<f64>,
}

/// M v = H r + f, u = Hᵀ v + w with friction coefficients μ.
#[derive(Clone, Debug, PartialEq)]
pub struct GlobalProblem {
    /// 2 or 3.
    pub dimension: usize,
    /// M, n × n, symmetric positive definite.
    pub m: FclibMatrix,
    /// H, n × m with m = dimension × contacts.
    pub h: FclibMatrix,
    /// f, length n.
    pub f: Vec<f64>,
    /// w, length m.
    pub w: Vec<f64>,
    /// μ ≥ 0, one per contact.
    pub friction: Vec<f64>,
}

/// What the author of a problem says about it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Info {
    /// Title.
    pub title: Option<String>,
    /// Where it comes from, and what it models.
    pub description: Option<String>,
    /// What is known of existence, uniqueness and the like.
    pub math_info: Option<String>,
}

/// A solution or a guess.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// v, length n; of global problems alone.
    pub v: Option<Vec<f64>>,
    /// u, length m.
    pub u: Vec<f64>,
    /// r, length m.
    pub r: Vec<f64>,
}

impl FclibProblem {
    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        match self {
            FclibProblem::Local(problem) => problem.dimension,
            FclibProblem::Global(problem) => problem.dimension,
        }
    }

    /// μ, one per contact.
    pub fn friction(&self) -> &[f64] {
        match self {
            FclibProblem::Local(problem) => &problem.friction,
            FclibProblem::Global(problem) => &problem.friction,
        }
    }

    /// Number of contacts.
    pub fn contacts(&self) -> usize {
        self.friction().len()
    }

    /// Length m of r and u.
    pub fn unknowns(&self) -> usize {
        self.dimension() * self.contacts()
    }

    /// Length n of v; `None` for a local problem.
    pub fn velocities(&self) -> Option<usize> {
        match self {
            FclibProblem::Local(_) => None,
            FclibProblem::Global(problem) => Some(problem.f.len()),
        }
    }

    /// Checks that the parts fit together and are finite.
    ///
    /// # Errors
    /// The first part that does not fit, by its name in FCLIB (`W`, `q`, `mu` ...), and why.
    pub fn check(&self) -> Result<(), (&'static str, Defect)> {
        match self {
            FclibProblem::Local(problem) => {
                let unknowns = problem.w.rows();
                let contacts = contacts("W", unknowns, problem.dimension)?;
                shape("W", &problem.w, (unknowns, unknowns))?;
                vector("q", &problem.q, unknowns)?;
                coefficients(&problem.friction, contacts)
            }
            FclibProblem::Global(problem) => {
                let (order, unknowns) = (problem.m.rows(), problem.h.columns());
                let contacts = contacts("H", unknowns, problem.dimension)?;
                shape("M", &problem.m, (order, order))?;
                shape("H", &problem.h, (order, unknowns))?;
                vector("f", &problem.f, order)?;
                vector("w", &problem.w, unknowns)?;
                coefficients(&problem.friction, contacts)
            }
        }
    }
}

impl Document {
    /// Checks the problem and the states that come with it.
    ///
    /// # Errors
    /// The first part that does not fit, by its name in FCLIB, and why.
    pub fn check(&self) -> Result<(), (String, Defect)> {
        let problem = &self.problem;
        problem
            .check()
            .map_err(|(part, defect)| (part.to_owned(), defect))?;
        if let Some(solution) = &self.solution {
            solution.check("solution", problem)?;
        }
        let mut guesses = self.guesses.iter().enumerate();
        guesses.try_for_each(|(i, guess)| guess.check(&format!("guesses/{}", i + 1), problem))
    }

    /// The same before writing.
    pub(super) fn writable(&self) -> Result<(), WriteError> {
        self.check()
            .map_err(|(part, defect)| WriteError::Problem { part, defect })
    }
}

impl From<FclibProblem> for Document {
    fn from(problem: FclibProblem) -> Self {
        Self {
            problem,
            info: Info::default(),
            solution: None,
            guesses: Vec::new(),
        }
    }
}

impl State {
    /// Checks a state of a problem; `name` calls it.
    fn check(&self, name: &str, problem: &FclibProblem) -> Result<(), (String, Defect)> {
        let check = |part: &str, values: &[f64], expected| {
            finite(values, expected).map_err(|defect| (format!("{name}/{part}"), defect))
        };
        check("u", &self.u, problem.unknowns())?;
        check("r", &self.r, problem.unknowns())?;
        match (&self.v, problem.velocities()) {
            (Some(v), Some(expected)) => check("v", v, expected),
            _ => Ok(()),
        }
    }
}

/// Whether this is a dimension.
pub(super) fn dimension(found: i64) -> Result<usize, Defect> {
    match found {
        2 => Ok(2),
        3 => Ok(3),
        other => Err(Defect::Dimension(other)),
    }
}

type Part = (&'static str, Defect);

fn contacts(name: &'static str, rows: usize, dimension: usize) -> Result<usize, Part> {
    let number = self::dimension(i64::try_from(dimension).unwrap_or(i64::MAX));
    let dimension = number.map_err(|defect| ("spacedim", defect))?;
    if rows.is_multiple_of(dimension) {
        Ok(rows / dimension)
    } else {
        Err((name, Defect::Contacts { rows, dimension }))
    }
}

fn shape(name: &'static str, matrix: &FclibMatrix, expected: (usize, usize)) -> Result<(), Part> {
    let found = (matrix.rows(), matrix.columns());
    if found == expected {
        Ok(())
    } else {
        Err((name, Defect::Shape { expected, found }))
    }
}

fn vector(name: &'static str, values: &[f64], expected: usize) -> Result<(), Part> {
    finite(values, expected).map_err(|defect| (name, defect))
}

fn coefficients(friction: &[f64], contacts: usize) -> Result<(), Part> {
    vector("mu", friction, contacts)?;
    match friction.iter().position(|&mu| mu < 0.0) {
        None => Ok(()),
        Some(contact) => {
            let value = friction[contact];
            Err(("mu", Defect::Coefficient { contact, value }))
        }
    }
}

fn finite(values: &[f64], expected: usize) -> Result<(), Defect> {
    if values.len() != expected {
        return Err(Defect::Length {
            expected,
            found: values.len(),
        });
    }
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(Defect::NotFinite {
            index,
            value: values[index],
        }),
    }
}
