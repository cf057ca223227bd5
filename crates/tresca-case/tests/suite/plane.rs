//! Plane and axisymmetric cases, and maps.

use insta::assert_snapshot;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{CellKind, Space};
use tresca_model::{Body, LoadKind};

use crate::support::{PLANE, RICH, changed, parse, report, with};

fn plane(from: &str, to: &str) -> String {
    changed(PLANE, from, to)
}

#[test]
fn a_plane_case_is_read_as_it_stands() {
    let case = parse(PLANE).unwrap();
    let model = &case.model;
    assert_eq!((model.space(), model.dimension()), (Space::Plane, 2));
    let [block, ground] = &model.bodies()[..] else {
        panic!("not two bodies");
    };
    let extent = block.mesh.bounding_box();
    assert_eq!((extent.min, extent.max), ([0.0; 3], [2.0, 1.0, 0.0]));
    assert_eq!(block.mesh.node_count(), 15);
    let kind = |body: &Body| body.mesh.cells[0].kind;
    assert_eq!(
        (kind(block), kind(ground)),
        (CellKind::Quad4, CellKind::Tri3)
    );
    // The map took the far corner below the others.
    let extent = ground.mesh.bounding_box();
    assert_eq!(
        (extent.min, extent.max),
        ([0.0, -1.4, 0.0], [2.0, 0.0, 0.0])
    );
    assert_eq!(model.supports()[0].components, [None, Some(0.0), None]);
    let LoadKind::Traction(traction) = &model.loads()[0].kind else {
        panic!("another load");
    };
    assert_eq!(traction.value.constant(), Some([0.0, -1.0, 0.0]));
}

#[test]
fn the_words_of_all_analyses() {
    let steel = Isotropic::new(1.0, 0.3).unwrap();
    for (word, space, material) in [
        ("plane_strain", Space::Plane, steel),
        ("plane_stress", Space::Plane, steel.plane_stress()),
        ("axisymmetric", Space::Axisymmetric, steel),
    ] {
        let case = parse(&plane("plane_strain", word)).unwrap();
        assert_eq!(case.model.space(), space);
        assert_eq!(case.model.bodies()[0].material, material);
    }
    assert_eq!(parse(RICH).unwrap().model.space(), Space::Solid);
}

#[test]
fn an_unknown_analysis() {
    assert_snapshot!(report(&plane("plane_strain", "plain_strain")), @r#"
    case::bad_value

      × `plain_strain` is not among the choices here
       ╭─[case.toml:1:12]
     1 │ analysis = "plain_strain"
       ·            ───────┬──────
       ·                   ╰── did you mean `plane_strain`?
     2 │
       ╰────
      help: supported: `solid`, `plane_strain`, `plane_stress` and `axisymmetric`
    "#);
}

#[test]
fn an_analysis_that_is_a_number() {
    assert_snapshot!(report(&plane("\"plane_strain\"", "2")), @r#"
    case::wrong_type

      × expected a text in quotes
       ╭─[case.toml:1:12]
     1 │ analysis = 2
       ·            ┬
       ·            ╰── found the number 2
     2 │
       ╰────
    "#);
}

#[test]
fn a_rectangle_in_space() {
    assert_snapshot!(report(&plane("analysis = \"plane_strain\"\n", "")), @r#"
    case::bad_value

      × a rectangle does not belong in a case with `analysis = "solid"`
       ╭─[case.toml:4:22]
     3 │ name = "block"
     4 │ mesh = { rectangle = { min = [0, 0], max = [2, 1], nodes = [5, 3] } }
       ·                      ───────────────────────┬──────────────────────
       ·                                             ╰── expected `brick`
     5 │ material = { young = 1, poisson = 0.3 }
       ╰────
      help: plane cases have the key `analysis` at the top of the file: `plane_strain`, `plane_stress`
            or `axisymmetric`
    "#);
}

#[test]
fn a_brick_in_the_plane() {
    let text = plane(
        "{ rectangle = { min = [0, 0], max = [2, 1], nodes = [5, 3] } }",
        "{ brick = { min = [0, 0, 0], max = [2, 1, 1], nodes = [5, 3, 3] } }",
    );
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × a brick does not belong in a case with `analysis = "plane_strain"`
       ╭─[case.toml:1:12]
     1 │ analysis = "plane_strain"
       ·            ───────┬──────
       ·                   ╰── the analysis
     2 │
       ╰────
       ╭─[case.toml:5:18]
     4 │ name = "block"
     5 │ mesh = { brick = { min = [0, 0, 0], max = [2, 1, 1], nodes = [5, 3, 3] } }
       ·                  ───────────────────────────┬───────────────────────────
       ·                                             ╰── expected `rectangle`
     6 │ material = { young = 1, poisson = 0.3 }
       ╰────
      help: without the key `analysis` a case is about bodies in space
    "#);
}

#[test]
fn a_rectangle_with_three_coordinates() {
    assert_snapshot!(report(&plane("[2, 1]", "[2, 1, 1]")), @r#"
    case::wrong_type

      × a list of the wrong length
       ╭─[case.toml:5:44]
     4 │ name = "block"
     5 │ mesh = { rectangle = { min = [0, 0], max = [2, 1, 1], nodes = [5, 3] } }
       ·                                            ────┬────
       ·                                                ╰── expected a list of two numbers [x, y], found 3 entries
     6 │ material = { young = 1, poisson = 0.3 }
       ╰────
    "#);
}

#[test]
fn a_rectangle_without_area() {
    assert_snapshot!(report(&plane("[2, 1]", "[2, 0]")), @r#"
    case::bad_value

      × the rectangle has zero area: no extent along y
       ╭─[case.toml:5:48]
     4 │ name = "block"
     5 │ mesh = { rectangle = { min = [0, 0], max = [2, 0], nodes = [5, 3] } }
       ·                                  ┬             ┬
       ·                                  │             ╰── expected more than 0.0, found 0.0
       ·                                  ╰── the other end
     6 │ material = { young = 1, poisson = 0.3 }
       ╰────
      help: a body is solid; give it an extent in every direction
    "#);
}

#[test]
fn a_rectangle_of_too_many_nodes() {
    assert_snapshot!(report(&plane("[5, 3]", "[50000, 30000]")), @r#"
    case::bad_value

      × too many nodes
       ╭─[case.toml:5:60]
     4 │ name = "block"
     5 │ mesh = { rectangle = { min = [0, 0], max = [2, 1], nodes = [50000, 30000] } }
       ·                                                            ───────┬──────
       ·                                                                   ╰── expected at most 100000000 in all, found 1500000000
     6 │ material = { young = 1, poisson = 0.3 }
       ╰────
      help: the two counts are multiplied: [41, 41] are 1681 nodes
    "#);
}

#[test]
fn unknown_cells() {
    assert_snapshot!(report(&plane("\"triangle\"", "\"triangles\"")), @r#"
    case::bad_value

      × `triangles` is not among the choices here
        ╭─[case.toml:10:77]
      9 │ name = "ground"
     10 │ mesh = { rectangle = { min = [0, -1], max = [2, 0], nodes = [5, 3], cells = "triangles" } }
        ·                                                                             ─────┬─────
        ·                                                                                  ╰── did you mean `triangle`?
     11 │ map = ["x", "y - 0.1*x^2"]
        ╰────
      help: supported: `quad`, `quad4`, `quad8`, `quad9`, `tri3`, `triangle` and `tri6`
    "#);
}

#[test]
fn a_face_that_only_a_brick_has() {
    assert_snapshot!(report(&plane("block.y+", "block.z+")), @r#"
    case::bad_reference

      × the body `block` has no face `z+`
        ╭─[case.toml:20:7]
     19 │ [[traction]]
     20 │ on = ["block.z+"]
        ·       ─────┬────
        ·            ╰── did you mean `block.x+`?
     21 │ value = [0, -1]
        ╰────
      help: the faces of a rectangle are `x-`, `x+`, `y-` and `y+`
    "#);
}

#[test]
fn a_body_across_the_axis() {
    let text = plane("plane_strain", "axisymmetric").replace("min = [0, 0]", "min = [-1, 0]");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the body crosses the axis of revolution
       ╭─[case.toml:5:31]
     4 │ name = "block"
     5 │ mesh = { rectangle = { min = [-1, 0], max = [2, 1], nodes = [5, 3] } }
       ·                               ─┬
       ·                                ╰── expected a radius of 0 or more, found -1.0
     6 │ material = { young = 1, poisson = 0.3 }
       ╰────
      help: in an axisymmetric case x is the radius and y runs along the axis
    "#);
}

/// What the map makes of a negative x is seen on the mesh only.
#[test]
fn a_map_may_move_a_body_from_the_axis() {
    let text = plane("plane_strain", "axisymmetric");
    let text = text.replace("min = [0, -1]", "min = [-1, -1]");
    let text = text.replace("[\"x\",", "[\"x + 1\",");
    assert!(parse(&text).is_ok());
}

#[test]
fn a_map_with_too_few_coordinates() {
    let text = changed(RICH, r#"["x + 0.1*z", "y", "z"]"#, r#"["x", "y"]"#);
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × a list of the wrong length
       ╭─[case.toml:7:7]
     6 │ mesh = { brick = { min = [0, 0, 1], max = [2, 1, 2], nodes = [5, 3, 3] } }
     7 │ map = ["x", "y"]
       ·       ─────┬────
       ·            ╰── expected a list of three numbers [x, y, z], found 2 entries
     8 │ material = { young = 5.0e4, poisson = 0.277, density = 7.8 }
       ╰────
      help: `analysis = "solid"` has 3 coordinates
    "#);
}

#[test]
fn a_map_that_is_a_text() {
    let text = changed(RICH, r#"["x + 0.1*z", "y", "z"]"#, r#""2*x""#);
    assert_snapshot!(report(&text), @r#"
    case::wrong_type

      × expected a list
       ╭─[case.toml:7:7]
     6 │ mesh = { brick = { min = [0, 0, 1], max = [2, 1, 2], nodes = [5, 3, 3] } }
     7 │ map = "2*x"
       ·       ──┬──
       ·         ╰── found the text "2*x"
     8 │ material = { young = 5.0e4, poisson = 0.277, density = 7.8 }
       ╰────
      help: a list has brackets, also with one entry: ["2*x"]
    "#);
}

#[test]
fn a_z_in_the_plane() {
    assert_snapshot!(report(&plane("y - 0.1*x^2", "y - z")), @r#"
    case::bad_value

      × there is no z with `analysis = "plane_strain"`
        ╭─[case.toml:11:13]
     10 │ mesh = { rectangle = { min = [0, -1], max = [2, 0], nodes = [5, 3], cells = "triangle" } }
     11 │ map = ["x", "y - z"]
        ·             ───┬───
        ·                ╰── expected a formula in x and y
     12 │ material = { young = 1, poisson = 0.3 }
        ╰────
      help: a plane case has the coordinates x and y
    "#);
}

#[test]
fn a_support_along_z_in_the_plane() {
    assert_snapshot!(report(&plane("y = 0", "z = 0")), @r#"
    case::unknown_key

      × there is no z with `analysis = "plane_strain"`
        ╭─[case.toml:17:5]
     16 │ on = ["ground.y-"]
     17 │ z = 0
        ·     ┬
        ·     ╰── expected `x` and `y` only
     18 │
        ╰────
      help: remove the key `z`
    "#);
}

#[test]
fn a_traction_with_three_components_in_the_plane() {
    assert_snapshot!(report(&plane("[0, -1]\n", "[0, -1, 0]\n")), @r#"
    case::wrong_type

      × a list of the wrong length
        ╭─[case.toml:21:9]
     20 │ on = ["block.y+"]
     21 │ value = [0, -1, 0]
        ·         ─────┬────
        ·              ╰── expected a list of two numbers [x, y], found 3 entries
     22 │
        ╰────
      help: `analysis = "plane_strain"` has 2 coordinates
    "#);
}

#[test]
fn a_density_and_a_negative_one() {
    let case = parse(RICH).unwrap();
    let bodies = case.model.bodies();
    assert_eq!([bodies[0].density, bodies[1].density], [Some(7.8), None]);
    let text = with("poisson = 0.277", "poisson = 0.277, density = -7.8");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × the density must not be negative
       ╭─[case.toml:6:56]
     5 │ mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
     6 │ material = { young = 5.0e4, poisson = 0.277, density = -7.8 }
       ·                                                        ──┬─
       ·                                                          ╰── expected 0 or more, found -7.8
     7 │
       ╰────
      help: it is the mass per volume
    "#);
}
