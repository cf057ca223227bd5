//! Keys that are wrong: the report names the place and the keys that belong there.

use crate::support::{report, with};
use insta::assert_snapshot;

#[test]
fn a_misspelt_key_of_a_material() {
    let text = with("poisson = 0.277", "poissn = 0.277");
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × unknown key `poissn`
       ╭─[case.toml:6:29]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 5.0e4, poissn = 0.277 }
       ·                             ───┬──
       ·                                ╰── did you mean `poisson`?
     7 │
       ╰────
      help: the keys that belong here are `young`, `poisson` and `density`
    "#);
}

#[test]
fn an_unknown_key_of_the_file() {
    let text = with(
        "title = ",
        r#"author = "me"
title = "#,
    );
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × unknown key `author`
       ╭─[case.toml:1:1]
     1 │ author = "me"
       · ───┬──
       ·    ╰── not a key of this table
     2 │ title = "Two bricks with Tresca friction"
       ╰────
      help: the keys that belong here are `title`, `analysis`, `body`, `clamp`, `support`, `traction`,
            `pressure`, `body_force`, `gravity`, `force`, `obstacle`, `contact`, `step` and `solver`
    "#);
}

#[test]
fn a_misspelt_table() {
    let text = with("[[traction]]", "[[tractions]]");
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × unknown key `tractions`
        ╭─[case.toml:16:3]
     15 │
     16 │ [[tractions]]
        ·   ────┬────
        ·       ╰── did you mean `traction`?
     17 │ on = ["upper.z+", "upper.x-"]
        ╰────
      help: the keys that belong here are `title`, `analysis`, `body`, `clamp`, `support`, `traction`,
            `pressure`, `body_force`, `gravity`, `force`, `obstacle`, `contact`, `step` and `solver`
    "#);
}

#[test]
fn a_misspelt_key_of_a_brick() {
    let text = with("nodes = [16, 16, 16]", "node = [16, 16, 16]");
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × unknown key `node`
       ╭─[case.toml:5:66]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], node = [16, 16, 16] } }
       ·                                                                  ──┬─
       ·                                                                    ╰── did you mean `nodes`?
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: the keys that belong here are `min`, `max`, `nodes` and `cells`
    "#);
}

#[test]
fn a_misspelt_key_of_friction() {
    let text = with("bound = 0.09", "bond = 0.09");
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × unknown key `bond`
        ╭─[case.toml:22:30]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bond = 0.09 }
        ·                              ──┬─
        ·                                ╰── did you mean `bound`?
     23 │
        ╰────
      help: the keys that belong here are `law`, `bound`, `bounds`, `coefficient`, `coefficients`,
            `axis` and `limit`
    "#);
}

#[test]
fn a_misspelt_key_of_the_solver() {
    let text = with("tolerance = 1e-8", "tolerence = 1e-8");
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × unknown key `tolerence`
        ╭─[case.toml:26:1]
     25 │ method = "grssn"
     26 │ tolerence = 1e-8
        · ────┬────
        ·     ╰── did you mean `tolerance`?
        ╰────
      help: the keys that belong here are `method`, `tolerance` and `max_iterations`
    "#);
}

#[test]
fn a_missing_key() {
    let text = with("young = 5.0e4, ", "");
    assert_snapshot!(report(&text), @r#"
    case::missing_key

      × missing key `young`
       ╭─[case.toml:6:12]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { poisson = 0.277 }
       ·            ─────────┬─────────
       ·                     ╰── expected `young` in this table
     7 │
       ╰────
      help: the tables and their keys are listed in docs/case-file.md
    "#);
}

#[test]
fn a_missing_key_of_a_table_with_header() {
    let text = with(
        r#"name = "upper"
"#,
        "",
    );
    assert_snapshot!(report(&text), @r#"
    case::missing_key

      × missing key `name`
       ╭─[case.toml:3:1]
     2 │
     3 │ [[body]]
       · ────┬───
       ·     ╰── expected `name` in this table
     4 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
       ╰────
      help: the tables and their keys are listed in docs/case-file.md
    "#);
}

#[test]
fn single_brackets() {
    let text = with("[[clamp]]", "[clamp]");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a list
        ╭─[case.toml:13:1]
     12 │
     13 │ [clamp]
        · ───┬───
        ·    ╰── found a table
     14 │ on = ["upper.x+", "lower.x-"]
        ╰────
      help: entries of this kind start with double brackets, as in `[[body]]`
    "#);
}

#[test]
fn a_second_title() {
    let text = with(
        r#"title = "Two"#,
        r#"title = "One"
title = "Two"#,
    );
    assert_snapshot!(report(&text), @r#"
    case::duplicate

      × the same key or table stands here a second time
       ╭─[case.toml:2:1]
     1 │ title = "One"
     2 │ title = "Two bricks with Tresca friction"
       · ──┬──
       ·   ╰── already given above
     3 │
       ╰────
      help: a key is given once per table; entries of a list of tables each start with double
            brackets, as in `[[body]]`
    "#);
}

#[test]
fn a_word_that_is_no_choice() {
    let text = with(r#""grssn""#, r#""grsn""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × `grsn` is not among the choices here
        ╭─[case.toml:25:10]
     24 │ [solver]
     25 │ method = "grsn"
        ·          ───┬──
        ·             ╰── did you mean `grssn`?
     26 │ tolerance = 1e-8
        ╰────
      help: supported: `ssn`, `apgd` and `grssn`
    "#);
}
