//! HDF5: a file of h5py, round trips, damaged files.

use std::fs;
use std::path::Path;

use hdf5_pure::FileBuilder;
use tresca_io::fclib::{Document, Info, State, read};

use super::{data, global, local, lopsided, matrix};

fn write(document: &Document, path: &Path) {
    let mut bytes = Vec::new();
    document.write_hdf5(&mut bytes).unwrap();
    fs::write(path, bytes).unwrap();
}

/// The values are those of `scripts/check_fclib.py`.
#[test]
fn files_of_h5py() {
    let document = read(&data("local_h5py.hdf5")).unwrap();
    let problem = local(&document.problem);
    let expected = matrix(&[[2.0, 0.5, 0.0], [0.5, 1.0, 0.25], [0.0, 0.25, 1.5]]);
    assert_eq!((problem.dimension, &problem.w), (3, &expected));
    assert_eq!(problem.q, [-1.0, 0.5, 0.25]);
    assert_eq!(problem.friction, [0.3]);
    assert_eq!(document.info.title.as_deref(), Some("one contact"));
    assert_eq!(document.info.math_info, None);
    let solution = document.solution.unwrap();
    assert_eq!(
        (solution.u, solution.r, solution.v),
        (vec![0.0, 0.5, 0.25], vec![1.0, 2.0, 3.0], None)
    );
    assert_eq!(document.guesses.len(), 2);
    assert_eq!(document.guesses[1].r, [7.0, 8.0, 9.0]);

    // Triplets as CSparse has them (M) and as FCLIB describes them (H), a place given twice.
    let document = read(&data("global_h5py.hdf5")).unwrap();
    let problem = global(&document.problem);
    assert_eq!(problem.m, matrix(&[[4.0, 1.0], [1.0, 3.0]]));
    assert_eq!(
        problem.h,
        matrix(&[[1.0, 0.0, 0.0, -2.0], [0.0, 5.0, 0.5, 0.0]])
    );
    assert_eq!(problem.f, [1.0, -1.0]);
    assert_eq!(problem.w, [0.0, 1.0, 2.0, 3.0]);
    assert_eq!(problem.friction, [0.1, 0.2]);
}

#[test]
fn a_written_file_reads_back_to_the_same() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("problem.hdf5");
    let state = |seed: f64| State {
        v: Some(vec![seed, 2.0, -3.0]),
        u: vec![0.5 * seed, 1.0, 1e-9, 0.0],
        r: vec![seed.sqrt(), 0.0, 4.0, 1.0],
    };
    let document = Document {
        info: Info {
            title: Some("lopsided".to_owned()),
            description: Some("ein schiefes Körperpaar".to_owned()),
            math_info: None,
        },
        solution: Some(state(2.0)),
        guesses: vec![state(3.0), state(5.0)],
        ..lopsided()
    };
    write(&document, &path);
    assert_eq!(read(&path).unwrap(), document);
    write(&lopsided(), &path);
    assert_eq!(read(&path).unwrap(), lopsided());
    for name in ["Rover1039.dat", "problem-check2.dat"] {
        let text = read(&data(name)).unwrap();
        write(&text, &path);
        assert_eq!(read(&path).unwrap(), text);
    }
}

#[test]
fn cut_and_garbled_files_are_refused() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("cut.hdf5");
    let whole = fs::read(data("local_h5py.hdf5")).unwrap();
    for length in [8, 100, 700, whole.len() / 2] {
        fs::write(&path, &whole[..length]).unwrap();
        read(&path).unwrap_err();
    }
    // A flipped bit may go unnoticed in a number, but nothing may panic.
    for place in (8..whole.len()).step_by(29) {
        let mut garbled = whole.clone();
        garbled[place] ^= 0xff;
        fs::write(&path, garbled).unwrap();
        let _ = read(&path);
    }
}

/// A local problem of one plane contact, with chances to spoil it.
struct Parts {
    group: &'static str,
    dimension: i32,
    nz: i32,
    p: Vec<i32>,
    i: Vec<i32>,
    x: Vec<f64>,
    q: Option<Vec<f64>>,
    mu: Vec<f64>,
    extra: Option<&'static str>,
}

impl Default for Parts {
    fn default() -> Self {
        Self {
            group: "fclib_local",
            dimension: 2,
            nz: -1,
            p: vec![0, 1, 2],
            i: vec![0, 1],
            x: vec![1.0, 2.0],
            q: Some(vec![1.0, 2.0]),
            mu: vec![0.5],
            extra: None,
        }
    }
}

impl Parts {
    fn read(&self) -> Result<Document, String> {
        let mut file = FileBuilder::new();
        let mut group = file.create_group(self.group);
        group
            .create_dataset("spacedim")
            .with_i32_data(&[self.dimension]);
        let mut w = group.create_group("W");
        for (name, value) in [("m", 2), ("n", 2), ("nz", self.nz), ("nzmax", 2)] {
            w.create_dataset(name).with_i32_data(&[value]);
        }
        w.create_dataset("p").with_i32_data(&self.p);
        w.create_dataset("i").with_i32_data(&self.i);
        w.create_dataset("x").with_f64_data(&self.x);
        group.add_group(w.finish());
        let mut vectors = group.create_group("vectors");
        if let Some(q) = &self.q {
            vectors.create_dataset("q").with_f64_data(q);
        }
        vectors.create_dataset("mu").with_f64_data(&self.mu);
        group.add_group(vectors.finish());
        if let Some(name) = self.extra {
            let extra = group.create_group(name);
            group.add_group(extra.finish());
        }
        file.add_group(group.finish());
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("parts.hdf5");
        file.write(&path).unwrap();
        read(&path).map_err(|error| {
            let text = error.to_string();
            let (_, rest) = text.split_once("parts.hdf5`, ").unwrap();
            rest.to_owned()
        })
    }
}

#[test]
fn every_defect_is_named_with_its_dataset() {
    Parts::default().read().unwrap();
    let parts = Parts::default;
    let cases = [
        (
            Parts {
                group: "something",
                ..parts()
            },
            "`/`: the file has neither a group `fclib_local` nor a group `fclib_global`",
        ),
        (
            Parts {
                dimension: 5,
                ..parts()
            },
            "`/fclib_local/spacedim`: problems live in 2 or 3 dimensions, found 5",
        ),
        (
            Parts { nz: -3, ..parts() },
            "`/fclib_local/W/nz`: the storage scheme -3 of a matrix is not known",
        ),
        (
            Parts {
                p: vec![0, 1],
                ..parts()
            },
            "`/fclib_local/W/p`: has 2 values, expected 3",
        ),
        (
            Parts {
                p: vec![0, 3, 2],
                ..parts()
            },
            "`/fclib_local/W/p`: pointers must rise from 0 to at most 2, found 3 at 1",
        ),
        (
            Parts {
                p: vec![0, -1, 2],
                ..parts()
            },
            "`/fclib_local/W/p`: expected a count or an index, found -1",
        ),
        (
            Parts {
                i: vec![0, 9],
                ..parts()
            },
            "`/fclib_local/W`: there is an entry (9, 1) in a matrix of 2 × 2, counted from 0",
        ),
        (
            Parts { nz: 3, ..parts() },
            "`/fclib_local/W/i`: has 2 values, expected 3",
        ),
        (
            Parts {
                x: vec![1.0, f64::NAN],
                ..parts()
            },
            "`/fclib_local/W`: value 1 is NaN, which is no finite number",
        ),
        (
            Parts { q: None, ..parts() },
            "`/fclib_local/vectors/q`: is missing",
        ),
        (
            Parts {
                q: Some(vec![1.0]),
                ..parts()
            },
            "`q`: has 1 values, expected 2",
        ),
        (
            Parts {
                mu: vec![f64::INFINITY],
                ..parts()
            },
            "`mu`: value 0 is inf, which is no finite number",
        ),
        (
            Parts {
                extra: Some("V"),
                ..parts()
            },
            "`/fclib_local/V`: linear constraints (G, b or V, R, s) are not supported",
        ),
    ];
    for (parts, expected) in cases {
        assert_eq!(parts.read().unwrap_err(), expected);
    }
}
