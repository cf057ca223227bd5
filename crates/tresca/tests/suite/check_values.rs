//! The two bricks at s = 16 against an independent implementation (double precision, solved to 1e-13);
//! the values stand in the problem's specification, not in any output of this project.

use tresca::{Engine, Method, Model, Outcome, PreparedModel, RunReport, Settings, Silent, prepare};
use tresca_bench::two_bricks::{Units, two_bricks};

const OBJECTIVE: f64 = -1.146_894_801_625_5e-3;
const NORMAL_FORCE_SUM: f64 = 2.052_944_860_7;
const LARGEST_SLIP: f64 = 1.985_77e-5;

fn model() -> Model {
    two_bricks(16, Units::METRE_MEGAPASCAL).unwrap()
}

fn prepared(model: &Model, engine: Engine) -> PreparedModel<'_> {
    let settings = Settings {
        engine,
        ..Settings::default()
    };
    prepare(model, &settings, &mut Silent).unwrap()
}

fn outcome(prepared: &mut PreparedModel<'_>, settings: &Settings) -> Outcome {
    prepared.solve(settings, &mut Silent).unwrap()
}

fn assert_check_values(outcome: &Outcome, relative: f64) {
    let name = format!(
        "{} {:?}",
        outcome.last().solution.method,
        outcome.description.engine.engine
    );
    assert!(
        outcome.converged(),
        "{name}: {}",
        outcome.last().solution.status
    );
    let report = RunReport::of_model(&two_bricks(16, Units::METRE_MEGAPASCAL).unwrap(), outcome);
    let (figures, contact) = (&report.last().figures, &report.last().contact);
    let close = |found: f64, expected: f64, relative: f64| {
        assert!(
            ((found - expected) / expected).abs() < relative,
            "{name}: found {found:.13e}, expected {expected:.13e}"
        );
    };
    close(figures.objective, OBJECTIVE, relative);
    close(contact.normal_force_sum, NORMAL_FORCE_SUM, relative);
    // Six digits are known of this one.
    close(contact.max_slip_component.unwrap(), LARGEST_SLIP, 3e-6);
    assert_eq!(
        (contact.pairs, contact.closed, contact.stick),
        (256, 116, 0),
        "{name}"
    );
    let below_the_bound = outcome.last().pairs().filter(|pair| pair.stick);
    assert_eq!(below_the_bound.count(), 64, "{name}");
    assert!(
        outcome
            .last()
            .pairs()
            .all(|pair| !(pair.closed && pair.stick)),
        "{name}: every closed pair slips"
    );
    assert!(
        outcome.last().certificate.worst() < 1e-7,
        "{name}: {:?}",
        outcome.last().certificate
    );
}

#[test]
fn every_method_finds_the_check_values_of_the_two_bricks() {
    let model = model();
    let mut prepared = prepared(&model, Engine::Explicit);
    for &method in Method::ALL {
        let settings = Settings {
            method,
            tolerance: 1e-10,
            max_iterations: 20_000,
            engine: Engine::Explicit,
            ..Settings::default()
        };
        let outcome = outcome(&mut prepared, &settings);
        assert_check_values(&outcome, 1e-9);
    }
}

#[test]
fn every_engine_finds_the_check_values_of_the_two_bricks() {
    for engine in [Engine::Factored, Engine::Condensed, Engine::Explicit] {
        let model = model();
        let mut prepared = prepared(&model, engine);
        let settings = Settings {
            tolerance: 1e-10,
            engine,
            ..Settings::default()
        };
        let outcome = outcome(&mut prepared, &settings);
        assert_check_values(&outcome, 1e-9);
        assert_eq!(outcome.description.engine.engine, engine);
    }
}

/// The target of the project at the smallest size; `tresca bench table1` prints it for all.
#[test]
fn grssn_stays_within_its_budget_of_multiplications() {
    let model = model();
    let mut prepared = prepared(&model, Engine::Condensed);
    let mut run = |method, tolerance| {
        let settings = Settings {
            method,
            tolerance,
            engine: Engine::Condensed,
            ..Settings::default()
        };
        let outcome = outcome(&mut prepared, &settings);
        outcome.last().solution.clone()
    };
    for (tolerance, steps, budget) in [(1e-6, 10, 100), (1e-10, 14, 220)] {
        let grssn = run(Method::Grssn, tolerance);
        let apgd = run(Method::Apgd, tolerance);
        assert!(
            grssn.figures.iterations <= steps
                && grssn.figures.n_a - grssn.figures.n_a_setup <= budget
        );
        assert!(
            10 * grssn.figures.n_a <= 6 * apgd.figures.n_a,
            "{} against {}",
            grssn.figures.n_a,
            apgd.figures.n_a
        );
    }
}
