//! Values of the right type that no body, material or law can have.

use crate::support::{report, with};
use insta::assert_snapshot;

#[test]
fn poisson_one_half() {
    let text = with("0.277", "0.5");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × Poisson's ratio must lie between -1 and 0.5
       ╭─[case.toml:6:39]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 5.0e4, poisson = 0.5 }
       ·                                       ─┬─
       ·                                        ╰── expected -1 < poisson < 0.5, found 0.5
     7 │
       ╰────
      help: 0.5 is an incompressible material, which needs another formulation; rubber is often taken
            as 0.49
    "#);
}

#[test]
fn poisson_minus_one() {
    let text = with("0.277", "-1");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × Poisson's ratio must lie between -1 and 0.5
       ╭─[case.toml:6:39]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 5.0e4, poisson = -1 }
       ·                                       ─┬
       ·                                        ╰── expected -1 < poisson < 0.5, found -1.0
     7 │
       ╰────
      help: no stable isotropic material has it; most metals have 0.25 to 0.35
    "#);
}

#[test]
fn poisson_and_young_exchanged() {
    let text = with(
        "young = 5.0e4, poisson = 0.277",
        "young = 0.277, poisson = 5.0e4",
    );
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × Poisson's ratio must lie between -1 and 0.5
       ╭─[case.toml:6:39]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 0.277, poisson = 5.0e4 }
       ·                                       ──┬──
       ·                                         ╰── expected -1 < poisson < 0.5, found 50000.0
     7 │
       ╰────
      help: is this Young's modulus? most metals have 0.25 to 0.35
    "#);
}

#[test]
fn young_zero() {
    let text = with("5.0e4", "0");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × Young's modulus must be positive
       ╭─[case.toml:6:22]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 0, poisson = 0.277 }
       ·                      ┬
       ·                      ╰── expected more than 0, found 0.0
     7 │
       ╰────
      help: it is the stiffness of the material, a force per area
    "#);
}

#[test]
fn young_nan() {
    let text = with("5.0e4", "nan");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × Young's modulus is not a finite number
       ╭─[case.toml:6:22]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = nan, poisson = 0.277 }
       ·                      ─┬─
       ·                       ╰── expected a finite number, found NaN
     7 │
       ╰────
      help: TOML knows the words `nan` and `inf`; a case file takes numbers only
    "#);
}

#[test]
fn a_coordinate_that_is_infinite() {
    let text = with("[2.0, 1.0, 2.0]", "[2.0, inf, 2.0]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the corner `max` is not a finite number
       ╭─[case.toml:5:55]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, inf, 2.0], nodes = [16, 16, 16] } }
       ·                                                       ─┬─
       ·                                                        ╰── expected a finite number, found inf
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: TOML knows the words `nan` and `inf`; a case file takes numbers only
    "#);
}

#[test]
fn a_traction_beyond_the_range() {
    let text = with("-1.0]", "-1e400]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × this value cannot be used
        ╭─[case.toml:18:20]
     17 │ on = ["upper.z+", "upper.x-"]
     18 │ value = [0.0, 0.0, -1e400]
        ·                    ───┬──
        ·                       ╰── floating-point number overflowed
     19 │
        ╰────
    "#);
}

#[test]
fn a_negative_bound() {
    let text = with("0.09", "-0.09");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the slip bound must not be negative
        ╭─[case.toml:22:38]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = -0.09 }
        ·                                      ──┬──
        ·                                        ╰── expected 0 or more, found -0.09
     23 │
        ╰────
      help: it is the tangential traction (force per area) at which the pair slides; 0.0 is no
            friction
    "#);
}

#[test]
fn a_bound_that_is_nan() {
    let text = with("0.09", "nan");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the slip bound is not a finite number
        ╭─[case.toml:22:38]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca", bound = nan }
        ·                                      ─┬─
        ·                                       ╰── expected a finite number, found NaN
     23 │
        ╰────
      help: TOML knows the words `nan` and `inf`; a case file takes numbers only
    "#);
}

#[test]
fn a_missing_bound() {
    let text = with(", bound = 0.09", "");
    assert_snapshot!(report(&text), @r#"
    case::missing_key

      × the friction law `tresca` needs a `bound`
        ╭─[case.toml:22:12]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "tresca" }
        ·            ─────────┬────────
        ·                     ╰── expected `bound` in this table
     23 │
        ╰────
      help: `bound` is the tangential traction (force per area) at which the pair slides; 0.0 is no
            friction
    "#);
}

#[test]
fn zero_volume() {
    let text = with("max = [2.0, 1.0, 2.0]", "max = [2.0, 0.0, 2.0]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the brick has zero volume: no extent along y
       ╭─[case.toml:5:55]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 0.0, 2.0], nodes = [16, 16, 16] } }
       ·                                ─┬─                    ─┬─
       ·                                 │                      ╰── expected more than 0.0, found 0.0
       ·                                 ╰── the other end
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: a body is solid; give it an extent in every direction
    "#);
}

#[test]
fn corners_exchanged() {
    let text = with(
        "min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0]",
        "min = [2.0, 1.0, 2.0], max = [0.0, 0.0, 1.0]",
    );
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the brick is turned inside out: `min` exceeds `max` along x
       ╭─[case.toml:5:50]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [2.0, 1.0, 2.0], max = [0.0, 0.0, 1.0], nodes = [16, 16, 16] } }
       ·                           ─┬─                    ─┬─
       ·                            │                      ╰── expected more than 2.0, found 0.0
       ·                            ╰── the other end
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: `min` and `max` are probably exchanged
    "#);
}

#[test]
fn a_brick_far_from_the_origin() {
    let text = with(
        "min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0]",
        "min = [1e16, 0.0, 1.0], max = [1.0000000000000002e16, 1.0, 2.0]",
    );
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the nodes along x cannot be told apart in double precision
       ╭─[case.toml:5:51]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [1e16, 0.0, 1.0], max = [1.0000000000000002e16, 1.0, 2.0], nodes = [16, 16, 16] } }
       ·                           ──┬─                    ──────────┬──────────
       ·                             │                               ╰── expected more than 1e16, found 1.0000000000000002e16
       ·                             ╰── the other end
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: move the body closer to the origin, or choose another unit of length
    "#);
}

#[test]
fn a_volume_that_underflows() {
    let text = with(
        "min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0]",
        "min = [0, 0, 0], max = [1e-120, 1e-120, 1e-120]",
    );
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the volume of the brick is beyond the range of numbers
       ╭─[case.toml:5:43]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0, 0, 0], max = [1e-120, 1e-120, 1e-120], nodes = [16, 16, 16] } }
       ·                                           ────────────┬───────────
       ·                                                       ╰── the product of the three extents is 0.0
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: choose another unit of length
    "#);
}

#[test]
fn one_node() {
    let text = with("[16, 16, 16]", "[16, 1, 16]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × too few nodes along y
       ╭─[case.toml:5:79]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 1, 16] } }
       ·                                                                               ┬
       ·                                                                               ╰── expected 2 or more, found 1
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: nodes are counted with both ends: 2 nodes make one element
    "#);
}

#[test]
fn nodes_whose_product_overflows() {
    let text = with("[16, 16, 16]", "[4000000000, 4000000000, 4000000000]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × too many nodes
       ╭─[case.toml:5:74]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [4000000000, 4000000000, 4000000000] } }
       ·                                                                          ──────────────────┬─────────────────
       ·                                                                                            ╰── expected at most 100000000 in all, found more than can be counted
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: the three counts are multiplied: [41, 41, 41] are 68921 nodes
    "#);
}

#[test]
fn too_many_nodes() {
    let text = with("[16, 16, 16]", "[1000, 1000, 1000]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × too many nodes
       ╭─[case.toml:5:74]
     4 │ name = "upper"
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [1000, 1000, 1000] } }
       ·                                                                          ─────────┬────────
       ·                                                                                   ╰── expected at most 100000000 in all, found 1000000000
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: the three counts are multiplied: [41, 41, 41] are 68921 nodes
    "#);
}

#[test]
fn an_unknown_mesh_kind() {
    let text = with(
        "{ brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }",
        r#"{ gmsh = "part.msh" }"#,
    );
    assert_snapshot!(report(&text), @r#"
    case::unknown_key

      × unknown key `gmsh`
       ╭─[case.toml:5:10]
     4 │ name = "upper"
     5 │ mesh = { gmsh = "part.msh" }
       ·          ──┬─
       ·            ╰── not a key of this table
     6 │ material = { young = 5.0e4, poisson = 0.277 }
       ╰────
      help: the keys that belong here are `brick`, `rectangle`, `file`, `part`, `scale`, `rotate` and
            `translate`
    "#);
}

#[test]
fn an_unknown_law() {
    let text = with(
        r#"law = "tresca", bound = 0.09"#,
        r#"law = "viscous", viscosity = 0.3"#,
    );
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the friction law `viscous` is not supported
        ╭─[case.toml:22:20]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "viscous", viscosity = 0.3 }
        ·                    ────┬────
        ·                        ╰── expected one of `frictionless`, `tresca`, `orthotropic`, `coulomb`, `tied` and `bilateral`
     23 │
        ╰────
      help: supported: `frictionless`, `tresca`, `orthotropic`, `coulomb`, `tied` and `bilateral`
    "#);
}

#[test]
fn a_misspelt_law() {
    let text = with(r#""tresca""#, r#""treska""#);
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the friction law `treska` is not supported
        ╭─[case.toml:22:20]
     21 │ pair = ["upper.z-", "lower.z+"]
     22 │ friction = { law = "treska", bound = 0.09 }
        ·                    ────┬───
        ·                        ╰── did you mean `tresca`?
     23 │
        ╰────
      help: supported: `frictionless`, `tresca`, `orthotropic`, `coulomb`, `tied` and `bilateral`
    "#);
}
