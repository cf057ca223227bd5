//! Supports, tractions, pressures, body forces and gravity.

use insta::assert_snapshot;

use tresca_model::{Amount, LoadId, LoadKind};

use crate::support::{RICH, at, changed, constant, parse, place, report};

fn rich(from: &str, to: &str) -> String {
    changed(RICH, from, to)
}

#[test]
fn loads_are_read_as_they_stand() {
    let case = parse(RICH).unwrap();
    let model = &case.model;
    let [drag, roller] = model.supports() else {
        panic!("not two supports");
    };
    assert_eq!(drag.name.as_deref(), Some("drag"));
    assert_eq!(drag.components, [Some(0.5), None, Some(-0.25)]);
    assert_eq!(place(&drag.on[0]), (0, "x+"));
    assert_eq!(
        (roller.name.as_deref(), roller.components),
        (None, [None, Some(0.0), None])
    );

    let names: Vec<_> = model.loads().iter().map(|l| l.name.as_deref()).collect();
    let all = ["push", "wave", "water", "wind", "swirl", "weight"];
    assert_eq!(names, all.map(Some));
    let kinds = model.loads().iter().map(|load| &load.kind);
    let kinds: Vec<&LoadKind> = kinds.collect();
    let [
        LoadKind::Traction(push),
        LoadKind::Traction(wave),
        LoadKind::Pressure(water),
        LoadKind::Pressure(wind),
        LoadKind::BodyForce(swirl),
        LoadKind::Gravity(weight),
    ] = kinds.as_slice()
    else {
        panic!("other loads: {kinds:?}");
    };
    assert_eq!(push.value.constant(), Some([0.0, 0.0, -1.0]));
    assert_eq!(wave.value.constant(), None);
    assert_eq!(wave.value.at([0.5, 7.0, 7.0]), [0.0, 0.5_f64.sin(), -1.0]);
    assert_eq!(constant(&water.value), Some(2.0));
    assert_eq!(at(&wind.value, [0.0, 0.0, 1.5]), 3.0);
    assert_eq!(swirl.value, [0.1, 0.2, 0.3]);
    assert_eq!(weight.value, [0.0, 0.0, -10.0]);
    let loaded = |i: usize| model.loads()[i].on.names(model.bodies());
    assert_eq!(loaded(0), ["upper.z+"]);
    assert_eq!(loaded(4), ["upper", "lower"]);
    assert_eq!(loaded(5), ["upper"]);
}

#[test]
fn a_total_force_varies_as_all_loads_do() {
    let force =
        "[[force]]\nname = \"jack\"\non = [\"upper.z+\", \"upper.y+\"]\nvalue = [1, 2, 3]\n";
    let steps = "[[step]]\nfactors = { jack = 0.5 }\n[[step]]\nvalues = { jack = [0, 0, 4] }\n";
    let (rest, _) = RICH.split_once("[[step]]").unwrap();
    let case = parse(&format!("{rest}{force}{steps}")).unwrap();
    let model = &case.model;
    let LoadKind::Force(jack) = &model.loads()[6].kind else {
        panic!("another load");
    };
    assert_eq!(jack.value, [1.0, 2.0, 3.0]);
    assert_eq!(
        model.loads()[6].on.names(model.bodies()),
        ["upper.z+", "upper.y+"]
    );
    let amounts = model.steps().iter().map(|step| step.amount(LoadId(6)));
    let amounts: Vec<Amount> = amounts.collect();
    assert_eq!(
        amounts,
        [Amount::Factor(0.5), Amount::Vector([0.0, 0.0, 4.0])]
    );
    let wrong = steps.replace("[0, 0, 4]", "4");
    let report = report(&format!("{rest}{force}{wrong}"));
    assert!(
        report.contains("expected a list of numbers for `jack`"),
        "{report}"
    );
}

#[test]
fn a_support_that_holds_nothing() {
    assert_snapshot!(report(&rich("y = 0\n", "")), @r#"
    case::missing_key

      × the support holds nothing
        ╭─[case.toml:21:1]
     20 │
     21 │ [[support]]
        · ─────┬─────
        ·      ╰── expected at least one of the keys `x`, `y` and `z`
     22 │ on = ["lower.z-"]
        ╰────
      help: `x = 0` holds the component along x; a [[clamp]] holds all of them
    "#);
}

#[test]
fn components_of_a_surface_may_stand_in_different_supports() {
    let text = rich("on = [\"lower.z-\"]", "on = [\"lower.z-\", \"upper.x+\"]");
    assert_eq!(parse(&text).unwrap().model.supports().len(), 2);
}

#[test]
fn a_component_that_is_prescribed_twice() {
    let text = rich("[[support]]\non", "[[support]]\nz = 1\non");
    let text = text.replace("[\"lower.z-\"]", "[\"lower.z-\", \"upper.x+\"]");
    assert_snapshot!(report(&text), @r#"
    case::duplicate

      × the displacement of "upper.x+" along z is prescribed twice
        ╭─[case.toml:23:19]
     16 │ name = "drag"
     17 │ on = ["upper.x+"]
        ·       ─────┬────
        ·            ╰── the first time
     18 │ x = 0.5
     19 │ z = -0.25
     20 │
     21 │ [[support]]
     22 │ z = 1
     23 │ on = ["lower.z-", "upper.x+"]
        ·                   ─────┬────
        ·                        ╰── the second time
     24 │ y = 0
        ╰────
      help: a surface may stand in several [[support]] tables with different components; a [[clamp]]
            holds all of them
    "#);
}

#[test]
fn a_support_of_a_clamped_surface() {
    let text = format!("{RICH}[[clamp]]\non = [\"lower.z-\"]\n");
    assert_snapshot!(report(&text), @r#"
    case::duplicate

      × the displacement of "lower.z-" along y is prescribed twice
        ╭─[case.toml:22:7]
     21 │ [[support]]
     22 │ on = ["lower.z-"]
        ·       ─────┬────
        ·            ╰── the second time
     23 │ y = 0
        ╰────
        ╭─[case.toml:89:7]
     88 │ [[clamp]]
     89 │ on = ["lower.z-"]
        ·       ─────┬────
        ·            ╰── the first time
        ╰────
      help: a surface may stand in several [[support]] tables with different components; a [[clamp]]
            holds all of them
    "#);
}

#[test]
fn a_support_that_is_not_finite() {
    assert_snapshot!(report(&rich("x = 0.5", "x = inf")), @r#"
    case::bad_value

      × the prescribed displacement is not a finite number
        ╭─[case.toml:18:5]
     17 │ on = ["upper.x+"]
     18 │ x = inf
        ·     ─┬─
        ·      ╰── expected a finite number, found inf
     19 │ z = -0.25
        ╰────
      help: TOML knows the words `nan` and `inf`; a case file takes numbers only
    "#);
}

#[test]
fn a_support_by_a_formula() {
    assert_snapshot!(report(&rich("x = 0.5", "x = \"0.5*y\"")), @r#"
    case::wrong_type

      × expected a number
        ╭─[case.toml:18:5]
     17 │ on = ["upper.x+"]
     18 │ x = "0.5*y"
        ·     ───┬───
        ·        ╰── found the text "0.5*y"
     19 │ z = -0.25
        ╰────
      help: numbers are written as in 0.3, 16 or 5.0e4
    "#);
}

#[test]
fn a_component_with_a_capital() {
    assert_snapshot!(report(&rich("x = 0.5", "X = 0.5")), @r#"
    case::unknown_key

      × unknown key `X`
        ╭─[case.toml:18:1]
     17 │ on = ["upper.x+"]
     18 │ X = 0.5
        · ┬
        · ╰── did you mean `x`?
     19 │ z = -0.25
        ╰────
      help: the keys that belong here are `name`, `on`, `x`, `y` and `z`
    "#);
}

#[test]
fn a_traction_with_two_components() {
    assert_snapshot!(report(&rich("[0, \"sin(x)\", -1]", "[0, -1]")), @r#"
    case::wrong_type

      × a list of the wrong length
        ╭─[case.toml:33:9]
     32 │ on = ["upper.y+"]
     33 │ value = [0, -1]
        ·         ───┬───
        ·            ╰── expected a list of three numbers [x, y, z], found 2 entries
     34 │
        ╰────
      help: `analysis = "solid"` has 3 coordinates
    "#);
}

#[test]
fn a_traction_with_a_component_that_is_nan() {
    assert_snapshot!(report(&rich("[0, 0, -1]", "[0, nan, -1]")), @r#"
    case::bad_value

      × the traction is not a finite number
        ╭─[case.toml:28:13]
     27 │ on = ["upper.z+"]
     28 │ value = [0, nan, -1]
        ·             ─┬─
        ·              ╰── expected a finite number, found NaN
     29 │
        ╰────
      help: TOML knows the words `nan` and `inf`; a case file takes numbers only
    "#);
}

#[test]
fn a_traction_with_a_truth_value() {
    assert_snapshot!(report(&rich("[0, 0, -1]", "[0, true, -1]")), @r#"
    case::wrong_type

      × expected a number, or an expression in quotes
        ╭─[case.toml:28:13]
     27 │ on = ["upper.z+"]
     28 │ value = [0, true, -1]
        ·             ──┬─
        ·               ╰── found true
     29 │
        ╰────
    "#);
}

#[test]
fn a_traction_of_one_number() {
    assert_snapshot!(report(&rich("[0, 0, -1]", "-1")), @r#"
    case::wrong_type

      × expected a list
        ╭─[case.toml:28:9]
     27 │ on = ["upper.z+"]
     28 │ value = -1
        ·         ─┬
        ·          ╰── found the number -1
     29 │
        ╰────
    "#);
}

#[test]
fn a_pressure_as_a_vector() {
    assert_snapshot!(report(&rich("value = 2\n", "value = [0, 0, 2]\n")), @r#"
    case::wrong_type

      × expected a number, or an expression in quotes
        ╭─[case.toml:38:9]
     37 │ on = ["lower.x-"]
     38 │ value = [0, 0, 2]
        ·         ────┬────
        ·             ╰── found a list
     39 │
        ╰────
    "#);
}

#[test]
fn a_pressure_without_value() {
    assert_snapshot!(report(&rich("value = 2\n", "")), @r#"
    case::missing_key

      × missing key `value`
        ╭─[case.toml:35:1]
     34 │
     35 │ [[pressure]]
        · ──────┬─────
        ·       ╰── expected `value` in this table
     36 │ name = "water"
        ╰────
      help: the tables and their keys are listed in docs/case-file.md
    "#);
}

#[test]
fn a_pressure_from_a_file() {
    assert_snapshot!(report(&rich("value = 2\n", "value = { file = \"p.csv\" }\n")), @r#"
    case::wrong_type

      × the pressure cannot come from a file
        ╭─[case.toml:38:9]
     37 │ on = ["lower.x-"]
     38 │ value = { file = "p.csv" }
        ·         ─────────┬────────
        ·                  ╰── expected a number, or an expression in quotes
     39 │
        ╰────
      help: slip bounds are the fields that may come from a file
    "#);
}

#[test]
fn a_body_force_by_a_formula() {
    assert_snapshot!(report(&rich("[0.1, 0.2, 0.3]", "[\"x\", 0.2, 0.3]")), @r#"
    case::wrong_type

      × expected a number
        ╭─[case.toml:47:10]
     46 │ name = "swirl"
     47 │ value = ["x", 0.2, 0.3]
        ·          ─┬─
        ·           ╰── found the text "x"
     48 │
        ╰────
      help: numbers are written as in 0.3, 16 or 5.0e4
    "#);
}

#[test]
fn a_body_force_that_is_infinite() {
    assert_snapshot!(report(&rich("[0.1, 0.2, 0.3]", "[0.1, inf, 0.3]")), @r#"
    case::bad_value

      × the body force is not a finite number
        ╭─[case.toml:47:15]
     46 │ name = "swirl"
     47 │ value = [0.1, inf, 0.3]
        ·               ─┬─
        ·                ╰── expected a finite number, found inf
     48 │
        ╰────
      help: TOML knows the words `nan` and `inf`; a case file takes numbers only
    "#);
}

#[test]
fn gravity_on_a_body_without_density() {
    assert_snapshot!(report(&rich("bodies = [\"upper\"]\n", "")), @r#"
    case::missing_key

      × gravity acts on `lower`, which has no density
        ╭─[case.toml:13:12]
     12 │ mesh = { brick = { min = [0, 0, 0], max = [2, 1, 1], nodes = [5, 3, 3] } }
     13 │ material = { young = 5.0e4, poisson = 0.35 }
        ·            ────────────────┬────────────────
        ·                            ╰── expected `density` in this table
     14 │
        ╰────
        ╭─[case.toml:49:1]
     48 │
     49 │ [[gravity]]
        · ─────┬─────
        ·      ╰── the gravity
     50 │ name = "weight"
        ╰────
      help: give `lower` a `density` (0 for no weight), or list the heavy bodies: `bodies = ["…"]` in
            [[gravity]]
    "#);
}

#[test]
fn gravity_on_an_unknown_body() {
    assert_snapshot!(report(&rich("[\"upper\"]\n", "[\"uper\"]\n")), @r#"
    case::bad_reference

      × there is no body `uper`
        ╭─[case.toml:51:11]
     50 │ name = "weight"
     51 │ bodies = ["uper"]
        ·           ───┬──
        ·              ╰── did you mean `upper`?
     52 │ value = [0, 0, -10]
        ╰────
      help: the bodies of this case are `upper` and `lower`
    "#);
}

#[test]
fn gravity_on_no_body() {
    assert_snapshot!(report(&rich("[\"upper\"]\n", "[]\n")), @r#"
    case::bad_value

      × the list of bodies is empty
        ╭─[case.toml:51:10]
     50 │ name = "weight"
     51 │ bodies = []
        ·          ─┬
        ·           ╰── expected at least one name
     52 │ value = [0, 0, -10]
        ╰────
      help: without `bodies` all of them are meant
    "#);
}

#[test]
fn gravity_twice_on_a_body() {
    assert_snapshot!(report(&rich("[\"upper\"]\n", "[\"upper\", \"upper\"]\n")), @r#"
    case::duplicate

      × this body is listed twice
        ╭─[case.toml:51:20]
     50 │ name = "weight"
     51 │ bodies = ["upper", "upper"]
        ·                    ───┬───
        ·                       ╰── the second time
     52 │ value = [0, 0, -10]
        ╰────
      help: remove one of the two, or correct it
    "#);
}

#[test]
fn a_name_with_a_space() {
    assert_snapshot!(report(&rich("name = \"push\"", "name = \"push down\"")), @r#"
    case::bad_value

      × this cannot be a name
        ╭─[case.toml:26:8]
     25 │ [[traction]]
     26 │ name = "push down"
        ·        ─────┬─────
        ·             ╰── expected letters, digits, `_` and `-`, found ` `
     27 │ on = ["upper.z+"]
        ╰────
      help: names are written as in `left_end` or `step-2`
    "#);
}

#[test]
fn a_name_given_twice() {
    assert_snapshot!(report(&rich("name = \"joint\"", "name = \"wind\"")), @r#"
    case::duplicate

      × the name `wind` is given twice
        ╭─[case.toml:55:8]
     40 │ [[pressure]]
     41 │ name = "wind"
        ·        ───┬──
        ·           ╰── the first time
     42 │ on = ["upper.x-"]
     43 │ value = "2*z"
     44 │
     45 │ [[body_force]]
     46 │ name = "swirl"
     47 │ value = [0.1, 0.2, 0.3]
     48 │
     49 │ [[gravity]]
     50 │ name = "weight"
     51 │ bodies = ["upper"]
     52 │ value = [0, 0, -10]
     53 │
     54 │ [[contact]]
     55 │ name = "wind"
        ·        ───┬──
        ·           ╰── the second time
     56 │ pair = ["upper.z-", "lower.z+"]
        ╰────
      help: supports, loads, obstacles and contacts have different names, so that a [[step]] can tell
            them apart
    "#);
}

#[test]
fn single_brackets_of_a_new_table() {
    assert_snapshot!(report(&rich("[[gravity]]", "[gravity]")), @r#"
    case::wrong_type

      × expected a list
        ╭─[case.toml:49:1]
     48 │
     49 │ [gravity]
        · ────┬────
        ·     ╰── found a table
     50 │ name = "weight"
        ╰────
      help: entries of this kind start with double brackets, as in `[[body]]`
    "#);
}

#[test]
fn lists_in_the_place_of_new_tables() {
    let text = rich(
        "title = \"Everything\"",
        "title = \"Everything\"\nbody_force = [[1, 2]]",
    );
    let text = text.replace("[[body_force]]", "[[body_forces]]");
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a table of keys for `body_force`
       ╭─[case.toml:2:15]
     1 │ title = "Everything"
     2 │ body_force = [[1, 2]]
       ·               ───┬──
       ·                  ╰── found a list
     3 │ analysis = "solid"
       ╰────
      help: a table has braces and names its values: { key = value, … }
    "#);
}
