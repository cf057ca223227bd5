//! Who may import whom. The picture stands in `docs/architecture.md`.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

const ALLOWED: [(&str, &[&str]); 13] = [
    ("tresca-testkit", &[]),
    ("tresca-la", &[]),
    ("tresca-fem", &["tresca-la"]),
    ("tresca-contact", &["tresca-fem", "tresca-la"]),
    ("tresca-qcqp", &["tresca-la"]),
    ("tresca-io", &["tresca-fem", "tresca-la"]),
    (
        "tresca-system",
        &["tresca-contact", "tresca-fem", "tresca-la", "tresca-qcqp"],
    ),
    ("tresca-model", &["tresca-contact", "tresca-fem"]),
    (
        "tresca-case",
        &[
            "tresca-contact",
            "tresca-fem",
            "tresca-io",
            "tresca-model",
            "tresca-qcqp",
            "tresca-system",
        ],
    ),
    (
        "tresca",
        &[
            "tresca-case",
            "tresca-contact",
            "tresca-fem",
            "tresca-io",
            "tresca-la",
            "tresca-model",
            "tresca-qcqp",
            "tresca-system",
        ],
    ),
    // Those below `tresca` for the times of their parts alone.
    (
        "tresca-bench",
        &[
            "tresca",
            "tresca-contact",
            "tresca-fem",
            "tresca-io",
            "tresca-la",
        ],
    ),
    ("tresca-cli", &["tresca", "tresca-bench", "tresca-io"]),
    ("tresca-py", &["tresca", "tresca-io"]),
];

#[test]
fn crates_import_only_what_the_architecture_allows() {
    let output = Command::new(env!("CARGO"))
        .args([
            "metadata",
            "--no-deps",
            "--offline",
            "--format-version",
            "1",
        ])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let allowed: BTreeMap<_, _> = ALLOWED.into_iter().collect();
    let mut seen = BTreeSet::new();
    for package in metadata["packages"].as_array().unwrap() {
        let name = package["name"].as_str().unwrap();
        let permitted = allowed
            .get(name)
            .unwrap_or_else(|| panic!("{name} is not in the list of crates above"));
        seen.insert(name);
        for dependency in package["dependencies"].as_array().unwrap() {
            let for_tests = dependency["kind"] == "dev";
            let dependency = dependency["name"].as_str().unwrap();
            let ours = dependency == "tresca" || dependency.starts_with("tresca-");
            // Tests may use the models of the benchmarks, and what they share.
            let of_tests = ["tresca-bench", "tresca-testkit"].contains(&dependency);
            let allowed = permitted.contains(&dependency) || for_tests && of_tests;
            assert!(
                !ours || allowed,
                "{name} imports {dependency}; docs/architecture.md does not allow it"
            );
        }
    }
    assert_eq!(
        seen.len(),
        allowed.len(),
        "a crate of the list is missing: {seen:?}"
    );
}
