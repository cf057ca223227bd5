//! Files that cannot be read at all.

use std::fs;

use insta::assert_snapshot;

use tresca_case::Case;

use crate::support::{GOOD, Solver, render_in};

/// The report on a file in a fresh directory, whose path is taken out of the text.
fn report(files: &[(&str, &[u8])], wanted: &str) -> String {
    let directory = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        fs::write(directory.path().join(name), bytes).unwrap();
    }
    let error = Case::<Solver>::load_with(directory.path().join(wanted)).map(|_| ());
    // Wide enough for no line to break, for the path has any length.
    let report = render_in(1000, &error.unwrap_err());
    let path = directory.path().display().to_string();
    report.replace(&format!("{path}{}", std::path::MAIN_SEPARATOR), "")
}

#[test]
fn a_good_file_is_read() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("two-bricks.toml");
    fs::write(&path, GOOD.replace("title", "# title")).unwrap();
    let case = Case::<Solver>::load_with(&path).unwrap();
    assert_eq!(case.model.title(), "two-bricks");
    assert_eq!(case.source.name(), path.display().to_string());
}

#[test]
fn a_missing_file() {
    assert_snapshot!(report(&[], "case.toml"), @r#"
    case::unreadable

      × cannot read the case file `case.toml`: there is no such file
      help: a path that does not start at the root counts from the current directory
    "#);
}

#[test]
fn a_missing_file_beside_one_of_a_similar_name() {
    let files: &[(&str, &[u8])] = &[("two-bricks.toml", b""), ("hertz.toml", b"")];
    assert_snapshot!(report(files, "two-brick.toml"), @r#"
    case::unreadable

      × cannot read the case file `two-brick.toml`: there is no such file
      help: did you mean `two-bricks.toml`?
    "#);
}

#[test]
fn a_missing_file_in_a_missing_directory() {
    assert_snapshot!(report(&[], "cases/case.toml"), @r#"
    case::unreadable

      × cannot read the case file `cases/case.toml`: there is no such file
      help: there is no directory `cases` either
    "#);
}

#[test]
fn a_directory() {
    assert_snapshot!(report(&[], "."), @r#"
    case::unreadable

      × cannot read the case file `.`: it is a directory
      help: name the case file inside it, such as `case.toml`
    "#);
}

#[test]
fn bytes_that_are_no_text() {
    let bytes = b"title = \"a\"\n[[body]]\nname = \"gr\xf6sse\"\n";
    assert_snapshot!(report(&[("case.toml", bytes)], "case.toml"), @r#"
    case::not_text

      × the case file `case.toml` is not UTF-8 text: line 3, column 11 holds the byte 0xf6
      help: save the file as UTF-8; a case file is plain text in the TOML format
    "#);
}

#[test]
fn an_empty_file() {
    assert_snapshot!(report(&[("case.toml", b"")], "case.toml"), @r#"
    case::missing_key

      × the case has no body
       ╭─[case.toml:1:1]
       ╰────
      help: a body is a table [[body]] with the keys `name`, `mesh` and `material`
    "#);
}
