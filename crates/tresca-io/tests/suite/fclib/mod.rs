//! Frictional contact problems: files of Siconos, round trips, files that are not in order.

mod bad_files;
mod formats;
#[cfg(feature = "fclib")]
mod hdf5;
mod siconos;

use std::path::PathBuf;

use tresca_io::fclib::{Document, FclibMatrix, FclibProblem, GlobalProblem, LocalProblem};

/// A file of the test data.
fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data/fclib")
        .join(name)
}

/// Reads a text as a file.
fn read_text(text: &str) -> Result<Document, tresca_io::fclib::FclibError> {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("problem.dat");
    std::fs::write(&path, text).unwrap();
    tresca_io::fclib::read(&path)
}

fn local(problem: &FclibProblem) -> &LocalProblem {
    match problem {
        FclibProblem::Local(local) => local,
        FclibProblem::Global(_) => panic!("a global problem"),
    }
}

fn global(problem: &FclibProblem) -> &GlobalProblem {
    match problem {
        FclibProblem::Global(global) => global,
        FclibProblem::Local(_) => panic!("a local problem"),
    }
}

/// A matrix by its rows.
fn matrix<const COLUMNS: usize>(rows: &[[f64; COLUMNS]]) -> FclibMatrix {
    let entries = rows.iter().enumerate().flat_map(|(i, row)| {
        let row = row.iter().enumerate();
        row.map(move |(j, &value)| (i, j, value))
    });
    FclibMatrix::new(rows.len(), COLUMNS, entries.collect()).unwrap()
}

/// A global problem in the plane whose matrices are neither symmetric nor square where they need
/// not be, so that nothing transposed goes unnoticed: 3 velocities, 2 contacts.
fn lopsided() -> Document {
    let m = matrix(&[[4.0, 1.0, 0.0], [1.0, 3.0, 0.0], [0.0, 0.0, 2.0]]);
    let h = matrix(&[
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.5, 0.0],
        [0.0, 0.0, 0.0, -2.0],
    ]);
    FclibProblem::Global(GlobalProblem {
        dimension: 2,
        m,
        h,
        f: vec![0.1, -1.0 / 3.0, 1e-300],
        w: vec![0.0, -0.0, 7.25, 1e17],
        friction: vec![0.3, 0.0],
    })
    .into()
}
