//! Problems that go through files come back the same.

use std::path::Path;

use tresca::algebraic::{Assembly, FileError, Matrix, MatrixProblem};
use tresca::output::Destination;
use tresca_bench::two_bricks::{Units, two_bricks};

use super::common::*;

fn write(problem: &MatrixProblem, to: &Path) {
    let assembly = Assembly {
        problem: problem.clone(),
        pairs: Vec::new(),
        dofs: Vec::new(),
    };
    assembly.write(to).unwrap();
}

/// Everything that files can hold.
fn everything() -> Vec<MatrixProblem> {
    let mut problems: Vec<MatrixProblem> = CONVEX
        .into_iter()
        .chain([Laws::Coulomb])
        .flat_map(|laws| [random(laws, 2, 3, 3), random(laws, 1, 0, 4)])
        .collect();
    let with_start = random(Laws::Tresca, 2, 0, 5);
    let start = solved(&with_start, &tight()).forces();
    let mut with_start = with_start.with_start(start);
    with_start
        .conditions
        .start
        .as_mut()
        .unwrap()
        .kernel_amounts
        .clear();
    with_start.points = Some((0..6).map(|i| [f64::from(i), 0.5, -1e-30]).collect());
    problems.push(with_start);
    problems.push(random(Laws::Frictionless, 0, 2, 7));
    let k = Matrix::from_dense((2, 2), &[1.0, -1.0, -1.0, 1.0]).unwrap();
    let n = Matrix::from_dense((1, 2), &[1.0, 0.0]).unwrap();
    problems.push(MatrixProblem::new(k, n, vec![1.0, 0.0]).with_kernel(vec![vec![1.0, 1.0]]));
    problems
}

#[test]
fn archives_and_folders_hold_every_bit() {
    let scene = tempfile::tempdir().unwrap();
    for (number, problem) in everything().into_iter().enumerate() {
        for name in ["problem.npz", "problem"] {
            let path = scene.path().join(format!("{number}-{name}"));
            write(&problem, &path);
            let mut read = tresca::algebraic::read(&path).unwrap();
            // One law for all comes back as one for each.
            let laws = problem.conditions.friction.laws(problem.pairs()).unwrap();
            read.conditions.friction = read
                .conditions
                .friction
                .laws(problem.pairs())
                .unwrap()
                .into();
            let expected = problem.clone().with_friction(laws);
            assert_eq!(read, expected, "{}", path.display());
        }
    }
}

#[test]
fn an_assembled_model_says_where_its_numbers_come_from() {
    let scene = tempfile::tempdir().unwrap();
    let model = two_bricks(4, Units::METRE_MEGAPASCAL).unwrap();
    let assembly = Assembly::new(&model, &model.whole_step()).unwrap();
    assert_eq!(assembly.dofs.len(), assembly.problem.dofs());
    assert_eq!(assembly.dofs[0][0], 0);
    assert_eq!(assembly.dofs.last().unwrap()[0], 1);
    let path = scene.path().join("deep/er/bricks.npz");
    assembly.write(&path).unwrap();
    assert_eq!(
        tresca::algebraic::read(&path).unwrap().points,
        assembly.problem.points
    );
}

#[test]
fn results_are_written_together() {
    let scene = tempfile::tempdir().unwrap();
    let solution = solved(&random(Laws::Tresca, 2, 0, 2), &tight());
    let report = Destination::new(&scene.path().join("out"))
        .and_then(|destination| destination.write_matrices("random", &solution))
        .unwrap();
    let contact = &report.last().contact;
    assert_eq!(contact.closed + contact.open, 6);
    let mut names: Vec<_> = std::fs::read_dir(scene.path().join("out"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["history.csv", "solution.npz", "summary.json"]);
    let text = std::fs::read_to_string(scene.path().join("out/summary.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["status"], "converged");
    assert_eq!(json["name"], "random");
    assert_eq!(json["steps"][0]["contact"]["pairs"], 6);
}

#[track_caller]
fn refused(path: &Path, parts: &[&str]) {
    let error = match tresca::algebraic::read(path) {
        Ok(_) => panic!("nothing wrong with {}", path.display()),
        Err(error @ (FileError::File(_) | FileError::Content { .. })) => error.to_string(),
        Err(other) => panic!("{other}"),
    };
    for part in parts {
        assert!(error.contains(part), "no `{part}` in: {error}");
    }
}

#[test]
fn folders_with_something_wrong() {
    let scene = tempfile::tempdir().unwrap();
    let folder = scene.path().join("problem");
    write(&random(Laws::Tresca, 2, 0, 2), &folder);
    let file = |name: &str| folder.join(name);
    let original = |name: &str| std::fs::read_to_string(file(name)).unwrap();
    let with = |name: &str, text: &str, parts: &[&str]| {
        let before = std::fs::read(file(name)).ok();
        std::fs::write(file(name), text).unwrap();
        refused(&folder, parts);
        match before {
            Some(before) => std::fs::write(file(name), before).unwrap(),
            None => std::fs::remove_file(file(name)).unwrap(),
        }
    };
    let k0 = original("K0.mtx");
    with(
        "K0.mtx",
        &k0.replace("symmetric", "hermitian"),
        &["K0.mtx", "line 1", "MatrixMarket"],
    );
    with(
        "K0.mtx",
        &k0.replacen("20 20 ", "20 20 9", 1),
        &["K0.mtx", "entries", "end of the file"],
    );
    with(
        "K0.mtx",
        &k0.replacen("\n2 1 ", "\n2 21 ", 1),
        &["K0.mtx", "line ", "`2 21 "],
    );
    with(
        "K0.mtx",
        &k0.replacen("\n2 1 ", "\n0 1 ", 1),
        &["K0.mtx", "counted from 1"],
    );
    with(
        "K0.mtx",
        &format!("{k0}1 1 1\n"),
        &["K0.mtx", "expected the end of the file"],
    );
    with(
        "f.mtx",
        "%%MatrixMarket matrix array real general\n2 1\n1.0\nx\n",
        &["f.mtx", "line 4", "`x`"],
    );
    with("gaps.mtx", "", &["`gaps`", "did you mean `gap`"]);
    with("K.mtx", &k0, &["K", "both"]);
    with(
        "problem.toml",
        "law = \"trescas\"",
        &["law", "tresca", "`trescas`"],
    );
    with("problem.toml", "law = 3", &["problem.toml", "law", "word"]);
    with(
        "problem.toml",
        "law = [\"tresca\"",
        &["problem.toml", "line 1"],
    );
    with(
        "problem.toml",
        "law = \"coulomb\"",
        &["coefficients", "needs"],
    );
    with(
        "problem.toml",
        "law = \"tresca\"\nbounds = 1.0",
        &["bounds", "one place"],
    );
    with(
        "problem.toml",
        "law = [\"tresca\", \"tied\"]",
        &["law", "6 pairs", "2 words"],
    );
    std::fs::remove_file(file("problem.toml")).unwrap();
    std::fs::remove_file(file("bounds.mtx")).unwrap();
    refused(&folder, &["law", "there is T"]);
    std::fs::write(file("problem.toml"), "bounds = 0.25").unwrap();
    assert!(
        tresca::algebraic::read(&folder).is_ok(),
        "Tresca's law by its bound alone"
    );
    std::fs::remove_file(file("f.mtx")).unwrap();
    refused(&folder, &["`f`", "load"]);
    std::fs::remove_file(file("K0.mtx")).unwrap();
    refused(&folder, &["`K0`", "without gaps"]);
    refused(&scene.path().join("missing"), &["missing"]);
}

#[test]
fn archives_with_something_wrong() {
    let scene = tempfile::tempdir().unwrap();
    let path = scene.path().join("problem.npz");
    std::fs::write(&path, "no archive").unwrap();
    refused(&path, &["problem.npz", "no .npz archive"]);
    write(&random(Laws::Tresca, 2, 0, 2), &path);
    let bytes = std::fs::read(&path).unwrap();
    // The name of an array stands in the local header and in the directory, uncompressed.
    let renamed = |from: &str, to: &str| {
        assert_eq!(from.len(), to.len());
        let mut bytes = bytes.clone();
        for at in 0..bytes.len() - from.len() {
            if &bytes[at..at + from.len()] == from.as_bytes() {
                bytes[at..at + to.len()].copy_from_slice(to.as_bytes());
            }
        }
        std::fs::write(&path, bytes).unwrap();
    };
    renamed("bounds.npy", "bonuds.npy");
    refused(&path, &["`bonuds`", "did you mean `bounds`"]);
    renamed("K0/indptr.npy", "K0/indbtr.npy");
    refused(&path, &["K0/indbtr"]);
}
