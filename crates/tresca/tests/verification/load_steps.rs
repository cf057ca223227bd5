//! Load steps: what is kept, what is path-dependent and what is not.

use super::support::{assert_close, settings, solved, solved_with, variant};

const STEPS: &str = r#"
[[step]]
name = "half"
factors = { load = 0.5 }

[[step]]
name = "all"
factors = { load = 1.0 }

[[step]]
name = "nothing"
factors = { load = 0.0 }

[[step]]
name = "all-again"
factors = { load = 1.0 }
"#;

fn bricks(law: &str) -> tresca::case::Case {
    variant(
        "two-bricks.toml",
        &[
            ("nodes = [16, 16, 16]", "nodes = [7, 7, 7]"),
            ("[[traction]]\n", "[[traction]]\nname = \"load\"\n"),
            ("law = \"tresca\", bound = 0.09", law),
            ("[solver]", &format!("{STEPS}\n[solver]")),
        ],
    )
}

/// Without friction there is no history: every step is what its load alone gives.
#[test]
fn without_friction_steps_do_not_remember() {
    let outcome = solved(&bricks("law = \"frictionless\""));
    assert_eq!(outcome.steps.len(), 4);
    let energy = |k: usize| outcome.steps[k].solution.figures.objective;
    assert_close(energy(3), energy(1), 1e-8);
    assert_close(energy(0), 0.25 * energy(1), 1e-6);
    assert!(
        outcome.steps[2]
            .pairs()
            .all(|pair| pair.normal_force == 0.0)
    );
    assert!(
        outcome
            .steps
            .iter()
            .all(|step| step.dissipation().abs() < 1e-12)
    );
}

/// With friction unloading leaves slip, and friction forces that no load asks for.
#[test]
fn with_friction_unloading_leaves_a_trace() {
    let outcome = solved(&bricks("law = \"tresca\", bound = 0.09"));
    let trace = outcome.steps[2]
        .pairs()
        .map(|pair| pair.local_friction[0].abs());
    assert!(trace.fold(0.0, f64::max) > 1e-4);
    for step in &outcome.steps {
        assert!(step.dissipation() >= -1e-14);
        for pair in step.pairs() {
            // The increments of the law add up to the slip since the start.
            let before = match step.number {
                1 => [0.0; 2],
                number => {
                    let same = outcome.steps[number - 2].pairs();
                    let mut same = same.filter(|other| other.pair == pair.pair);
                    same.next().unwrap().local_slip
                }
            };
            let increments = before.iter().zip(pair.local_slip_increment);
            for ((before, increment), slip) in increments.zip(pair.local_slip) {
                assert!((before + increment - slip).abs() < 1e-15);
            }
        }
    }
}

/// A is built once; later steps spend nothing on σmax and start where the step before ended.
#[test]
fn later_steps_are_cheaper_than_the_first() {
    let case = bricks("law = \"tresca\", bound = 0.09");
    let condensed = settings(&case, |settings| {
        settings.engine = tresca::Engine::Condensed
    });
    let outcome = solved_with(&case, &condensed);
    let work = |k: usize| outcome.steps[k].solution.figures.n_a;
    assert!(
        outcome.steps[1..]
            .iter()
            .all(|step| step.solution.figures.n_a_setup == 0)
    );
    assert!(
        work(1) < work(0) && work(3) < work(0),
        "{:?}",
        [0, 1, 2, 3].map(work)
    );
}

/// Slip bounds can be changed from step to step: twice the factor is the bound itself doubled.
#[test]
fn slip_bounds_may_change() {
    let steps = "\n[[step]]\nfactors = { joint = 2.0 }\n\n[solver]";
    let values = "\n[[step]]\nvalues = { joint = 0.18 }\n\n[solver]";
    let solve = |exchange: &[(&str, &str)]| {
        let nodes = ("nodes = [16, 16, 16]", "nodes = [7, 7, 7]");
        let all: Vec<_> = std::iter::once(nodes)
            .chain(exchange.iter().copied())
            .collect();
        solved(&variant("two-bricks.toml", &all))
            .last()
            .solution
            .figures
            .objective
    };
    let named = ("[[contact]]\n", "[[contact]]\nname = \"joint\"\n");
    let doubled = solve(&[("bound = 0.09", "bound = 0.18")]);
    assert_close(solve(&[named, ("[solver]", steps)]), doubled, 1e-9);
    assert_close(solve(&[named, ("[solver]", values)]), doubled, 1e-9);
}
