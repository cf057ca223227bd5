//! Values of the right type that no body, material or law can have.

mod support;

use insta::assert_snapshot;
use support::{report, with};

#[test]
fn poisson_one_half() {
    let text = with("0.277", "0.5");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn poisson_minus_one() {
    let text = with("0.277", "-1");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn poisson_and_young_exchanged() {
    let text = with(
        "young = 5.0e4, poisson = 0.277",
        "young = 0.277, poisson = 5.0e4",
    );
    assert_snapshot!(report(&text), @"");
}

#[test]
fn young_zero() {
    let text = with("5.0e4", "0");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn young_nan() {
    let text = with("5.0e4", "nan");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn a_coordinate_that_is_infinite() {
    let text = with("[2.0, 1.0, 2.0]", "[2.0, inf, 2.0]");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn a_traction_beyond_the_range() {
    let text = with("-1.0]", "-1e400]");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn a_negative_bound() {
    let text = with("0.09", "-0.09");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn a_bound_that_is_nan() {
    let text = with("0.09", "nan");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn a_missing_bound() {
    let text = with(", bound = 0.09", "");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn zero_volume() {
    let text = with("max = [2.0, 1.0, 2.0]", "max = [2.0, 0.0, 2.0]");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn corners_exchanged() {
    let text = with(
        "min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0]",
        "min = [2.0, 1.0, 2.0], max = [0.0, 0.0, 1.0]",
    );
    assert_snapshot!(report(&text), @"");
}

#[test]
fn a_brick_far_from_the_origin() {
    let text = with(
        "min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0]",
        "min = [1e16, 0.0, 1.0], max = [1.0000000000000002e16, 1.0, 2.0]",
    );
    assert_snapshot!(report(&text), @"");
}

#[test]
fn a_volume_that_underflows() {
    let text = with(
        "min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0]",
        "min = [0, 0, 0], max = [1e-120, 1e-120, 1e-120]",
    );
    assert_snapshot!(report(&text), @"");
}

#[test]
fn one_node() {
    let text = with("[16, 16, 16]", "[16, 1, 16]");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn nodes_whose_product_overflows() {
    let text = with("[16, 16, 16]", "[4000000000, 4000000000, 4000000000]");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn too_many_nodes() {
    let text = with("[16, 16, 16]", "[1000, 1000, 1000]");
    assert_snapshot!(report(&text), @"");
}

#[test]
fn an_unknown_mesh_kind() {
    let text = with(
        "{ brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }",
        r#"{ gmsh = "part.msh" }"#,
    );
    assert_snapshot!(report(&text), @"");
}

#[test]
fn an_unknown_law() {
    let text = with(
        r#"law = "tresca", bound = 0.09"#,
        r#"law = "coulomb", coefficient = 0.3"#,
    );
    assert_snapshot!(report(&text), @"");
}

#[test]
fn a_misspelt_law() {
    let text = with(r#""tresca""#, r#""treska""#);
    assert_snapshot!(report(&text), @"");
}
