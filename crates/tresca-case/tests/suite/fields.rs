//! Expressions and tables of values in a case file: where their faults are.

use std::fs;

use insta::assert_snapshot;
use tresca_case::Case;

use crate::support::{
    PLANE, RICH, Solver, at, bound as bound_of, changed, constant, render_in, report, with,
};

fn bound(text: &str) -> String {
    with("0.09", text)
}

#[test]
fn an_expression_without_variables_is_a_number() {
    let case = crate::support::parse(&bound("\"2*pi\"")).unwrap();
    let bound = bound_of(&case.model.contacts()[0].friction);
    assert_eq!(constant(bound), Some(2.0 * std::f64::consts::PI));
}

#[test]
fn an_unknown_name_in_an_expression() {
    assert_snapshot!(report(&bound("\"0.09*(1 + r)\"")), @r#"
    case::bad_value

      × `r` has no meaning in an expression
        ╭─[case.toml:22:49]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = "0.09*(1 + r)" }
        ·                                                 ┬
        ·                                                 ╰── expected a variable, a constant or a function
     23 │
        ╰────
      help: known are `x`, `y`, `z`, `pi`, `e`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `sinh`,
            `cosh`, `tanh`, `exp`, `ln`, `log10`, `sqrt`, `cbrt`, `abs`, `floor`, `ceil`, `sign`,
            `heaviside`, `atan2`, `hypot`, `min` and `max`
    "#);
}

#[test]
fn a_misspelt_function() {
    assert_snapshot!(report(&bound("\"0.09*sine(x)\"")), @r#"
    case::bad_value

      × `sine` has no meaning in an expression
        ╭─[case.toml:22:44]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = "0.09*sine(x)" }
        ·                                            ──┬─
        ·                                              ╰── did you mean `sin`?
     23 │
        ╰────
      help: known are `x`, `y`, `z`, `pi`, `e`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `sinh`,
            `cosh`, `tanh`, `exp`, `ln`, `log10`, `sqrt`, `cbrt`, `abs`, `floor`, `ceil`, `sign`,
            `heaviside`, `atan2`, `hypot`, `min` and `max`
    "#);
}

#[test]
fn a_fault_behind_an_escape_is_shown_as_the_whole() {
    assert_snapshot!(report(&bound("\"0.09*\\u0071(x)\"")), @r#"
    case::bad_value

      × `q` has no meaning in an expression
        ╭─[case.toml:22:38]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = "0.09*\u0071(x)" }
        ·                                      ────────┬───────
        ·                                              ╰── expected a variable, a constant or a function
     23 │
        ╰────
      help: known are `x`, `y`, `z`, `pi`, `e`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `sinh`,
            `cosh`, `tanh`, `exp`, `ln`, `log10`, `sqrt`, `cbrt`, `abs`, `floor`, `ceil`, `sign`,
            `heaviside`, `atan2`, `hypot`, `min` and `max`
    "#);
}

#[test]
fn a_constant_expression_that_is_negative() {
    assert_snapshot!(report(&bound("\"1 - 2\"")), @r#"
    case::bad_value

      × the slip bound must not be negative
        ╭─[case.toml:22:38]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = "1 - 2" }
        ·                                      ───┬───
        ·                                         ╰── expected 0 or more, found -1.0
     23 │
        ╰────
      help: it is the tangential traction (force per area) at which the pair slides; 0.0 is no
            friction
    "#);
}

#[test]
fn a_constant_expression_that_is_not_finite() {
    assert_snapshot!(report(&bound("\"1/0\"")), @r#"
    case::bad_value

      × the slip bound is not a finite number
        ╭─[case.toml:22:38]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = "1/0" }
        ·                                      ──┬──
        ·                                        ╰── the value of this expression is inf
     23 │
        ╰────
      help: this comes from a division by 0, or a function outside its domain
    "#);
}

#[test]
fn a_bound_that_is_true() {
    assert_snapshot!(report(&bound("true")), @r#"
    case::wrong_type

      × expected a number, or an expression in quotes
        ╭─[case.toml:22:38]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = true }
        ·                                      ──┬─
        ·                                        ╰── found true
     23 │
        ╰────
    "#);
}

#[test]
fn a_table_with_another_key() {
    assert_snapshot!(report(&bound("{ path = \"bounds.csv\" }")), @r#"
    case::unknown_key

      × unknown key `path`
        ╭─[case.toml:22:40]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = { path = "bounds.csv" } }
        ·                                        ──┬─
        ·                                          ╰── not a key of this table
     23 │
        ╰────
      help: the only key that belongs here is `file`
    "#);
}

#[test]
fn a_gap_from_a_file() {
    assert_snapshot!(report(&changed(RICH, "\"0.001*x\"", "{ file = \"gap.csv\" }")), @r#"
    case::wrong_type

      × the gap cannot come from a file
        ╭─[case.toml:58:7]
     57 │ friction = { law = "tresca", bound = 0.09 }
     58 │ gap = { file = "gap.csv" }
        ·       ──────────┬─────────
        ·                 ╰── expected a number, or an expression in quotes
     59 │
        ╰────
      help: slip bounds are the fields that may come from a file
    "#);
}

/// The report on a case beside a table of values; paths of the directory are taken out.
fn report_with_table(case: &str, table: &str) -> String {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("case.toml"), case).unwrap();
    fs::write(directory.path().join("bounds.csv"), table).unwrap();
    let error = Case::<Solver>::load_with(directory.path().join("case.toml"))
        .map(|_| ())
        .unwrap_err();
    let path = directory.path().display().to_string();
    render_in(1000, &error).replace(&format!("{path}{}", std::path::MAIN_SEPARATOR), "")
}

fn bad_table(table: &str) -> String {
    let report = report_with_table(&bound("{ file = \"bounds.csv\" }"), table);
    let fact = report.lines().find(|line| line.contains('×')).unwrap();
    let label = report.lines().find(|line| line.contains("╰──")).unwrap();
    let label = label.split("╰──").nth(1).unwrap();
    format!("{} ({})", fact.trim_start_matches([' ', '×']), label.trim())
}

#[test]
fn values_come_from_a_table_beside_the_case() {
    let directory = tempfile::tempdir().unwrap();
    let case = directory.path().join("case.toml");
    fs::write(&case, bound("{ file = \"tables/bounds.csv\" }")).unwrap();
    fs::create_dir(directory.path().join("tables")).unwrap();
    let table = "\u{feff}x, y, z, value\r\n0,0,1,0.1\r\n2, 0, 1, 2e-1\r\n0,1,1,0\n\n2,0,1,0.3\n";
    fs::write(directory.path().join("tables/bounds.csv"), table).unwrap();
    let case = Case::<Solver>::load_with(&case).unwrap();
    let bound = bound_of(&case.model.contacts()[0].friction);
    let at = |point| at(bound, point);
    assert_eq!(constant(bound), None);
    assert_eq!(at([0.1, 0.1, 1.0]), 0.1);
    assert_eq!(at([0.0, 0.9, 1.0]), 0.0);
    // Two rows at the same point: the first counts.
    assert_eq!(at([5.0, 0.0, -3.0]), 0.2);
    // Halfway between two points, too.
    assert_eq!(at([1.0, 0.0, 1.0]), 0.1);
    assert!(at([f64::NAN, 0.0, 0.0]).is_nan());
}

/// Against the plain search through all rows.
#[test]
fn the_nearest_row_is_found_among_many() {
    let mut state = 1_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        // Few different coordinates, so that many rows are equally near.
        ((state >> 40) % 8) as f64 / 4.0
    };
    let rows: Vec<[f64; 4]> = (0..400)
        .map(|i| [random(), random(), random(), f64::from(i)])
        .collect();
    let mut table = "x,y,z,value\n".to_owned();
    for [x, y, z, value] in &rows {
        table.push_str(&format!("{x},{y},{z},{value}\n"));
    }
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("bounds.csv"), table).unwrap();
    let path = directory.path().join("case.toml");
    fs::write(&path, bound("{ file = \"bounds.csv\" }")).unwrap();
    let case = Case::<Solver>::load_with(&path).unwrap();
    let bound = bound_of(&case.model.contacts()[0].friction);
    for _ in 0..500 {
        let p = [random() + 0.125, random(), random()];
        let distance = |row: &[f64; 4]| (0..3).map(|i| (row[i] - p[i]).powi(2)).sum::<f64>();
        let mut best = &rows[0];
        for row in &rows {
            if distance(row) < distance(best) {
                best = row;
            }
        }
        assert_eq!(at(bound, p), best[3]);
    }
}

#[test]
fn a_table_in_the_plane_has_two_coordinates() {
    let case = changed(
        PLANE,
        r#"{ law = "coulomb", coefficient = 0.3 }"#,
        r#"{ law = "tresca", bound = { file = "bounds.csv" } }"#,
    );
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("case.toml"), &case).unwrap();
    fs::write(
        directory.path().join("bounds.csv"),
        "x,y,value\n0,0,1\n2,0,3\n",
    )
    .unwrap();
    let read = Case::<Solver>::load_with(directory.path().join("case.toml")).unwrap();
    let bound = bound_of(&read.model.contacts()[0].friction);
    assert_eq!(at(bound, [1.5, 0.0, 0.0]), 3.0);
    assert!(
        report_with_table(&case, "x,y,z,value\n0,0,0,1\n")
            .contains("expected the header `x,y,value`")
    );
}

#[test]
fn a_fault_in_a_table_is_shown_with_its_line() {
    let table = "x,y,z,value\n0,0,1,0.1\n0,0,a,0.1\n";
    assert_snapshot!(report_with_table(&bound("{ file = \"bounds.csv\" }"), table), @r#"
    case::bad_file

      × bounds.csv:3: expected a finite number for z, found `a`
        ╭─[case.toml:22:47]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = { file = "bounds.csv" } }
        ·                                               ──────┬─────
        ·                                                     ╰── an entry of this file is no number
     23 │
        ╰────
      help: a table of values is a CSV file with the header `x,y,z,value`
    "#);
}

#[test]
fn faults_of_tables() {
    assert_snapshot!(bad_table(""), @"bounds.csv:1: expected at least one row of values behind the header (this file has no values)");
    assert_snapshot!(bad_table("x,y,z,value\n"), @"bounds.csv:1: expected at least one row of values behind the header (this file has no values)");
    assert_snapshot!(bad_table("0,0,1,0.1\n"), @"bounds.csv:1: expected the header `x,y,z,value`, found `0,0,1,0.1` (the header of this file is wrong)");
    assert_snapshot!(bad_table("x,y,z,bound\n0,0,1,0.1\n"), @"bounds.csv:1: expected the header `x,y,z,value`, found `x,y,z,bound` (the header of this file is wrong)");
    assert_snapshot!(bad_table("x,y,z,value\n0,0,1\n"), @"bounds.csv:2: expected 4 entries, found 3 (a row of this file has the wrong length)");
    assert_snapshot!(bad_table("x,y,z,value\n\n0,0,1,0.1,5\n"), @"bounds.csv:3: expected 4 entries, found 5 (a row of this file has the wrong length)");
    assert_snapshot!(bad_table("x,y,z,value\n0,0,1,0.1\n0,0,1,-0.1\n"), @"bounds.csv:3: the slip bound must not be negative, found -0.1 (a value of this file is negative)");
    assert_snapshot!(bad_table("x,y,z,value\n0,0,1,nan\n"), @"bounds.csv:2: expected a finite number for value, found `nan` (an entry of this file is no number)");
    assert_snapshot!(bad_table("x,y,z,value\n0,0,inf,1\n"), @"bounds.csv:2: expected a finite number for z, found `inf` (an entry of this file is no number)");
    assert_snapshot!(bad_table("x;y;z;value\n0;0;1;0,1\n"), @"bounds.csv:1: expected the header `x,y,z,value`, found `x;y;z;value` (the header of this file is wrong)");
}

#[test]
fn a_table_that_is_not_there() {
    let report = report_with_table(&bound("{ file = \"bound.csv\" }"), "");
    assert!(report.contains("cannot read `bound.csv`"), "{report}");
    assert!(report.contains("case::bad_file"), "{report}");
}
