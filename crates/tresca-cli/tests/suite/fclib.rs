//! Problems of FCLIB and Siconos from outside: exit codes, files, messages.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tresca-io/tests/data/fclib")
        .join(name)
}

struct Scene(tempfile::TempDir);

impl Scene {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn tresca(&self, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tresca"));
        command
            .args(arguments)
            .current_dir(self.0.path())
            .env("NO_COLOR", "1");
        command.output().unwrap()
    }

    fn summary(&self, directory: &str) -> serde_json::Value {
        let text = fs::read_to_string(self.path(directory).join("summary.json")).unwrap();
        serde_json::from_str(&text).unwrap()
    }
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Without the line breaks and the frame that reports are set in.
fn stderr(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr);
    let words = text.split_whitespace().filter(|&word| word != "│");
    words.collect::<Vec<_>>().join(" ")
}

#[test]
fn a_text_of_siconos_is_solved_as_posed() {
    let scene = Scene::new();
    let crank = data("FC2D_SliderCrankLagrangian00000.dat");
    let output = scene.tresca(&["solve", crank.to_str().unwrap(), "--out", "crank"]);
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(0), "{text}{}", stderr(&output));
    assert!(text.contains("2 contacts in 2 dimensions"), "{text}");
    assert!(text.contains("converged: grssn in"), "{text}");
    assert!(text.contains("note: W is singular (rank 3 of 4)"), "{text}");
    assert!(text.contains("note: W is symmetric up to 1.6e-7"), "{text}");
    let summary = scene.summary("crank");
    assert_eq!(summary["law"]["name"], "coulomb");
    assert!(
        summary["steps"][0]["residuals"]["symmetrised"]
            .as_f64()
            .unwrap()
            < 1e-6
    );
    for name in ["solution.csv", "history.csv"] {
        assert!(scene.path("crank").join(name).exists(), "{name}");
    }
    let hdf5 = scene.path("crank/FC2D_SliderCrankLagrangian00000.hdf5");
    assert_eq!(hdf5.exists(), cfg!(feature = "fclib"));
}

#[test]
fn the_law_of_tresca_takes_a_bound() {
    let scene = Scene::new();
    let rover = data("Rover1039.dat");
    let rover = rover.to_str().unwrap();
    let output = scene.tresca(&[
        "solve", rover, "--law", "tresca", "--bound", "0.5", "--quiet", "--out", "o",
    ]);
    assert_eq!(
        (output.status.code(), stdout(&output).as_str()),
        (Some(0), "")
    );
    let summary = scene.summary("o");
    assert_eq!(
        (&summary["law"]["name"], &summary["law"]["bound"]),
        (&"tresca".into(), &0.5.into())
    );
    assert_eq!(summary["steps"][0]["outer_iterations"], 0);

    let missing = scene.tresca(&["solve", rover, "--law", "tresca"]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(stderr(&missing).contains("--law tresca needs the slip bound"));
    let lost = scene.tresca(&["solve", rover, "--bound", "1"]);
    assert!(stderr(&lost).contains("--bound is for --law tresca"));
    let negative = scene.tresca(&["solve", rover, "--law", "tresca", "--bound", "-1"]);
    assert_eq!(negative.status.code(), Some(2));
    assert!(stderr(&negative).contains("the slip bound must be a number ≥ 0, found -1"));
    assert!(!scene.path("out").exists());
}

#[test]
fn an_unfinished_run_says_so() {
    let scene = Scene::new();
    let rover = data("Rover4516.dat");
    let output = scene.tresca(&[
        "solve",
        rover.to_str().unwrap(),
        "--max-iterations",
        "1",
        "--tolerance",
        "1e-13",
        "--out",
        "o",
    ]);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    assert!(
        stdout(&output).contains("NOT CONVERGED ("),
        "{}",
        stdout(&output)
    );
    assert_ne!(scene.summary("o")["status"], "converged");
}

#[test]
fn wrong_input_names_file_and_place() {
    let scene = Scene::new();
    let text = fs::read_to_string(data("Rover1039.dat")).unwrap();
    fs::write(
        scene.path("bad.dat"),
        text.replacen("1.205376840899833462694701e-03", "oops", 1),
    )
    .unwrap();
    let output = scene.tresca(&["solve", "bad.dat"]);
    assert_eq!(output.status.code(), Some(2));
    let message = stderr(&output);
    assert!(
        message.contains("line 7") && message.contains("oops"),
        "{message}"
    );
    assert!(!scene.path("out").exists());

    fs::write(scene.path("case.toml"), "").unwrap();
    let output = scene.tresca(&["solve", "case.toml", "--law", "coulomb"]);
    assert!(
        stderr(&output).contains("others have their own laws"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn cases_are_exported_and_solved_again() {
    let scene = Scene::new();
    let case =
        include_str!("../../../../cases/two-bricks.toml").replace("[16, 16, 16]", "[5, 5, 5]");
    let tresca_law = scene.path("tresca.toml");
    fs::write(&tresca_law, &case).unwrap();
    let refused = scene.tresca(&["export", "tresca.toml", "--to", "bricks.dat"]);
    assert_eq!(refused.status.code(), Some(2), "{}", stdout(&refused));
    assert!(
        stderr(&refused).contains("FCLIB cannot express laws other than"),
        "{}",
        stderr(&refused)
    );

    let friction = "friction = { law = \"coulomb\", coefficient = 0.3 }";
    let coulomb: Vec<&str> = case
        .lines()
        .map(|line| {
            if line.starts_with("friction") {
                friction
            } else {
                line
            }
        })
        .collect();
    assert!(
        coulomb.contains(&friction),
        "the case has a line for its friction"
    );
    fs::write(scene.path("coulomb.toml"), coulomb.join("\n")).unwrap();
    let format = if cfg!(feature = "fclib") {
        "bricks.hdf5"
    } else {
        "bricks.dat"
    };
    let output = scene.tresca(&["export", "coulomb.toml", "--to", format]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(
        stdout(&output).contains("contacts in 3 dimensions"),
        "{}",
        stdout(&output)
    );
    let output = scene.tresca(&["solve", format, "--out", "again"]);
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}{}",
        stdout(&output),
        stderr(&output)
    );
    let summary = scene.summary("again");
    if cfg!(feature = "fclib") {
        assert!(
            summary["steps"][0]["reference"]["forces"].as_f64().unwrap() < 1e-4,
            "{summary}"
        );
    }
    let step = scene.tresca(&["export", "coulomb.toml", "--to", format, "--step", "1"]);
    assert!(stderr(&step).contains("the last one is exported"));
}

#[cfg(not(feature = "fclib"))]
#[test]
fn without_hdf5_the_program_says_how_to_get_it() {
    let scene = Scene::new();
    let output = scene.tresca(&["solve", data("local_h5py.hdf5").to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        stderr(&output).contains("build with the feature `fclib`"),
        "{}",
        stderr(&output)
    );
}

#[cfg(feature = "fclib")]
#[test]
fn a_file_of_h5py_is_solved() {
    let scene = Scene::new();
    let output = scene.tresca(&[
        "solve",
        data("local_h5py.hdf5").to_str().unwrap(),
        "--out",
        "o",
    ]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).contains("one contact"));
    // What the file calls its solution is none.
    assert!(
        scene.summary("o")["steps"][0]["reference"]["forces"]
            .as_f64()
            .unwrap()
            > 0.1
    );
}
