//! Load steps: names that do not answer, and amounts that do not fit.

use super::*;

#[test]
fn an_unknown_name() {
    assert_snapshot!(report(&rich("{ push = 0.5 }", "{ psh = 0.5 }")), @r#"
    case::bad_reference

      × no support, load, obstacle or contact is called `psh`
        ╭─[case.toml:82:13]
     81 │ name = "first"
     82 │ factors = { psh = 0.5 }
        ·             ─┬─
        ·              ╰── did you mean `push`?
     83 │
        ╰────
      help: the names of this case are `drag`, `push`, `wave`, `water`, `wind`, `swirl`, `weight`,
            `joint`, `grain`, `rub`, `rail` and `glue`
    "#);
}

#[test]
fn a_name_where_there_are_none() {
    let text = format!("{GOOD}[[step]]\nfactors = {{ load = 2 }}\n");
    assert_snapshot!(report(&text), @r#"
    case::bad_reference

      × no support, load, obstacle or contact is called `load`
        ╭─[case.toml:28:13]
     27 │ [[step]]
     28 │ factors = { load = 2 }
        ·             ──┬─
        ·               ╰── expected the `name` of a support, load, obstacle or contact
        ╰────
      help: none of them has a name in this file: give it a key `name`
    "#);
}

#[test]
fn a_factor_and_a_value_of_the_same() {
    assert_snapshot!(report(&rich("factors = { wave = 2,", "factors = { push = 2,")), @r#"
    case::duplicate

      × `push` has both a factor and a value in this step
        ╭─[case.toml:87:12]
     85 │ increments = 2
     86 │ factors = { push = 2, joint = 0.5 }
        ·             ──┬─
        ·               ╰── the factor
     87 │ values = { push = [0, 0, -3], drag = { z = 1 } }
        ·            ──┬─
        ·              ╰── the value
        ╰────
      help: remove one of the two
    "#);
}

#[test]
fn a_factor_that_is_nan() {
    assert_snapshot!(report(&rich("{ push = 0.5 }", "{ push = nan }")), @r#"
    case::bad_value

      × the factor is not a finite number
        ╭─[case.toml:82:20]
     81 │ name = "first"
     82 │ factors = { push = nan }
        ·                    ─┬─
        ·                     ╰── expected a finite number, found NaN
     83 │
        ╰────
      help: TOML knows the words `nan` and `inf`; a case file takes numbers only
    "#);
}

#[test]
fn a_factor_in_a_list() {
    assert_snapshot!(report(&rich("{ push = 0.5 }", "{ push = [0.5] }")), @r#"
    case::wrong_type

      × expected a number
        ╭─[case.toml:82:20]
     81 │ name = "first"
     82 │ factors = { push = [0.5] }
        ·                    ──┬──
        ·                      ╰── found a list
     83 │
        ╰────
    "#);
}

#[test]
fn factors_in_a_list() {
    assert_snapshot!(report(&rich("{ push = 0.5 }", "[0.5]")), @r#"
    case::wrong_type

      × expected a table of keys for `factors`
        ╭─[case.toml:82:11]
     81 │ name = "first"
     82 │ factors = [0.5]
        ·           ──┬──
        ·             ╰── found a list
     83 │
        ╰────
      help: a table has braces and names its values: { key = value, … }
    "#);
}

/// Names are the user's: those of our tables are not special among them.
#[test]
fn names_may_be_words_of_ours() {
    let text = RICH.replace("push", "material");
    let renamed = parse(&text).unwrap();
    assert_eq!(renamed.model.steps(), parse(RICH).unwrap().model.steps());
}

#[test]
fn a_factor_of_a_contact_without_bound() {
    assert_snapshot!(report(&rich("{ push = 0.5 }", "{ rub = 0.5 }")), @r#"
    case::bad_reference

      × the contact `rub` has no slip bound
        ╭─[case.toml:82:13]
     64 │
     65 │ [[contact]]
        · ─────┬─────
        ·      ╰── the contact
     66 │ name = "rub"
     67 │ pair = ["upper.y-", "lower.y+"]
     68 │ friction = { law = "coulomb", coefficient = 0.3, limit = 7 }
     69 │
     70 │ [[contact]]
     71 │ name = "rail"
     72 │ pair = ["upper.y+", "lower.y-"]
     73 │ friction = { law = "bilateral", bound = "0.5*z" }
     74 │
     75 │ [[contact]]
     76 │ name = "glue"
     77 │ pair = ["upper.x+", "lower.x-"]
     78 │ friction = { law = "tied" }
     79 │
     80 │ [[step]]
     81 │ name = "first"
     82 │ factors = { rub = 0.5 }
        ·             ─┬─
        ·              ╰── its law is `coulomb`
     83 │
        ╰────
      help: a [[step]] changes the slip bounds of `tresca`, `orthotropic` and `bilateral`
    "#);
}

#[test]
fn a_value_of_a_contact_without_bound() {
    assert_snapshot!(report(&rich("values = {", "values = { glue = 1,")), @r#"
    case::bad_reference

      × the contact `glue` has no slip bound
        ╭─[case.toml:87:12]
     74 │
     75 │ [[contact]]
        · ─────┬─────
        ·      ╰── the contact
     76 │ name = "glue"
     77 │ pair = ["upper.x+", "lower.x-"]
     78 │ friction = { law = "tied" }
     79 │
     80 │ [[step]]
     81 │ name = "first"
     82 │ factors = { push = 0.5 }
     83 │
     84 │ [[step]]
     85 │ increments = 2
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { glue = 1, push = [0, 0, -3], drag = { z = 1 } }
        ·            ──┬─
        ·              ╰── its law is `tied`
        ╰────
      help: a [[step]] changes the slip bounds of `tresca`, `orthotropic` and `bilateral`
    "#);
}

#[test]
fn a_negative_factor_of_a_bound() {
    assert_snapshot!(report(&rich("{ push = 0.5 }", "{ joint = -0.5 }")), @r#"
    case::bad_value

      × the factor of a slip bound must not be negative
        ╭─[case.toml:82:21]
     81 │ name = "first"
     82 │ factors = { joint = -0.5 }
        ·                     ──┬─
        ·                       ╰── expected 0 or more, found -0.5
     83 │
        ╰────
      help: the slip bound is multiplied by it
    "#);
}

#[test]
fn a_negative_bound() {
    assert_snapshot!(report(&rich("values = {", "values = { rail = -1,")), @r#"
    case::bad_value

      × the slip bound must not be negative
        ╭─[case.toml:87:19]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { rail = -1, push = [0, 0, -3], drag = { z = 1 } }
        ·                   ─┬
        ·                    ╰── expected 0 or more, found -1.0
        ╰────
      help: it takes the place of the slip bound
    "#);
}

#[test]
fn a_value_for_two_bounds() {
    assert_snapshot!(report(&rich("values = {", "values = { grain = 1,")), @r#"
    case::wrong_type

      × `grain` has two slip bounds
        ╭─[case.toml:87:20]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { grain = 1, push = [0, 0, -3], drag = { z = 1 } }
        ·                    ┬
        ·                    ╰── expected a factor for both
        ╰────
      help: write `factors = { grain = … }`
    "#);
}

#[test]
fn values_of_the_wrong_kind() {
    assert_snapshot!(report(&rich("values = { push = [0, 0, -3]", "values = { push = -3")), @r#"
    case::wrong_type

      × expected a list of numbers for `push`
        ╭─[case.toml:87:19]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { push = -3, drag = { z = 1 } }
        ·            ──┬─   ─┬
        ·              │     ╰── found a number
        ·              ╰── a vector
        ╰────
    "#);
    assert_snapshot!(report(&rich("drag = { z = 1 }", "drag = 1")), @r#"
    case::wrong_type

      × expected a table `{ x = …, y = … }` for `drag`
        ╭─[case.toml:87:38]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { push = [0, 0, -3], drag = 1 }
        ·                               ──┬─   ┬
        ·                                 │    ╰── found a number
        ·                                 ╰── a support
        ╰────
    "#);
    assert_snapshot!(report(&rich("values = {", "values = { water = [1],")), @r#"
    case::wrong_type

      × expected a number for `water`
        ╭─[case.toml:87:20]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { water = [1], push = [0, 0, -3], drag = { z = 1 } }
        ·            ──┬──   ─┬─
        ·              │      ╰── found a list
        ·              ╰── a pressure or slip bound
        ╰────
    "#);
    assert_snapshot!(report(&rich("values = {", "values = { water = \"2*x\",")), @r#"
    case::wrong_type

      × expected a number, a list of numbers or a table `{ x = …, y = …, z = … }`
        ╭─[case.toml:87:20]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { water = "2*x", push = [0, 0, -3], drag = { z = 1 } }
        ·                    ──┬──
        ·                      ╰── found the text "2*x"
        ╰────
    "#);
    assert_snapshot!(report(&rich("values = {", "values = { water = { p = 1 },")), @r#"
    case::unknown_key

      × unknown key `p`
        ╭─[case.toml:87:22]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { water = { p = 1 }, push = [0, 0, -3], drag = { z = 1 } }
        ·                      ┬
        ·                      ╰── not a key of this table
        ╰────
      help: the keys that belong here are `x`, `y` and `z`
    "#);
}

#[test]
fn a_vector_of_the_wrong_length() {
    assert_snapshot!(report(&rich("push = [0, 0, -3]", "push = [0, -3]")), @r#"
    case::wrong_type

      × a list of the wrong length
        ╭─[case.toml:87:19]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { push = [0, -3], drag = { z = 1 } }
        ·                   ───┬───
        ·                      ╰── expected a list of three numbers [x, y, z], found 2 entries
        ╰────
      help: `analysis = "solid"` has 3 coordinates
    "#);
}

#[test]
fn a_component_that_is_not_held() {
    assert_snapshot!(report(&rich("{ z = 1 }", "{ y = 1 }")), @r#"
    case::bad_reference

      × the support `drag` does not hold y
        ╭─[case.toml:15:1]
     14 │
     15 │ [[support]]
        · ─────┬─────
        ·      ╰── the support
     16 │ name = "drag"
        ╰────
        ╭─[case.toml:87:44]
     86 │ factors = { wave = 2, joint = 0.5 }
     87 │ values = { push = [0, 0, -3], drag = { y = 1 } }
        ·                                            ┬
        ·                                            ╰── a component that is free in the other steps
        ╰────
      help: what is held stays the same in all steps; only the values change
    "#);
}

#[test]
fn a_time_that_goes_back() {
    assert_snapshot!(report(&rich("increments = 2", "time = 1")), @r#"
    case::bad_value

      × the time does not increase
        ╭─[case.toml:85:8]
     84 │ [[step]]
     85 │ time = 1
        ·        ┬
        ·        ╰── expected more than 1.0, found 1.0
     86 │ factors = { wave = 2, joint = 0.5 }
        ╰────
      help: `time` is the instant of the end of a step; the first step starts at 0
    "#);
    assert_snapshot!(report(&rich("name = \"first\"", "time = 0")), @r#"
    case::bad_value

      × the time does not increase
        ╭─[case.toml:81:8]
     80 │ [[step]]
     81 │ time = 0
        ·        ┬
        ·        ╰── expected more than 0.0, found 0.0
     82 │ factors = { push = 0.5 }
        ╰────
      help: `time` is the instant of the end of a step; the first step starts at 0
    "#);
}

#[test]
fn increments_out_of_range() {
    assert_snapshot!(report(&rich("increments = 2", "increments = 0")), @r#"
    case::bad_value

      × a step cannot have this number of increments
        ╭─[case.toml:85:14]
     84 │ [[step]]
     85 │ increments = 0
        ·              ┬
        ·              ╰── expected 1 or more, found 0
     86 │ factors = { wave = 2, joint = 0.5 }
        ╰────
      help: a case has at most 100000 increments, in each of which the contact problem is solved
    "#);
    assert_snapshot!(report(&rich("increments = 2", "increments = 100000")), @r#"
    case::bad_value

      × a step cannot have this number of increments
        ╭─[case.toml:85:14]
     84 │ [[step]]
     85 │ increments = 100000
        ·              ───┬──
        ·                 ╰── expected at most 99999, found 100000
     86 │ factors = { wave = 2, joint = 0.5 }
        ╰────
      help: a case has at most 100000 increments, in each of which the contact problem is solved
    "#);
    assert_snapshot!(report(&rich("increments = 2", "increments = 2.0")), @r#"
    case::wrong_type

      × expected a whole number, 0 or more
        ╭─[case.toml:85:14]
     84 │ [[step]]
     85 │ increments = 2.0
        ·              ─┬─
        ·               ╰── found the number 2.0
     86 │ factors = { wave = 2, joint = 0.5 }
        ╰────
      help: counts are written without decimal point or exponent
    "#);
}

#[test]
fn a_name_of_a_step_that_is_none() {
    assert_snapshot!(report(&rich("name = \"first\"", "name = \"\"")), @r#"
    case::bad_value

      × this cannot be a name
        ╭─[case.toml:81:8]
     80 │ [[step]]
     81 │ name = ""
        ·        ─┬
        ·         ╰── expected a name, found an empty text
     82 │ factors = { push = 0.5 }
        ╰────
      help: names are written as in `left_end` or `step-2`
    "#);
}
