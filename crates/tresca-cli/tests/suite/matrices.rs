//! `tresca export` and `tresca solve` on what it writes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

struct Scene(tempfile::TempDir);

impl Scene {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A case of `cases/`, some of its text exchanged.
    fn case(&self, name: &str, exchange: &[(&str, &str)]) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../cases")
            .join(name);
        let mut text = fs::read_to_string(path).unwrap();
        for (from, to) in exchange {
            assert!(text.contains(from), "{name} has no `{from}`");
            text = text.replace(from, to);
        }
        fs::write(self.path(name), text).unwrap();
    }

    fn tresca(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_tresca"))
            .args(arguments)
            .current_dir(self.0.path())
            .env("NO_COLOR", "1")
            .output()
            .unwrap()
    }

    /// Runs, and demands an exit code.
    #[track_caller]
    fn runs(&self, arguments: &[&str], code: i32) -> String {
        let output = self.tresca(arguments);
        let (out, err) = (
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr),
        );
        assert_eq!(
            output.status.code(),
            Some(code),
            "{arguments:?}\n{out}\n{err}"
        );
        format!("{out}{err}")
    }

    fn summary(&self, directory: &str) -> serde_json::Value {
        let text = fs::read_to_string(self.path(directory).join("summary.json")).unwrap();
        serde_json::from_str(&text).unwrap()
    }
}

const SMALL: [(&str, &str); 1] = [("[16, 16, 16]", "[7, 7, 7]")];

#[track_caller]
fn close(a: &serde_json::Value, b: &serde_json::Value, relative: f64) {
    let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
    assert!((a - b).abs() <= relative * b.abs(), "{a} and {b}");
}

#[test]
fn an_exported_case_is_solved_to_the_same() {
    let scene = Scene::new();
    scene.case("two-bricks.toml", &SMALL);
    let tight = ["--tolerance", "1e-12"];
    scene.runs(
        &[&["solve", "two-bricks.toml", "--out", "case"], &tight[..]].concat(),
        0,
    );
    let case = scene.summary("case");
    for problem in ["bricks.npz", "bricks"] {
        let text = scene.runs(&["export", "two-bricks.toml", "--to", problem], 0);
        assert!(
            text.contains("2 blocks of K") && text.contains("49 contact pairs"),
            "{text}"
        );
        let arguments = ["solve", problem, "--out", "matrices"];
        let text = scene.runs(&[&arguments, &tight[..]].concat(), 0);
        for part in [
            "49 contact pairs",
            "rel. grad.",
            "converged: grssn",
            "duality gap",
            "results in",
        ] {
            assert!(text.contains(part), "no `{part}` in:\n{text}");
        }
        let matrices = scene.summary("matrices");
        let [own, other] = [&matrices["steps"][0], &case["steps"][0]];
        close(&own["dual_objective"], &other["dual_objective"], 1e-9);
        let [own, other] = [&own["contact"], &other["contact"]];
        close(&own["normal_force_sum"], &other["normal_force_sum"], 1e-9);
        for count in ["pairs", "closed", "open", "stick", "slip"] {
            assert_eq!(own[count], other[count], "{count}");
        }
        let mut names: Vec<_> = fs::read_dir(scene.path("matrices"))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        assert_eq!(names, ["history.csv", "solution.npz", "summary.json"]);
    }
}

#[test]
fn options_of_the_command_line_hold_for_matrices() {
    let scene = Scene::new();
    scene.case("two-bricks.toml", &SMALL);
    scene.runs(&["export", "two-bricks.toml", "--to", "deep/bricks.npz"], 0);
    let arguments = [
        "solve",
        "deep/bricks.npz",
        "--quiet",
        "--method",
        "imssn",
        "--tolerance",
        "1e-3",
    ];
    let engine = ["--engine", "factored", "--threads", "1"];
    assert_eq!(
        scene.runs(&[&arguments[..], &engine].concat(), 0),
        "",
        "--quiet prints nothing"
    );
    let summary = scene.summary("out/bricks");
    assert_eq!(summary["method"], "imssn");
    assert_eq!(summary["engine"]["engine"], "factored");
    assert_eq!(summary["threads"], 1);

    let text = scene.runs(&["solve", "deep/bricks.npz", "--max-iterations", "2"], 1);
    assert!(text.contains("NOT CONVERGED (iteration_limit)"), "{text}");
    assert_eq!(scene.summary("out/bricks")["status"], "iteration_limit");
}

#[test]
fn a_load_step_is_named_where_there_are_several() {
    let scene = Scene::new();
    scene.case("hysteresis.toml", &[]);
    let text = scene.runs(&["export", "hysteresis.toml", "--to", "step.npz"], 2);
    assert!(
        text.contains("load steps") && text.contains("--step"),
        "{text}"
    );
    let text = scene.runs(
        &[
            "export",
            "hysteresis.toml",
            "--to",
            "step.npz",
            "--step",
            "99",
        ],
        2,
    );
    assert!(text.contains("no load step 99"), "{text}");
    assert!(!scene.path("step.npz").exists());
    scene.runs(
        &[
            "export",
            "hysteresis.toml",
            "--to",
            "step.npz",
            "--step",
            "1",
        ],
        0,
    );
    scene.runs(&["solve", "step.npz"], 0);
}

#[test]
fn a_floating_body_without_equilibrium_is_reported() {
    let scene = Scene::new();
    scene.case("pulled-away.toml", &[]);
    scene.runs(&["export", "pulled-away.toml", "--to", "away.npz"], 0);
    let text = scene.runs(&["solve", "away.npz"], 1);
    assert!(
        text.contains("no_equilibrium") && text.contains("kernel"),
        "{text}"
    );
    assert_eq!(scene.summary("out/away")["status"], "no_equilibrium");
}

#[test]
fn wrong_matrices_have_exit_code_2_and_destroy_nothing() {
    let scene = Scene::new();
    scene.case("two-bricks.toml", &SMALL);
    scene.runs(&["export", "two-bricks.toml", "--to", "bricks"], 0);
    scene.runs(&["solve", "bricks", "--quiet"], 0);
    let before = fs::read(scene.path("out/bricks/summary.json")).unwrap();
    fs::remove_file(scene.path("bricks/f.mtx")).unwrap();
    let text = scene.runs(&["solve", "bricks"], 2);
    assert!(text.contains("`f`") && text.contains("load"), "{text}");
    fs::write(
        scene.path("bricks/f.mtx"),
        "%%MatrixMarket matrix array real general\n2 1\n0\n0\n",
    )
    .unwrap();
    let text = scene.runs(&["solve", "bricks"], 2);
    assert!(
        text.contains("load f") && text.contains("length 2"),
        "{text}"
    );
    assert_eq!(
        fs::read(scene.path("out/bricks/summary.json")).unwrap(),
        before
    );
    let text = scene.runs(&["solve", "missing.npz"], 2);
    assert!(text.contains("missing.npz"), "{text}");
}
