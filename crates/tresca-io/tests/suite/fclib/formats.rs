//! The ways in which Siconos writes a matrix, and our own text.

use tresca_io::fclib::{Document, FclibMatrix, FclibProblem, LocalProblem};

use super::{local, lopsided, matrix, read_text};

/// The rest of a plane problem with one contact.
const REST: &str = "1.0 2.0\n 0.5\n";

#[test]
fn dense_and_block_matrices_run_by_columns() {
    let expected = matrix(&[[1.0, 3.0], [2.0, 4.0]]);
    let dense = format!("2 1 0 2 2 2 2 1.0 2.0 3.0 4.0 {REST}");
    assert_eq!(local(&read_text(&dense).unwrap().problem).w, expected);

    let blocks =
        format!("2 1 1 2 2\n1 1 1\n2\t\n2\t\n2\n1\n0\t1\t\n0\t\n0\n1.\n2.\n3.\n4.\n{REST}");
    assert_eq!(local(&read_text(&blocks).unwrap().problem).w, expected);
}

#[test]
fn blocks_stand_where_their_pointers_say() {
    // Rows and columns cut after 1 and 4; blocks (0, 1) of 1 × 3 and (1, 0) of 3 × 1.
    let text = "2 2 1 4 4\n2 2 2\n1 4\n1 4\n3\n2\n0 1 2\n1 0\n\
                0\n10. 20. 30.\n1\n40. 50. 60.\n0. 0. 0. 0.\n0.5 0.5";
    let expected = matrix(&[
        [0.0, 10.0, 20.0, 30.0],
        [40.0, 0.0, 0.0, 0.0],
        [50.0, 0.0, 0.0, 0.0],
        [60.0, 0.0, 0.0, 0.0],
    ]);
    assert_eq!(local(&read_text(text).unwrap().problem).w, expected);
}

#[test]
fn sparse_matrices_are_what_csparse_prints() {
    let expected = matrix(&[[856.713, 0.0], [-454.43, 2.5]]);
    let version = "CSparse Version 3.1.9, May 4, 2016.  Copyright (c) Timothy A. Davis, 2006-2016";
    for origin in ["", "2\n"] {
        let columns = format!(
            "2\n1\n2\n2\n2\n{origin}{version}\n2-by-2, nzmax: 3 nnz: 3, 1-norm: 1311.14\n\
             \x20   col 0 : locations 0 to 1\n      0 : 856.713\n      1 : -454.43\n\
             \x20   col 1 : locations 2 to 2\n      1 : 2.5\n{REST}"
        );
        assert_eq!(local(&read_text(&columns).unwrap().problem).w, expected);
        let triplets = format!(
            "2\n1\n2\n2\n2\n{origin}{version}\ntriplet: 2-by-2, nzmax: 8 nnz: 3\n\
             \x20   1 1 : 2.5\n    0 0 : 856.713\n    1 0 : -454.43\n{REST}"
        );
        assert_eq!(local(&read_text(&triplets).unwrap().problem).w, expected);
    }
}

#[test]
fn an_empty_first_column_ends_at_minus_one() {
    let text = format!(
        "2 1 2 2 2\nCSparse\n2-by-2, nzmax: 1 nnz: 1, 1-norm: 2.5\n\
         col 0 : locations 0 to -1\ncol 1 : locations 0 to 0\n1 : 2.5\n{REST}"
    );
    let expected = matrix(&[[0.0, 0.0], [0.0, 2.5]]);
    assert_eq!(local(&read_text(&text).unwrap().problem).w, expected);
}

#[test]
fn a_written_text_reads_back_to_the_same_bits() {
    let sparse: Vec<_> = (0..30).map(|i| (i, i, 1.0 / (i + 3) as f64)).collect();
    let diagonal: Document = FclibProblem::Local(LocalProblem {
        dimension: 3,
        w: FclibMatrix::new(30, 30, sparse).unwrap(),
        q: (0..30).map(|i| (i as f64).sin()).collect(),
        friction: vec![0.7; 10],
    })
    .into();
    for document in [lopsided(), diagonal] {
        let mut text = Vec::new();
        document.write_dat(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(read_text(&text).unwrap(), document, "{text}");
    }
}
