//! Files that are not in order are refused with the place and the reason.

use std::fs;

use super::{data, local, lopsided, read_text};
use tresca_io::WriteError;
use tresca_io::fclib::{Document, FclibFault, FclibMatrix, FclibProblem, read};

fn refusal(text: &str) -> String {
    let text = read_text(text).unwrap_err().to_string();
    let (_, rest) = text.split_once("problem.dat`, ").unwrap();
    rest.to_owned()
}

/// A file of Siconos with one thing replaced.
fn spoilt(name: &str, from: &str, to: &str) -> String {
    let text = fs::read_to_string(data(name)).unwrap();
    assert!(text.contains(from), "nothing to spoil");
    refusal(&text.replacen(from, to, 1))
}

#[test]
fn texts() {
    let rover = "Rover1039.dat";
    let cases = [
        (
            refusal(""),
            "line 1: the file ends where the dimension should follow",
        ),
        (
            refusal("Hello"),
            "line 1: expected the dimension, found `Hello`",
        ),
        (
            spoilt(rover, "3\n4\n", "4\n4\n"),
            "line 1: problems live in 2 or 3 dimensions, found 4",
        ),
        (
            spoilt(rover, "3\n4\n", "5\n4\n"),
            "line 1: problems live in 2 or 3 dimensions, found 5",
        ),
        (
            spoilt(rover, "3\n4\n0\n", "3\n4\n7\n"),
            "line 3: the storage scheme 7 of a matrix is not known",
        ),
        (
            spoilt(rover, "3\n4\n", "3\n5\n"),
            "line 18: is 12 × 12, expected 15 × 15",
        ),
        (
            spoilt(rover, "12\t12", "12\t11"),
            "line 6: is 12 × 11, expected 12 × 12",
        ),
        (
            spoilt(rover, "1.399132380123367484781038e-02", "nan"),
            "line 7: expected an entry of a matrix, found `nan`",
        ),
        (
            spoilt(rover, "-9.255873583433080198368259e-02", "1e999"),
            "line 19: expected an entry of q, found `1e999`",
        ),
        (
            spoilt(rover, "6.999999999999999555910790e-01 \n1\n", ""),
            "line 20: the file ends where a friction coefficient should follow",
        ),
        (
            spoilt(rover, "6.999999999999999555910790e-01", "-0.7"),
            "`mu`: the friction coefficient of contact 0 is -0.7, expected a number ≥ 0",
        ),
        (
            spoilt(
                rover,
                "6.999999999999999555910790e-01 \n1\n",
                "0.7 \n1\n0.5",
            ),
            "line 22: expected the end of the file, found `0.5`",
        ),
        (
            spoilt("problem-check2.dat", "0\t1\t\n", "0\t2\t\n"),
            "line 13: pointers must rise from 0 to at most 1, found 2 at 1",
        ),
        (
            spoilt("problem-check2.dat", "0\t1\t\n0\t\n", "0\t1\t\n4\t\n"),
            "line 15: there is an entry (0, 4) in a matrix of 1 × 1, counted from 0",
        ),
        (
            spoilt("problem-check2.dat", "0\t1\t\n", "0\t0\t\n"),
            "line 13: has 0 values, expected 1",
        ),
        // Sizes that no memory holds are found out before any is asked for.
        (
            refusal(
                "3 1000000000000 0 3000000000000 3000000000000 3000000000000 3000000000000 1.0",
            ),
            "line 1: the file ends where an entry of a matrix should follow",
        ),
    ];
    for (found, expected) in cases {
        assert_eq!(found, expected);
    }
}

/// Whatever is cut off or replaced, the answer is a refusal with a place, or another problem in order;
/// never a panic.
#[test]
fn texts_cut_and_garbled_everywhere() {
    for name in ["problem-check2.dat", "FC2D_SliderCrankLagrangian00000.dat"] {
        let text = fs::read_to_string(data(name)).unwrap();
        let words: Vec<&str> = text.split_whitespace().collect();
        let needed = words.len() - usize::from(words.last() == Some(&"1"));
        for count in 0..needed {
            read_text(&words[..count].join(" ")).unwrap_err();
        }
        for (place, word) in (0..words.len()).flat_map(|i| ["7", "-1", "0", "x"].map(|w| (i, w))) {
            let mut garbled = words.clone();
            garbled[place] = word;
            let _ = read_text(&garbled.join(" "));
        }
    }
}

#[test]
fn no_file() {
    let error = read(&data("nothing.dat")).unwrap_err();
    assert!(matches!(error.fault(), FclibFault::Io(_)), "{error}");
}

#[test]
fn problems_that_do_not_fit_are_not_written() {
    let mut short = read(&data("Rover1039.dat")).unwrap();
    if let FclibProblem::Local(problem) = &mut short.problem {
        problem.q.pop();
    }
    let mut oblong: Document = lopsided();
    if let FclibProblem::Global(problem) = &mut oblong.problem {
        problem.h = FclibMatrix::new(2, 4, Vec::new()).unwrap();
    }
    let refused = |document: &Document| {
        let mut nothing = Vec::new();
        let error = document.write_dat(&mut nothing).unwrap_err();
        assert!(matches!(error, WriteError::Problem { .. }));
        assert!(nothing.is_empty());
        error.to_string()
    };
    assert_eq!(
        refused(&short),
        "the problem cannot be written: `q` has 11 values, expected 12"
    );
    assert_eq!(
        refused(&oblong),
        "the problem cannot be written: `H` is 2 × 4, expected 3 × 4"
    );
    assert_eq!(local(&short.problem).q.len(), 11);
}

#[cfg(not(feature = "fclib"))]
#[test]
fn hdf5_is_refused_by_name() {
    let error = read(&data("local_h5py.hdf5")).unwrap_err();
    assert!(matches!(error.fault(), FclibFault::WithoutHdf5), "{error}");
}
