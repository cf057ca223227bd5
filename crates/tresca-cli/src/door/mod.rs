//! The doors of `tresca solve`: a case file, matrices, a problem of FCLIB or Siconos. Each knows how its input is
//! read, shown, solved and written; all the rest of a run is the same (`commands::solve`).

mod case;
pub mod fclib;
mod finished;
mod matrices;

use miette::miette;
use tresca::{Settings, Status};

use self::finished::Finished;
use crate::args::SolveArguments;
use crate::terminal::monitor::Monitor;

/// A problem, read and checked.
pub enum Door {
    /// A model.
    Case(case::Case),
    /// K, N, T, f.
    Matrices(matrices::Matrices),
    /// W, q, μ, or a global problem.
    Fclib(fclib::Fclib),
}

impl Door {
    /// Reads what the command line names.
    pub fn load(arguments: &SolveArguments) -> miette::Result<Self> {
        let path = &arguments.case;
        if fclib::is_problem(path) {
            return fclib::Fclib::load(arguments).map(Door::Fclib);
        }
        if arguments.law.is_some() || arguments.bound.is_some() {
            return Err(miette!(
                "--law and --bound are for problems of FCLIB and Siconos; others have their own laws"
            ));
        }
        if matrices::is_problem(path) {
            return matrices::Matrices::load(path).map(Door::Matrices);
        }
        case::Case::load(path).map(Door::Case)
    }

    /// The settings that come with the problem.
    pub fn settings(&self) -> Settings {
        match self {
            Door::Case(case) => case.settings().clone(),
            Door::Matrices(_) | Door::Fclib(_) => Settings::default(),
        }
    }

    /// What is going to be solved, in a line or two.
    pub fn describe(&self) -> String {
        match self {
            Door::Case(case) => case.describe(),
            Door::Matrices(matrices) => matrices.describe(),
            Door::Fclib(fclib) => fclib.describe(),
        }
    }

    /// Solves; nothing comes back from a run that was stopped before it began to iterate.
    pub fn solve(
        &self,
        settings: &Settings,
        monitor: &mut Monitor,
    ) -> miette::Result<Option<Finished<'_>>> {
        let solved = match self {
            Door::Case(case) => case.solve(settings, monitor),
            Door::Matrices(matrices) => matrices.solve(settings, monitor),
            Door::Fclib(fclib) => fclib.solve(settings, monitor),
        };
        Ok(solved?.filter(|solved| solved.iterations > 0 || solved.status != Status::Interrupted))
    }
}
