//! Names that nothing answers to, and names given twice.

use crate::support::{report, with};
use insta::assert_snapshot;

#[test]
fn a_reference_to_an_unknown_body() {
    let text = with(r#""lower.x-""#, r#""lowr.x-""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_reference

      × there is no body `lowr`
        ╭─[case.toml:14:19]
     13 │ [[clamp]]
     14 │ on = ["upper.x+", "lowr.x-"]
        ·                   ────┬────
        ·                       ╰── did you mean `lower.x-`?
     15 │
        ╰────
      help: the bodies of this case are `upper` and `lower`
    "#);
}

#[test]
fn a_reference_to_an_unknown_body_unlike_any() {
    let text = with(r#""lower.x-""#, r#""wheel.x-""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_reference

      × there is no body `wheel`
        ╭─[case.toml:14:19]
     13 │ [[clamp]]
     14 │ on = ["upper.x+", "wheel.x-"]
        ·                   ─────┬────
        ·                        ╰── expected `body.face` of a body of this file
     15 │
        ╰────
      help: the bodies of this case are `upper` and `lower`
    "#);
}

#[test]
fn an_unknown_face() {
    let text = with(r#""lower.x-""#, r#""lower.left""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_reference

      × the body `lower` has no face `left`
        ╭─[case.toml:14:19]
     13 │ [[clamp]]
     14 │ on = ["upper.x+", "lower.left"]
        ·                   ──────┬─────
        ·                         ╰── expected a face of a brick
     15 │
        ╰────
      help: the faces of a brick are `x-`, `x+`, `y-`, `y+`, `z-` and `z+`
    "#);
}

#[test]
fn a_misspelt_face() {
    let text = with(r#""lower.x-""#, r#""lower.xx-""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_reference

      × the body `lower` has no face `xx-`
        ╭─[case.toml:14:19]
     13 │ [[clamp]]
     14 │ on = ["upper.x+", "lower.xx-"]
        ·                   ─────┬─────
        ·                        ╰── did you mean `lower.x-`?
     15 │
        ╰────
      help: the faces of a brick are `x-`, `x+`, `y-`, `y+`, `z-` and `z+`
    "#);
}

#[test]
fn a_reference_without_dot() {
    let text = with(r#""lower.x-""#, r#""lower""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_reference

      × `lower` is not the name of a surface
        ╭─[case.toml:14:19]
     13 │ [[clamp]]
     14 │ on = ["upper.x+", "lower"]
        ·                   ───┬───
        ·                      ╰── expected `body.face`, found no dot
     15 │
        ╰────
      help: surfaces are written with body and face, as in `upper.z-`
    "#);
}

#[test]
fn two_bodies_of_the_same_name() {
    let text = with(r#""lower""#, r#""upper""#);
    assert_snapshot!(report(&text), @r#"
    case::duplicate

      × two bodies are called `upper`
        ╭─[case.toml:9:8]
      3 │ [[body]]
      4 │ name = "upper"
        ·        ───┬───
        ·           ╰── the first one
      5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
      6 │ material = { young = 5.0e4, poisson = 0.277 }
      7 │
      8 │ [[body]]
      9 │ name = "upper"
        ·        ───┬───
        ·           ╰── the second one
     10 │ mesh = { brick = { min = [0.0, 0.0, 0.0], max = [2.0, 1.0, 1.0], nodes = [16, 16, 16] } }
        ╰────
      help: give each body its own name; upper and lower case count as equal, for the names become
            names of files
    "#);
}

#[test]
fn a_name_that_is_taken() {
    let text = with(r#""lower""#, r#""Contact""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × this cannot be the name of a body
        ╭─[case.toml:9:8]
      8 │ [[body]]
      9 │ name = "Contact"
        ·        ────┬────
        ·            ╰── this name is taken by another file of the results
     10 │ mesh = { brick = { min = [0.0, 0.0, 0.0], max = [2.0, 1.0, 1.0], nodes = [16, 16, 16] } }
        ╰────
      help: surfaces are written `body.face`, and the results of a body go to the file `body.vtu`
    "#);
}

#[test]
fn a_name_with_a_dot() {
    let text = with(r#""lower""#, r#""lower.part""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × this cannot be the name of a body
        ╭─[case.toml:9:8]
      8 │ [[body]]
      9 │ name = "lower.part"
        ·        ──────┬─────
        ·              ╰── expected letters, digits, `_` and `-`, found `.`
     10 │ mesh = { brick = { min = [0.0, 0.0, 0.0], max = [2.0, 1.0, 1.0], nodes = [16, 16, 16] } }
        ╰────
      help: surfaces are written `body.face`, and the results of a body go to the file `body.vtu`
    "#);
}

#[test]
fn an_empty_name() {
    let text = with(r#""lower""#, r#""""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × this cannot be the name of a body
        ╭─[case.toml:9:8]
      8 │ [[body]]
      9 │ name = ""
        ·        ─┬
        ·         ╰── expected a name, found an empty text
     10 │ mesh = { brick = { min = [0.0, 0.0, 0.0], max = [2.0, 1.0, 1.0], nodes = [16, 16, 16] } }
        ╰────
      help: surfaces are written `body.face`, and the results of a body go to the file `body.vtu`
    "#);
}

#[test]
fn an_empty_list() {
    let text = with(r#"["upper.x+", "lower.x-"]"#, "[]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the list of surfaces is empty
        ╭─[case.toml:14:6]
     13 │ [[clamp]]
     14 │ on = []
        ·      ─┬
        ·       ╰── expected at least one `body.face`
     15 │
        ╰────
      help: remove the whole table if it is not wanted
    "#);
}

#[test]
fn a_surface_listed_twice() {
    let text = with(r#"["upper.x+", "lower.x-"]"#, r#"["upper.x+", "upper.x+"]"#);
    assert_snapshot!(report(&text), @r#"
    case::duplicate

      × this surface is listed twice
        ╭─[case.toml:14:19]
     13 │ [[clamp]]
     14 │ on = ["upper.x+", "upper.x+"]
        ·       ─────┬────  ─────┬────
        ·            │           ╰── the second time
        ·            ╰── the first time
     15 │
        ╰────
      help: remove one of the two, or correct it
    "#);
}

#[test]
fn a_pair_of_one_surface() {
    let text = with(r#"["upper.z-", "lower.z+"]"#, r#"["upper.z-", "upper.z-"]"#);
    assert_snapshot!(report(&text), @r#"
    case::duplicate

      × a surface cannot be in contact with itself
        ╭─[case.toml:21:21]
     20 │ [[contact]]
     21 │ pair = ["upper.z-", "upper.z-"]
        ·         ─────┬────  ─────┬────
        ·              │           ╰── expected another surface than the first
        ·              ╰── the first
     22 │ friction = { law = "tresca", bound = 0.09 }
        ╰────
      help: a pair names the two surfaces that face each other
    "#);
}

#[test]
fn a_pair_of_three() {
    let text = with(
        r#"["upper.z-", "lower.z+"]"#,
        r#"["upper.z-", "lower.z+", "lower.z-"]"#,
    );
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × a contact pair has two surfaces
        ╭─[case.toml:21:8]
     20 │ [[contact]]
     21 │ pair = ["upper.z-", "lower.z+", "lower.z-"]
        ·        ──────────────────┬─────────────────
        ·                          ╰── expected 2 entries, found 3
     22 │ friction = { law = "tresca", bound = 0.09 }
        ╰────
      help: write `pair = ["slave.face", "master.face"]`; more pairs get their own [[contact]]
    "#);
}

#[test]
fn the_same_pair_twice() {
    let text = with(
        "[solver]",
        r#"[[contact]]
pair = ["lower.z+", "upper.z-"]
friction = { law = "tresca", bound = 0 }

[solver]"#,
    );
    assert_snapshot!(report(&text), @r#"
    case::duplicate

      × these two surfaces are already a contact pair
        ╭─[case.toml:25:8]
     20 │ [[contact]]
     21 │ pair = ["upper.z-", "lower.z+"]
        ·        ────────────┬───────────
        ·                    ╰── the first time
     22 │ friction = { law = "tresca", bound = 0.09 }
     23 │
     24 │ [[contact]]
     25 │ pair = ["lower.z+", "upper.z-"]
        ·        ────────────┬───────────
        ·                    ╰── the second time
     26 │ friction = { law = "tresca", bound = 0 }
        ╰────
      help: a pair stands in one [[contact]] only: a second one would constrain the same points again
    "#);
}
