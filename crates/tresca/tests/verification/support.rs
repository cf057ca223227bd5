//! Reading and solving the cases.

use std::path::{Path, PathBuf};
use tresca::case::Case;
use tresca::{Outcome, Settings, Silent};

pub fn directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

/// A case of `cases/` with some parts of its text exchanged; each must be there.
pub fn variant(name: &str, exchange: &[(&str, &str)]) -> Case {
    let path = directory().join(name);
    let mut text = std::fs::read_to_string(&path).unwrap();
    for (from, to) in exchange {
        assert!(text.contains(from), "{name} does not contain `{from}`");
        text = text.replace(from, to);
    }
    Case::parse(&path.display().to_string(), &text).unwrap_or_else(|error| panic!("{error}"))
}

pub fn run(case: &Case, settings: &Settings) -> Outcome {
    tresca::solve_with(&case.model, settings, &mut Silent)
        .unwrap_or_else(|error| panic!("{}: {error}", case.model.title()))
}

/// Solves, and demands convergence and a clean certificate.
pub fn solved_with(case: &Case, settings: &Settings) -> Outcome {
    let outcome = run(case, settings);
    let title = case.model.title();
    assert!(outcome.converged(), "{title}: {}", outcome.status());
    for step in &outcome.steps {
        // Coulomb bounds are met to their own tolerance, and energies square what forces do not.
        let worst = step.certificate.worst();
        assert!(
            worst < 1e-5,
            "{title}, step {}: {:#?}",
            step.number,
            step.certificate
        );
    }
    outcome
}

pub fn solved(case: &Case) -> Outcome {
    solved_with(case, case.settings())
}

pub fn settings(case: &Case, change: impl FnOnce(&mut Settings)) -> Settings {
    let mut settings = case.settings().clone();
    change(&mut settings);
    settings
}

/// A figure for `docs/verification.md`, seen with `-- --nocapture`.
#[expect(clippy::print_stdout, reason = "tests report, libraries do not")]
pub fn report(line: &str) {
    println!("    {line}");
}

/// Numbers with two digits.
pub fn digits(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| format!("{value:.1e}")).collect();
    texts.join(", ")
}

#[track_caller]
pub fn assert_close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "found {found:.10e}, expected {expected:.10e}"
    );
}

/// Σ λν and Σ λτ (global components, force of the slave on the master) of a contact of a step.
pub fn resultant(outcome: &Outcome, step: usize, contact: usize) -> (f64, [f64; 3]) {
    let pairs = &outcome.steps[step].contacts[contact];
    let friction = |k: usize| pairs.iter().map(|pair| pair.friction_force[k]).sum();
    (
        pairs.iter().map(|pair| pair.normal_force).sum(),
        [friction(0), friction(1), friction(2)],
    )
}

/// The larger of two neighbouring errors over the smaller, as a rate for halved elements.
pub fn rate(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).log2()
}
