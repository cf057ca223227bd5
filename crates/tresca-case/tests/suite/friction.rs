//! Friction laws: their figures, and keys that belong to another law.

use insta::assert_snapshot;
use tresca_contact::FrictionLaw;

use crate::support::{GOOD, PLANE, RICH, at, changed, constant, parse, report};

/// The good case with another friction table.
fn law(friction: &str) -> String {
    changed(GOOD, r#"{ law = "tresca", bound = 0.09 }"#, friction)
}

fn read(friction: &str) -> FrictionLaw {
    let case = parse(&law(friction)).unwrap();
    case.model.contacts()[0].friction.clone()
}

#[test]
fn laws_are_read_as_they_stand() {
    assert!(matches!(
        read(r#"{ law = "frictionless" }"#),
        FrictionLaw::Frictionless
    ));
    assert!(matches!(read(r#"{ law = "tied" }"#), FrictionLaw::Tied));
    assert!(matches!(
        read(r#"{ law = "bilateral" }"#),
        FrictionLaw::Bilateral { bound: None }
    ));
    let FrictionLaw::Bilateral { bound: Some(bound) } =
        read(r#"{ law = "bilateral", bound = "z" }"#)
    else {
        panic!("another law");
    };
    assert_eq!(at(&bound, [1.0, 2.0, 3.0]), 3.0);
    let FrictionLaw::Tresca { bound } = read(r#"{ law = "tresca", bound = "0.09*(1+x)" }"#) else {
        panic!("another law");
    };
    assert_eq!(at(&bound, [1.0, 2.0, 3.0]), 0.18);

    let FrictionLaw::Orthotropic { bounds, axis } =
        read(r#"{ law = "orthotropic", bounds = [0, "x"], axis = [0, -2, 0] }"#)
    else {
        panic!("another law");
    };
    assert_eq!(bounds.map(|b| at(&b, [4.0, 0.0, 0.0])), [0.0, 4.0]);
    assert_eq!(axis, [0.0, -2.0, 0.0]);

    let FrictionLaw::Coulomb {
        coefficients,
        axis: None,
        limit: None,
    } = read(r#"{ law = "coulomb", coefficient = 0.3 }"#)
    else {
        panic!("another law");
    };
    assert_eq!(coefficients, [0.3; 2]);
    let FrictionLaw::Coulomb {
        limit: Some(limit), ..
    } = read(r#"{ law = "coulomb", coefficient = 0, limit = 5 }"#)
    else {
        panic!("another law");
    };
    assert_eq!(constant(&limit), Some(5.0));

    let FrictionLaw::Coulomb {
        coefficients,
        axis,
        limit,
    } = read(r#"{ law = "coulomb", coefficients = [0.3, 0.1], axis = [1, 1, 0], limit = "x" }"#)
    else {
        panic!("another law");
    };
    assert_eq!(coefficients, [0.3, 0.1]);
    assert_eq!(axis, Some([1.0, 1.0, 0.0]));
    assert_eq!(limit.map(|limit| at(&limit, [2.0; 3])), Some(2.0));
}

#[test]
fn laws_are_called_as_in_case_files() {
    let case = parse(RICH).unwrap();
    let contacts = case.model.contacts().iter();
    let found: Vec<&str> = contacts.map(|c| c.friction.name()).collect();
    assert_eq!(
        found,
        ["tresca", "orthotropic", "coulomb", "bilateral", "tied"]
    );
    assert!(found.iter().all(|name| FrictionLaw::NAMES.contains(name)));
}

#[test]
fn a_gap_by_a_formula_and_none() {
    let case = parse(RICH).unwrap();
    let contacts = case.model.contacts();
    assert_eq!(at(&contacts[0].gap, [2.0, 0.0, 0.0]), 0.002);
    assert_eq!(constant(&contacts[1].gap), Some(0.0));
    let name = |i: usize| contacts[i].name.as_deref();
    assert_eq!((name(0), name(4)), (Some("joint"), Some("glue")));
}

#[test]
fn a_key_of_another_law() {
    let text = law(r#"{ law = "tresca", bound = 0.09, coefficient = 0.3 }"#);
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × the friction law `tresca` takes no `coefficient`
        ╭─[case.toml:22:58]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = 0.09, coefficient = 0.3 }
        ·                    ────┬───                              ─┬─
        ·                        │                                  ╰── `coefficient` belongs to `coulomb`
        ·                        ╰── the law
     23 │
        ╰────
      help: `tresca` takes `bound`
    "#);
}

/// Every key with every law that does not take it.
#[test]
fn keys_of_other_laws_are_refused_with_both_laws_named() {
    let figures = [
        ("bound", "0.1", &["tresca", "bilateral"][..]),
        ("bounds", "[1, 2]", &["orthotropic"]),
        ("coefficient", "0.1", &["coulomb"]),
        ("coefficients", "[1, 2]", &["coulomb"]),
        ("axis", "[1, 0, 0]", &["orthotropic", "coulomb"]),
        ("limit", "1", &["coulomb"]),
    ];
    for name in FrictionLaw::NAMES {
        for (key, value, owners) in figures {
            if owners.contains(&name) {
                continue;
            }
            let report = report(&law(&format!("{{ law = \"{name}\", {key} = {value} }}")));
            let fact = format!("the friction law `{name}` takes no `{key}`");
            assert!(report.contains(&fact), "{report}");
            for owner in owners {
                assert!(report.contains(&format!("`{owner}`")), "{report}");
            }
        }
    }
}

#[test]
fn a_figure_with_a_law_without_figures() {
    assert_snapshot!(report(&law(r#"{ law = "tied", bound = 0.09 }"#)), @r#"
    case::unknown_key

      × the friction law `tied` takes no `bound`
        ╭─[case.toml:22:36]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tied", bound = 0.09 }
        ·                    ───┬──          ──┬─
        ·                       │              ╰── `bound` belongs to `tresca` and `bilateral`
        ·                       ╰── the law
     23 │
        ╰────
      help: `tied` takes no further keys
    "#);
}

#[test]
fn orthotropic_without_bounds() {
    assert_snapshot!(report(&law(r#"{ law = "orthotropic", axis = [1, 0, 0] }"#)), @r#"
    case::missing_key

      × the friction law `orthotropic` needs `bounds`
        ╭─[case.toml:22:12]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "orthotropic", axis = [1, 0, 0] }
        ·            ────────────────────┬────────────────────
        ·                                ╰── expected `bounds` in this table
     23 │
        ╰────
      help: `bounds = [g1, g2]` are the slip bounds (force per area) along `axis` and across it
    "#);
}

#[test]
fn orthotropic_with_three_bounds() {
    let text = law(r#"{ law = "orthotropic", bounds = [1, 2, 3], axis = [1, 0, 0] }"#);
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × a list of the wrong length
        ╭─[case.toml:22:44]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "orthotropic", bounds = [1, 2, 3], axis = [1, 0, 0] }
        ·                                            ────┬────
        ·                                                ╰── expected 2 entries, found 3
     23 │
        ╰────
      help: `bounds` has one entry for the axis and one for the direction across it
    "#);
}

#[test]
fn orthotropic_with_a_negative_bound() {
    let text = law(r#"{ law = "orthotropic", bounds = [1, -2], axis = [1, 0, 0] }"#);
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the slip bound must not be negative
        ╭─[case.toml:22:48]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "orthotropic", bounds = [1, -2], axis = [1, 0, 0] }
        ·                                                ─┬
        ·                                                 ╰── expected 0 or more, found -2.0
     23 │
        ╰────
      help: it is the tangential traction (force per area) at which the pair slides; 0.0 is no
            friction
    "#);
}

#[test]
fn orthotropic_without_axis() {
    assert_snapshot!(report(&law(r#"{ law = "orthotropic", bounds = [1, 2] }"#)), @r#"
    case::missing_key

      × the friction law `orthotropic` needs `axis`
        ╭─[case.toml:22:12]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "orthotropic", bounds = [1, 2] }
        ·            ────────────────────┬───────────────────
        ·                                ╰── expected `axis` in this table
     23 │
        ╰────
      help: `axis = [x, y, z]` is the direction of the first axis; its part in the tangential plane
            counts
    "#);
}

#[test]
fn an_axis_without_direction() {
    let text = law(r#"{ law = "orthotropic", bounds = [1, 2], axis = [0, 0, 0] }"#);
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the axis has no direction
        ╭─[case.toml:22:59]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "orthotropic", bounds = [1, 2], axis = [0, 0, 0] }
        ·                                                           ────┬────
        ·                                                               ╰── expected a vector that is not zero
     23 │
        ╰────
      help: `axis = [x, y, z]` is the direction of the first axis; its part in the tangential plane
            counts
    "#);
}

#[test]
fn orthotropic_in_the_plane() {
    let text = changed(
        PLANE,
        r#"{ law = "coulomb", coefficient = 0.3 }"#,
        r#"{ law = "orthotropic", bounds = [1, 2], axis = [1, 0, 0] }"#,
    );
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × orthotropic friction needs bodies in space
        ╭─[case.toml:25:20]
     24 │ pair = ["block.y-", "ground.y+"]
     25 │ friction = { law = "orthotropic", bounds = [1, 2], axis = [1, 0, 0] }
        ·                    ──────┬──────
        ·                          ╰── `analysis = "plane_strain"` has one tangential direction
        ╰────
      help: use `tresca` with a `bound`, or `coulomb` with a `coefficient`
    "#);
}

#[test]
fn two_coefficients_in_the_plane() {
    let text = changed(PLANE, "coefficient = 0.3", "coefficients = [0.3, 0.1]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × friction with two `coefficients` needs bodies in space
        ╭─[case.toml:25:20]
     24 │ pair = ["block.y-", "ground.y+"]
     25 │ friction = { law = "coulomb", coefficients = [0.3, 0.1] }
        ·                    ────┬────
        ·                        ╰── `analysis = "plane_strain"` has one tangential direction
        ╰────
      help: use `tresca` with a `bound`, or `coulomb` with a `coefficient`
    "#);
}

#[test]
fn coulomb_without_coefficient() {
    assert_snapshot!(report(&law(r#"{ law = "coulomb" }"#)), @r#"
    case::missing_key

      × the friction law `coulomb` needs a `coefficient`
        ╭─[case.toml:22:12]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "coulomb" }
        ·            ─────────┬─────────
        ·                     ╰── expected `coefficient` in this table
     23 │
        ╰────
      help: `coefficient` is the ratio of tangential to normal traction at which the pair slides
    "#);
}

#[test]
fn coulomb_with_a_coefficient_too_many() {
    let text = law(r#"{ law = "coulomb", coefficient = 0.3, coefficients = [1, 2] }"#);
    assert_snapshot!(report(&text), @r#"
    case::duplicate

      × `coefficient` and `coefficients` exclude each other
        ╭─[case.toml:22:65]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "coulomb", coefficient = 0.3, coefficients = [1, 2] }
        ·                                             ─┬─                 ───┬──
        ·                                              │                     ╰── one coefficient for each of two axes
        ·                                              ╰── one coefficient for all directions
     23 │
        ╰────
      help: remove one of the two
    "#);
}

#[test]
fn coulomb_with_an_axis_for_one_coefficient() {
    let text = law(r#"{ law = "coulomb", coefficient = 0.3, axis = [1, 0, 0] }"#);
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × one `coefficient` for all directions takes no `axis`
        ╭─[case.toml:22:57]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "coulomb", coefficient = 0.3, axis = [1, 0, 0] }
        ·                                                         ────┬────
        ·                                                             ╰── expected `coefficients` along with it
     23 │
        ╰────
      help: write `coefficients = [F1, F2]`, or remove `axis`
    "#);
}

#[test]
fn a_negative_coefficient() {
    assert_snapshot!(report(&law(r#"{ law = "coulomb", coefficient = -0.3 }"#)), @r#"
    case::bad_value

      × the coefficient of friction must not be negative
        ╭─[case.toml:22:45]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "coulomb", coefficient = -0.3 }
        ·                                             ──┬─
        ·                                               ╰── expected 0 or more, found -0.3
     23 │
        ╰────
      help: it is the ratio of tangential to normal traction at which the pair slides
    "#);
}

#[test]
fn a_coefficient_by_a_formula() {
    assert_snapshot!(report(&law(r#"{ law = "coulomb", coefficient = "0.3*x" }"#)), @r#"
    case::wrong_type

      × expected a number
        ╭─[case.toml:22:45]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "coulomb", coefficient = "0.3*x" }
        ·                                             ───┬───
        ·                                                ╰── found the text "0.3*x"
     23 │
        ╰────
      help: numbers are written as in 0.3, 16 or 5.0e4
    "#);
}

#[test]
fn a_negative_limit() {
    assert_snapshot!(report(&law(r#"{ law = "coulomb", coefficient = 0.3, limit = -1 }"#)), @r#"
    case::bad_value

      × the limit of the slip bound must not be negative
        ╭─[case.toml:22:58]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "coulomb", coefficient = 0.3, limit = -1 }
        ·                                                          ─┬
        ·                                                           ╰── expected 0 or more, found -1.0
     23 │
        ╰────
      help: it is the largest slip bound (force per area), whatever the normal force
    "#);
}

#[test]
fn a_table_without_law() {
    assert_snapshot!(report(&law("{ bound = 0.09 }")), @r#"
    case::missing_key

      × missing key `law`
        ╭─[case.toml:22:12]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { bound = 0.09 }
        ·            ────────┬───────
        ·                    ╰── expected `law` in this table
     23 │
        ╰────
      help: the tables and their keys are listed in docs/case-file.md
    "#);
}

#[test]
fn a_gap_that_is_infinite() {
    assert_snapshot!(report(&changed(RICH, "\"0.001*x\"", "inf")), @r#"
    case::bad_value

      × the gap is not a finite number
        ╭─[case.toml:58:7]
     57 │ friction = { law = "tresca", bound = 0.09 }
     58 │ gap = inf
        ·       ─┬─
        ·        ╰── expected a finite number, found inf
     59 │
        ╰────
      help: TOML knows the words `nan` and `inf`; a case file takes numbers only
    "#);
}
