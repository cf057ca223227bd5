//! The published table of the two bricks beside ours.
//!
//! Iterations and multiplications by A of IMSSN and SSN at the settings that come closest to the paper's, of the
//! projected gradient and of GRSSN. The search for the settings is described in `docs/reproduction.md`.

use tresca::{Engine, InnerSolver, Method, Model, Outcome, Settings, Status};

use crate::BenchError;
use crate::trial::{Trial, Watch};

/// Iterations of the method, and multiplications by A without those of the estimate of σmax.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    /// Newton or gradient steps.
    pub iterations: usize,
    /// n_A.
    pub multiplications: usize,
}

impl Counts {
    const fn new(iterations: usize, multiplications: usize) -> Self {
        Self {
            iterations,
            multiplications,
        }
    }

    /// Of the last load step.
    pub fn of(outcome: &Outcome) -> Self {
        let solution = &outcome.last().solution;
        Self::new(
            solution.figures.iterations,
            solution.figures.n_a - solution.figures.n_a_setup,
        )
    }
}

/// A row of the founding paper's Table 1 (ε, ρ and the inner tolerances are not stated there).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Published {
    /// Nodes per edge of each brick.
    pub s: usize,
    /// With adaptive precision.
    pub imssn: Counts,
    /// With BiCGSTAB to full accuracy.
    pub ssn: Counts,
}

const fn published(s: usize, imssn: (usize, usize), ssn: (usize, usize)) -> Published {
    Published {
        s,
        imssn: Counts::new(imssn.0, imssn.1),
        ssn: Counts::new(ssn.0, ssn.1),
    }
}

/// The table as printed.
pub const PUBLISHED: [Published; 6] = [
    published(16, (10, 161), (9, 1180)),
    published(21, (9, 143), (9, 1428)),
    published(26, (10, 185), (11, 2506)),
    published(31, (10, 190), (10, 2162)),
    published(36, (9, 167), (10, 2298)),
    published(41, (10, 216), (10, 2586)),
];

/// What is run at every size.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Tolerances of GRSSN and of the projected gradient, one at least; the timed run has the first.
    pub tolerances: Vec<f64>,
    /// Tolerance of IMSSN and SSN.
    pub paper_tolerance: f64,
    /// How A is applied.
    pub engine: Engine,
    /// Leave out all but GRSSN.
    pub grssn_only: bool,
}

impl Default for Plan {
    /// What the documentation quotes.
    fn default() -> Self {
        Self {
            tolerances: vec![1e-6, 1e-10],
            paper_tolerance: 1e-4,
            engine: Engine::Condensed,
            grssn_only: false,
        }
    }
}

/// One line of our table.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Row {
    /// The method.
    pub method: Method,
    /// Asked of the relative reduced gradient.
    pub tolerance: f64,
    /// What it took.
    pub counts: Counts,
    /// Multiplications of the estimate of σmax.
    pub setup: usize,
    /// How it ended.
    pub status: Status,
    /// Seconds of the dual solve.
    pub seconds: f64,
    /// What the paper prints.
    pub published: Option<Counts>,
}

impl Plan {
    /// The settings at which the counts of IMSSN and SSN come closest to the published ones; the others run with
    /// the defaults.
    pub fn paper_settings(&self, method: Method) -> Settings {
        let common = Settings {
            method,
            tolerance: self.paper_tolerance,
            engine: self.engine,
            inner_solver: InnerSolver::Iterative,
            ..Settings::default()
        };
        match method {
            Method::Imssn => Settings {
                rho: 5.0,
                r_tol: 0.01,
                c_fact: 0.1,
                inner_tolerance: 1e-8,
                ..common
            },
            // To full accuracy: 1e-10 for a tolerance of 1e-4.
            Method::Ssn => Settings {
                rho: 1.0,
                inner_tolerance: 1e-6,
                ..common
            },
            _ => common,
        }
    }

    fn grssn_settings(&self, tolerance: f64) -> Settings {
        Settings {
            tolerance,
            engine: self.engine,
            ..Settings::default()
        }
    }

    /// Takes the bricks, [`two_bricks`](crate::two_bricks::two_bricks), the whole way by GRSSN.
    ///
    /// # Errors
    /// Without a tolerance, or when a setting is out of range.
    pub fn trial<'a>(&self, model: &'a Model) -> Result<Trial<'a>, BenchError> {
        let first = *self.tolerances.first().ok_or(BenchError::NoTolerance)?;
        Trial::run(
            Watch::start(),
            "two-bricks",
            model,
            &self.grssn_settings(first),
        )
    }

    /// The rows of size s one after another, that of the timed run among them. Each is made when it is asked for.
    pub fn rows(
        &self,
        s: usize,
        trial: &mut Trial<'_>,
    ) -> impl Iterator<Item = Result<Row, BenchError>> {
        let published = PUBLISHED.iter().find(|row| row.s == s);
        let mut solves = Vec::new();
        if !self.grssn_only {
            solves.extend([Method::Imssn, Method::Ssn].map(|method| self.paper_settings(method)));
            solves.extend(self.tolerances.iter().map(|&tolerance| Settings {
                tolerance,
                ..self.paper_settings(Method::Apgd)
            }));
        }
        solves.extend(self.tolerances.iter().map(|&t| self.grssn_settings(t)));
        solves.into_iter().map(move |settings| {
            let theirs = published.and_then(|row| match settings.method {
                Method::Imssn => Some(row.imssn),
                Method::Ssn => Some(row.ssn),
                _ => None,
            });
            if settings == trial.first().settings {
                return Ok(Row::new(trial.first(), theirs));
            }
            Ok(Row::new(&trial.again(&settings)?, theirs))
        })
    }
}

impl Row {
    fn new(outcome: &Outcome, published: Option<Counts>) -> Self {
        let solution = &outcome.last().solution;
        Self {
            method: solution.method,
            tolerance: outcome.settings.tolerance,
            counts: Counts::of(outcome),
            setup: solution.figures.n_a_setup,
            status: solution.status,
            seconds: outcome.times.solve,
            published,
        }
    }
}
