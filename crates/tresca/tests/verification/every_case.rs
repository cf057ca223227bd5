//! Every case file runs, and ends as its README says.

use super::support::{directory, run, variant};
use tresca::Status;

/// Cases that are wrong on purpose.
const NO_EQUILIBRIUM: [&str; 1] = ["pulled-away.toml"];

#[test]
fn every_case_runs_and_is_described() {
    let readme = std::fs::read_to_string(directory().join("README.md")).unwrap();
    let mut count = 0;
    for entry in std::fs::read_dir(directory()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if !name.ends_with(".toml") {
            continue;
        }
        assert!(
            readme.contains(&format!("## `{name}`")),
            "{name} has no paragraph"
        );
        let case = variant(&name, &[]);
        let outcome = run(&case, case.settings());
        if NO_EQUILIBRIUM.contains(&name.as_str()) {
            assert_eq!(outcome.status(), Status::NoEquilibrium, "{name}");
        } else {
            assert_eq!(outcome.status(), Status::Converged, "{name}");
            for step in &outcome.steps {
                let worst = step.certificate.worst();
                assert!(
                    worst < 1e-5,
                    "{name}, step {}: {:#?}",
                    step.number,
                    step.certificate
                );
            }
        }
        count += 1;
    }
    assert!(count >= 12, "only {count} cases found");
}
