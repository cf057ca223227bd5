//! Problems as files: what NumPy and SciPy write, and what every key means.

use std::path::{Path, PathBuf};

use tresca_io::problem::{Content, DenseArray, KEYS, ProblemFault, Sparse, read};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/suite/problem/data")
        .join(name)
}

/// The matrix with its triplets summed up.
fn full(sparse: &Sparse) -> Vec<f64> {
    let (rows, columns) = sparse.shape;
    let mut values = vec![0.0; rows * columns];
    let entries = sparse.rows.iter().zip(&sparse.columns).zip(&sparse.values);
    entries.for_each(|((i, j), value)| values[columns * i + j] += value);
    values
}

const N: [f64; 6] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
const T: [f64; 6] = [0.0, 0.0, 1.0, 0.0, 0.0, -2.0];

fn check_common(content: &Content) {
    assert_eq!(content.normal.shape, (2, 3));
    assert_eq!(full(&content.normal), N);
    let tangential = content.tangential.as_ref().unwrap();
    assert_eq!(tangential.shape, (2, 3));
    assert_eq!(full(tangential), T);
    assert_eq!(content.load, [1.0, -2.0, 0.25]);
    assert_eq!(content.gap, Some(vec![0.5, 1.0 / 3.0]));
}

#[test]
fn what_scipy_writes() {
    let content = read(&data("scipy.npz")).unwrap();
    check_common(&content);
    assert_eq!(content.stiffness.len(), 1);
    assert_eq!(
        full(&content.stiffness[0]),
        [2.0, -1.0, 0.0, -1.0, 3.0, 0.5, 0.0, 0.5, 4.0]
    );
    assert_eq!(
        content.law,
        Some(vec!["tresca".to_owned(), "coulomb".to_owned()])
    );
    assert_eq!(content.bounds, Some(DenseArray::vector(vec![0.1, 0.0])));
    let coefficients = content.coefficients.unwrap();
    assert_eq!(coefficients.shape, [2, 2]);
    assert_eq!(coefficients.values, [0.0, 0.0, 0.3, 0.2]);
    assert_eq!(content.kernel, None);
}

#[test]
fn dense_arrays_of_other_types_and_orders() {
    let content = read(&data("dense.npz")).unwrap();
    check_common(&content);
    let blocks: Vec<_> = content.stiffness.iter().map(full).collect();
    assert_eq!(blocks, [vec![2.0, -1.0, -1.0, 3.0], vec![4.0]]);
    assert_eq!(content.law, Some(vec!["tresca".to_owned()]));
    let bounds = content.bounds.unwrap();
    assert_eq!(
        (&bounds.shape[..], &bounds.values[..]),
        (&[][..], &[0.25][..])
    );
    assert_eq!(content.points.unwrap().shape, [2, 3]);
}

/// The first column of the table of keys on the page, and the list here.
#[test]
fn every_key_is_documented_and_every_documented_key_exists() {
    let page = include_str!("../../../../../docs/problem-files.md");
    let (_, section) = page.split_once("## Keys\n").unwrap();
    let section = section.split("\n## ").next().unwrap();
    let documented: Vec<&str> = section
        .lines()
        .filter_map(|line| Some(line.strip_prefix("| `")?.split_once('`')?.0))
        .collect();
    let known: Vec<&str> = KEYS.iter().map(|(key, _)| *key).collect();
    assert_eq!(documented, known);
}

fn with_file(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).unwrap();
}

#[test]
fn matrix_market_as_others_write_it() {
    let scene = tempfile::tempdir().unwrap();
    let folder = scene.path();
    // Comments, blank lines, integers, capitals, Fortran exponents of C's kind, symmetric and general.
    with_file(
        folder,
        "K.mtx",
        "%%MatrixMarket MATRIX Coordinate Integer Symmetric\n% a comment\n\n3 3 5\n1 1 2\n2 1 -1\n\n2 2 3\n% more\n3 3 4\n3 2 0\n",
    );
    with_file(
        folder,
        "N.mtx",
        "%%MatrixMarket matrix array real general\n2 3\n1\n0\n0\n1e0\n0\n0.0\n",
    );
    with_file(
        folder,
        "T.mtx",
        "%%MatrixMarket matrix coordinate real general\n2 3 3\n1 3 0.5\n1 3 0.5\n2 3 -2.0E+00\n",
    );
    with_file(
        folder,
        "f.mtx",
        "%%MatrixMarket matrix array real general\n3 1\n1\n-2\n0.25\n",
    );
    with_file(
        folder,
        "gap.mtx",
        "%%MatrixMarket matrix coordinate real general\n2 1 2\n1 1 0.5\n2 1 0.3333333333333333\n",
    );
    with_file(folder, "notes.txt", "not read");
    with_file(
        folder,
        "problem.toml",
        "law = \"coulomb\"\ncoefficients = [0.3, 0.2]\nlimits = [inf, 1]\n",
    );
    let content = read(folder).unwrap();
    check_common(&content);
    assert_eq!(
        full(&content.stiffness[0]),
        [2.0, -1.0, 0.0, -1.0, 3.0, 0.0, 0.0, 0.0, 4.0]
    );
    assert_eq!(
        content.limits,
        Some(DenseArray::vector(vec![f64::INFINITY, 1.0]))
    );

    with_file(
        folder,
        "K.mtx",
        "%%MatrixMarket matrix array real symmetric\n2 2\n1\n2\n3\n",
    );
    let content = read(folder).unwrap();
    assert_eq!(full(&content.stiffness[0]), [1.0, 2.0, 2.0, 3.0]);

    with_file(
        folder,
        "K.mtx",
        "%%MatrixMarket matrix coordinate pattern general\n2 2 0\n",
    );
    let error = read(folder).unwrap_err();
    assert!(
        matches!(error.fault(), ProblemFault::Line { .. }),
        "{error}"
    );
    assert_eq!(error.line_column(), Some((1, 1)));
}
