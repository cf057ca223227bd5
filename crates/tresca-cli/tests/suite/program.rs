//! The program from outside: exit codes, files, messages.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const TWO_BRICKS: &str = include_str!("../../../../cases/two-bricks.toml");

/// A small version of the benchmark.
fn small_case() -> String {
    TWO_BRICKS.replace("[16, 16, 16]", "[7, 7, 7]")
}

struct Scene(tempfile::TempDir);

impl Scene {
    fn new(case: &str) -> Self {
        let directory = tempfile::tempdir().unwrap();
        fs::write(directory.path().join("small.toml"), case).unwrap();
        Self(directory)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tresca"));
        command
            .args(arguments)
            .current_dir(self.0.path())
            .env("NO_COLOR", "1");
        command
    }

    fn tresca(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    fn summary(&self, directory: &str) -> serde_json::Value {
        let text = fs::read_to_string(self.path(directory).join("summary.json")).unwrap();
        serde_json::from_str(&text).unwrap()
    }
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn names(directory: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(directory)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn solve_writes_everything_and_says_converged() {
    let scene = Scene::new(&small_case());
    let output = scene.tresca(&["solve", "small.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let text = stdout(&output);
    for part in [
        "Two bricks",
        "n_A",
        "converged: grssn",
        "duality gap",
        "balance of upper",
        "peak memory",
    ] {
        assert!(text.contains(part), "no `{part}` in:\n{text}");
    }
    let files = [
        "contact.vtu",
        "history.csv",
        "lower.vtu",
        "small.pvd",
        "summary.json",
        "upper.vtu",
    ];
    assert_eq!(names(&scene.path("out/small")), files);

    let summary = scene.summary("out/small");
    assert_eq!(summary["status"], "converged");
    assert_eq!(summary["steps"][0]["contact"]["pairs"], 49);
    assert_eq!(summary["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(summary["settings"]["tolerance"], 1e-8);
    for key in [
        "/method",
        "/iterations",
        "/n_a",
        "/n_a_setup",
        "/steps/0/relative_reduced_gradient",
        "/steps/0/dual_objective",
        "/steps/0/contact/closed",
        "/steps/0/contact/stick",
        "/steps/0/contact/slip",
        "/steps/0/contact/normal_force_sum",
        "/steps/0/contact/max_slip_component",
        "/steps/0/contact/max_gap",
        "/steps/0/certificate/equilibrium",
        "/steps/0/certificate/duality_gap",
        "/times/assembly",
        "/times/factorization",
        "/times/solve",
        "/times/total",
        "/settings/method",
    ] {
        assert!(
            summary.pointer(key).is_some_and(|value| !value.is_null()),
            "{key}"
        );
    }
    let history = fs::read_to_string(scene.path("out/small/history.csv")).unwrap();
    assert_eq!(
        history.lines().count() as u64,
        2 + summary["iterations"].as_u64().unwrap()
    );
}

#[test]
fn an_unconverged_run_is_written_marked_and_has_exit_code_1() {
    let scene = Scene::new(&small_case());
    let output = scene.tresca(&[
        "solve",
        "small.toml",
        "--out",
        "here",
        "--max-iterations",
        "2",
    ]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert!(stdout(&output).contains("NOT CONVERGED (iteration_limit)"));
    let summary = scene.summary("here");
    assert_eq!(summary["status"], "iteration_limit");
    assert_eq!(summary["settings"]["max_iterations"], 2);
    let vtu = fs::read(scene.path("here/contact.vtu")).unwrap();
    assert!(String::from_utf8_lossy(&vtu).contains("iteration_limit"));
}

#[test]
fn wrong_input_has_exit_code_2_and_destroys_nothing() {
    let scene = Scene::new(&small_case());
    assert_eq!(
        scene
            .tresca(&["solve", "small.toml", "--quiet"])
            .status
            .code(),
        Some(0)
    );
    let before = fs::read(scene.path("out/small/summary.json")).unwrap();

    let broken = small_case().replace("poisson = 0.35", "poison = 0.35");
    fs::write(scene.path("small.toml"), broken).unwrap();
    let output = scene.tresca(&["solve", "small.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let message = stderr(&output);
    assert!(
        message.contains("small.toml:14") && message.contains("poisson"),
        "{message}"
    );

    let satellite = r#"
[[body]]
name = "satellite"
mesh = { brick = { min = [9.0, 0.0, 0.0], max = [10.0, 1.0, 1.0], nodes = [2, 2, 2] } }
material = { young = 1.0, poisson = 0.3 }
"#;
    let line = small_case().lines().count() + 3;
    let floating = small_case() + satellite;
    fs::write(scene.path("small.toml"), floating).unwrap();
    let output = scene.tresca(&["solve", "small.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let message = stderr(&output);
    assert!(
        message.contains(&format!("small.toml:{line}"))
            && message.contains("`satellite` is not held"),
        "{message}"
    );

    let output = scene.tresca(&["solve", "missing.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("missing.toml"));
    assert_eq!(
        fs::read(scene.path("out/small/summary.json")).unwrap(),
        before
    );
    assert_eq!(
        names(&scene.path("out/small")).len(),
        6,
        "no temporary file is left"
    );
}

#[test]
fn options_of_the_command_line_override_the_case_file() {
    let scene = Scene::new(&small_case());
    let arguments = [
        "solve",
        "small.toml",
        "--quiet",
        "--method",
        "imssn",
        "--tolerance",
        "1e-3",
        "--threads",
        "1",
        "--set",
        "rho=5.0",
        "--set",
        "inner_solver=iterative",
        "--engine",
        "factored",
    ];
    let output = scene.tresca(&arguments);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(stdout(&output), "", "--quiet prints nothing");
    let summary = scene.summary("out/small");
    assert_eq!(summary["method"], "imssn");
    assert_eq!(summary["settings"]["rho"], 5.0);
    assert_eq!(summary["settings"]["inner_solver"], "iterative");
    assert_eq!(summary["engine"]["engine"], "factored");
    assert_eq!(summary["threads"], 1);

    for (arguments, part) in [
        (["--tolerance", "2"], "tolerance"),
        (["--set", "rhoo=1"], "rhoo"),
        (["--set", "coulomb=sometimes"], "sometimes"),
        (["--set", "coulomb=\"in loop"], "expected key=value"),
        (["--method", "newton"], "newton"),
        (["--threads", "0"], "threads"),
    ] {
        let output = scene.tresca(&[&["solve", "small.toml"], &arguments[..]].concat());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&output).contains(part), "{}", stderr(&output));
    }
}

#[test]
fn the_page_of_options_is_what_the_program_prints() {
    let scene = Scene::new("");
    let output = scene.tresca(&["options", "--format", "markdown"]);
    let page = include_str!("../../../../docs/options.md");
    assert!(
        page.contains(&stdout(&output)),
        "docs/options.md is not up to date; `tresca options --format markdown` prints:\n{}",
        stdout(&output)
    );
}

#[test]
fn the_benchmark_prints_the_published_counts_beside_ours() {
    let scene = Scene::new("");
    let output = scene.tresca(&["bench", "table1", "--sizes", "6,16", "--tolerance", "1e-4"]);
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(0), "{text}{}", stderr(&output));
    for part in [
        "10 / 161", "9 / 1180", "imssn", "ssn", "apgd", "grssn", "ratio", "GFLOP/s",
    ] {
        assert!(text.contains(part), "no `{part}` in:\n{text}");
    }
}
