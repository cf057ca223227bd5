//! Ctrl-C, through every door: before the first iteration nothing is written, later everything is, and says so.
#![cfg(unix)]

use std::fmt::Write;
use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;

const TWO_BRICKS: &str = include_str!("../../../../cases/two-bricks.toml");

/// A method with a long tail and a tolerance that it will not reach soon.
const ENDLESS: [&str; 9] = [
    "--method",
    "gimssn",
    "--tolerance",
    "1e-14",
    "--max-iterations",
    "100000000",
    "--set",
    "rho=0.001",
    "--engine=factored",
];

fn command(directory: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tresca"));
    command.args(arguments).current_dir(directory);
    command.env("NO_COLOR", "1");
    command
}

/// Two bricks with so many nodes per edge: as a case, and as matrices.
fn bricks(nodes: usize) -> TempDir {
    let scene = tempfile::tempdir().unwrap();
    let cells = format!("[{nodes}, {nodes}, {nodes}]");
    let case = TWO_BRICKS.replace("[16, 16, 16]", &cells);
    fs::write(scene.path().join("bricks.toml"), case).unwrap();
    let export = ["export", "bricks.toml", "--to", "bricks.npz"];
    assert!(
        command(scene.path(), &export)
            .output()
            .unwrap()
            .status
            .success()
    );
    scene
}

/// A problem of Siconos that takes a while to look at: W_ij = 2^−|i−j|, dense.
fn contacts(count: usize) -> TempDir {
    let n = 3 * count;
    let mut text = format!("3\n{count}\n0\n{n}\n{n}\n{n} {n}\n");
    for i in 0..n {
        for j in 0..n {
            let exponent = -f64::from(i32::try_from(i.abs_diff(j)).unwrap());
            write!(text, "{:.3e} ", exponent.exp2()).unwrap();
        }
        text.push('\n');
    }
    writeln!(text, "{}", "-1.0 0.5 0.25 ".repeat(count)).unwrap();
    writeln!(text, "{}\n1", "0.3 ".repeat(count)).unwrap();
    let scene = tempfile::tempdir().unwrap();
    fs::write(scene.path().join("contacts.dat"), text).unwrap();
    scene
}

/// Runs, sends SIGINT when a line that begins so has been printed; what is printed after that, to both streams, and
/// the exit code.
fn interrupted(directory: &Path, arguments: &[&str], begins: &str) -> (String, Option<i32>) {
    let mut child = command(directory, arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let seen = lines
        .by_ref()
        .map(Result::unwrap)
        .any(|line| line.trim_start().starts_with(begins));
    let kill = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status()
        .unwrap();
    assert!(kill.success());
    let mut rest: String = lines.map(|line| line.unwrap() + "\n").collect();
    let mut errors = child.stderr.take().unwrap();
    errors.read_to_string(&mut rest).unwrap();
    assert!(seen, "no line begins with `{begins}`: {rest}");
    (rest, child.wait().unwrap().code())
}

#[test]
fn before_the_first_iteration_nothing_is_written() {
    let (bricks, contacts) = (bricks(21), contacts(250));
    for (scene, file) in [
        (&bricks, "bricks.toml"),
        (&bricks, "bricks.npz"),
        (&contacts, "contacts.dat"),
    ] {
        let (text, code) = interrupted(scene.path(), &["solve", file], "tresca ");
        assert_eq!(code, Some(130), "{file}: {text}");
        assert!(
            text.contains("interrupted before the first iteration: nothing was written"),
            "{file}: {text}"
        );
        assert!(!scene.path().join("out").exists(), "{file}");
    }
}

#[test]
fn later_what_is_there_is_written_and_says_so() {
    let (bricks, contacts) = (bricks(7), contacts(40));
    let law = ["--law", "tresca", "--bound", "0.1"];
    for (scene, file, more) in [
        (&bricks, "bricks.toml", &[][..]),
        (&bricks, "bricks.npz", &[]),
        (&contacts, "contacts.dat", &law),
    ] {
        let arguments = [&["solve", file][..], &ENDLESS, more].concat();
        let (text, code) = interrupted(scene.path(), &arguments, "2     0 ");
        assert_eq!(code, Some(1), "{file}: {text}");
        assert!(
            text.contains("NOT CONVERGED (interrupted)"),
            "{file}: {text}"
        );
        let name = file.split('.').next().unwrap();
        let path = scene.path().join("out").join(name).join("summary.json");
        let summary = fs::read_to_string(path).unwrap();
        let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
        assert_eq!(summary["status"], "interrupted", "{file}");
    }
}
