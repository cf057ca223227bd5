//! Values of the wrong type, and text that is no TOML.

use crate::support::{report, with};
use insta::assert_snapshot;

#[test]
fn a_number_in_quotes() {
    let text = with("0.277", r#""0.277""#);
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a number
       ╭─[case.toml:6:39]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 5.0e4, poisson = "0.277" }
       ·                                       ───┬───
       ·                                          ╰── found the text "0.277"
     7 │
       ╰────
      help: numbers stand without quotes: 0.277
    "#);
}

#[test]
fn a_text_for_a_number() {
    let text = with("0.277", r#""steel""#);
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a number
       ╭─[case.toml:6:39]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 5.0e4, poisson = "steel" }
       ·                                       ───┬───
       ·                                          ╰── found the text "steel"
     7 │
       ╰────
      help: numbers are written as in 0.3, 16 or 5.0e4
    "#);
}

#[test]
fn a_fraction_of_a_node() {
    let text = with("[16, 16, 16]", "[16.0, 16, 16]");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a whole number, 0 or more
       ╭─[case.toml:5:75]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16.0, 16, 16] } }
       ·                                                                           ──┬─
       ·                                                                             ╰── found the number 16.0
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: counts are written without decimal point or exponent
    "#);
}

#[test]
fn a_negative_number_of_nodes() {
    let text = with("[16, 16, 16]", "[16, -16, 16]");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a whole number, 0 or more
       ╭─[case.toml:5:79]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, -16, 16] } }
       ·                                                                               ─┬─
       ·                                                                                ╰── found the number -16
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
    "#);
}

#[test]
fn a_text_for_a_list() {
    let text = with(r#"["upper.x+", "lower.x-"]"#, r#""upper.x+""#);
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a list
        ╭─[case.toml:14:6]
     13 │ [[clamp]]
     14 │ on = "upper.x+"
        ·      ─────┬────
        ·           ╰── found the text "upper.x+"
     15 │
        ╰────
      help: a list has brackets, also with one entry: ["upper.x+"]
    "#);
}

#[test]
fn a_number_for_a_name() {
    let text = with(r#""upper""#, "7");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a text in quotes
       ╭─[case.toml:4:8]
     3 │ [[body]]
     4 │ name = 7
       ·        ┬
       ·        ╰── found the number 7
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
       ╰────
    "#);
}

#[test]
fn two_coordinates() {
    let text = with("[2.0, 1.0, 2.0]", "[2.0, 1.0]");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × a list of the wrong length
       ╭─[case.toml:5:49]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0], nodes = [16, 16, 16] } }
       ·                                                 ─────┬────
       ·                                                      ╰── expected a list of three numbers [x, y, z], found 2 entries
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
    "#);
}

#[test]
fn four_coordinates() {
    let text = with("[2.0, 1.0, 2.0]", "[2.0, 1.0, 2.0, 3.0]");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × a list of the wrong length
       ╭─[case.toml:5:49]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0, 3.0], nodes = [16, 16, 16] } }
       ·                                                 ──────────┬─────────
       ·                                                           ╰── expected a list of three numbers [x, y, z], found 4 entries
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
    "#);
}

#[test]
fn a_list_for_a_table() {
    let text = with("{ young = 5.0e4, poisson = 0.277 }", "[5.0e4, 0.277]");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a table of keys for `material`
       ╭─[case.toml:6:12]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = [5.0e4, 0.277]
       ·            ───────┬──────
       ·                   ╰── found a list
     7 │
       ╰────
      help: a table has braces and names its values: { key = value, … }
    "#);
}

#[test]
fn a_number_for_a_table() {
    let text = with("{ young = 5.0e4, poisson = 0.277 }", "5.0e4");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a table `{ young = …, poisson = … }`
       ╭─[case.toml:6:12]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = 5.0e4
       ·            ──┬──
       ·              ╰── found the number 5.0e4
     7 │
       ╰────
    "#);
}

#[test]
fn a_text_for_a_mesh() {
    let text = with(
        "{ brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }",
        r#""part.msh""#,
    );
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a table `{ brick = { … } }`, `{ rectangle = { … } }` or `{ file = "….msh" }`
       ╭─[case.toml:5:8]
     4 │ name = "upper"
     5 │ mesh = "part.msh"
       ·        ─────┬────
       ·             ╰── found the text "part.msh"
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: a file is given in a table: { file = "part.msh" }
    "#);
}

#[test]
fn two_meshes() {
    let text = with(
        "nodes = [16, 16, 16] } }",
        "nodes = [16, 16, 16] }, brick2 = 3 }",
    );
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × unknown key `brick2`
       ╭─[case.toml:5:90]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] }, brick2 = 3 }
       ·                                                                                          ───┬──
       ·                                                                                             ╰── did you mean `brick`?
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: the keys that belong here are `brick`, `rectangle`, `file`, `part`, `scale`, `rotate` and
            `translate`
    "#);
}

#[test]
fn a_bracket_not_closed() {
    let text = with("[2.0, 1.0, 2.0]", "[2.0, 1.0, 2.0");
    assert_snapshot!(report(&text), @r#"
    case::syntax

      × the case file is not valid TOML
       ╭─[case.toml:5:71]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0, nodes = [16, 16, 16] } }
       ·                                                                       ┬
       ·                                                                       ╰── unexpected `=` in array, expected value, `]`
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: keys are written `key = value`, texts stand in "quotes", lists in [brackets] and inline
            tables in {braces}, each closed; see https://toml.io
    "#);
}

#[test]
fn quotes_not_closed() {
    let text = with(r#""upper""#, r#""upper"#);
    assert_snapshot!(report(&text), @r#"
    case::syntax

      × the case file is not valid TOML
       ╭─[case.toml:4:14]
     3 │ [[body]]
     4 │ name = "upper
       ·              ▲
       ·              ╰── invalid basic string, expected `"`
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
       ╰────
      help: keys are written `key = value`, texts stand in "quotes", lists in [brackets] and inline
            tables in {braces}, each closed; see https://toml.io
    "#);
}

#[test]
fn a_value_without_quotes() {
    let text = with(r#""upper""#, "upper");
    assert_snapshot!(report(&text), @r#"
    case::syntax

      × the case file is not valid TOML
       ╭─[case.toml:4:8]
     3 │ [[body]]
     4 │ name = upper
       ·        ──┬──
       ·          ╰── string values must be quoted, expected literal string
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
       ╰────
      help: keys are written `key = value`, texts stand in "quotes", lists in [brackets] and inline
            tables in {braces}, each closed; see https://toml.io
    "#);
}

#[test]
fn a_decimal_comma() {
    let text = with("0.277", "0,277");
    assert_snapshot!(report(&text), @r#"
    case::syntax

      × the case file is not valid TOML
       ╭─[case.toml:6:45]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 5.0e4, poisson = 0,277 }
       ·                                             ▲
       ·                                             ╰── unexpected behind a comma between digits
     7 │
       ╰────
      help: decimals are written with a point, as in 0.277
    "#);
}

#[test]
fn a_column_behind_an_umlaut() {
    let text = with("lower.x-", "lower.left").replace("upper", "größe");
    assert_snapshot!(report(&text), @r#"
    case::bad_reference

      × the body `lower` has no face `left`
        ╭─[case.toml:14:19]
     13 │ [[clamp]]
     14 │ on = ["größe.x+", "lower.left"]
        ·                   ──────┬─────
        ·                         ╰── expected a face of a brick
     15 │
        ╰────
      help: the faces of a brick are `x-`, `x+`, `y-`, `y+`, `z-` and `z+`
    "#);
}
