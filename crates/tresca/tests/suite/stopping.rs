//! A run that is stopped ends alike behind every door: before the first iteration there is no result, later there
//! is one, marked as interrupted.

use std::ops::ControlFlow;

use tresca::algebraic::{self, AlgebraicError, Assembly};
use tresca::fclib::{self, FclibProblemError};
use tresca::{
    FrictionLaw, IterationRecord, Method, Model, Progress, Settings, SolveError, Stage, Status,
    Stopped,
};
use tresca_bench::two_bricks::{Units, two_bricks_with};

struct Stop {
    at: Option<Stage>,
    after: usize,
}

impl Progress for Stop {
    fn stage(&mut self, stage: Stage) -> ControlFlow<()> {
        match self.at == Some(stage) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }

    fn iteration(&mut self, record: &IterationRecord) -> ControlFlow<()> {
        match record.iteration >= self.after {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }
}

fn settings() -> Settings {
    Settings {
        method: Method::Gimssn,
        tolerance: 1e-12,
        ..Settings::default()
    }
}

fn model() -> Model {
    two_bricks_with(4, Units::METRE_MEGAPASCAL, FrictionLaw::coulomb(0.3)).unwrap()
}

/// Status and iterations of a run behind each door, or where it was stopped.
type End = Result<(Status, usize), Stopped>;

fn case(stop: &mut Stop) -> End {
    match tresca::solve_with(&model(), &settings(), stop) {
        Ok(outcome) => Ok((outcome.status(), outcome.last().solution.figures.iterations)),
        Err(SolveError::Stopped(stopped)) => Err(stopped),
        Err(error) => panic!("{error}"),
    }
}

fn matrices(stop: &mut Stop) -> End {
    let model = model();
    let assembly = Assembly::new(&model, &model.whole_step()).unwrap();
    match algebraic::solve(&assembly.problem, &settings(), stop) {
        Ok(solution) => Ok((solution.status, solution.figures.iterations)),
        Err(AlgebraicError::Stopped(stopped)) => Err(stopped),
        Err(error) => panic!("{error}"),
    }
}

fn foreign(stop: &mut Stop) -> End {
    let model = model();
    let mut prepared = tresca::prepare(&model, &settings(), &mut tresca::Silent).unwrap();
    // Solving it poses the loads.
    prepared.solve(&settings(), &mut tresca::Silent).unwrap();
    let local = fclib::local_problem(prepared.system().dual()).unwrap();
    let problem = fclib::FclibProblem::Local(local);
    match fclib::solve(&problem, fclib::FclibLaw::Coulomb, &settings(), stop) {
        Ok(outcome) => Ok((outcome.solution.status, outcome.solution.figures.iterations)),
        Err(FclibProblemError::Stopped(stopped)) => Err(stopped),
        Err(error) => panic!("{error}"),
    }
}

type Door = fn(&mut Stop) -> End;

const DOORS: [(&str, Door); 3] = [("case", case), ("matrices", matrices), ("fclib", foreign)];

#[test]
fn a_run_that_is_stopped_before_its_first_iteration_has_no_result() {
    for (door, solve) in DOORS {
        for stage in [Stage::Assembly, Stage::Factorization, Stage::Solve] {
            // A dual problem as such has nothing to factor.
            if (door, stage) == ("fclib", Stage::Factorization) {
                continue;
            }
            let mut stop = Stop {
                at: Some(stage),
                after: usize::MAX,
            };
            assert_eq!(solve(&mut stop), Err(Stopped(stage)), "{door}");
        }
    }
}

#[test]
fn a_run_that_is_stopped_later_gives_what_it_has() {
    for (door, solve) in DOORS {
        let mut stop = Stop { at: None, after: 3 };
        assert_eq!(solve(&mut stop), Ok((Status::Interrupted, 3)), "{door}");
        // Once there is a result, recovery is not interrupted.
        let mut stop = Stop {
            at: Some(Stage::Recovery),
            after: usize::MAX,
        };
        let (status, _) = solve(&mut stop).unwrap();
        assert_eq!(status, Status::Converged, "{door}");
    }
}
