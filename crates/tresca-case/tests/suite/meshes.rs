//! Meshes out of files, placement, kinds of cells, formulations.

use tresca_fem::assembly::Formulation;
use tresca_fem::mesh::CellKind;

use crate::support::{OBSTACLES, changed, parse, parse_here, place, report, report_here, with};

/// Two boxes out of one file, the second one as long as in millimetres, put on the first.
const FILES: &str = r#"
[[body]]
name = "low"
mesh = { file = "../../../tresca-io/tests/suite/mesh/data/solids-4.1-binary.msh", part = "left" }
material = { young = 1, poisson = 0.3 }

[[body]]
name = "high"
mesh = { file = "../../../tresca-io/tests/suite/mesh/data/solids-4.1-binary.msh", part = "wedges", scale = 0.5, translate = [0, 0, 1] }
map = ["x - 2.5", "y", "z"]
material = { young = 1, poisson = 0.3 }

[[clamp]]
on = ["low.ends", "low.corner"]

[[support]]
on = ["low.edge"]
y = 0.1

[[pressure]]
on = ["low.bottom plane"]
value = 1

[[contact]]
pair = ["high.bottom plane", "low.between"]
friction = { law = "frictionless" }
"#;

fn refused(from: &str, to: &str) -> String {
    report_here(&changed(FILES, from, to))
}

#[test]
fn parts_of_a_file_are_bodies_and_their_groups_surfaces() {
    let case = parse_here(FILES).unwrap();
    let model = &case.model;
    let meshes = [0, 1].map(|body| &model.bodies()[body].mesh);
    assert!((meshes[0].volume() - 1.0).abs() < 1e-14);
    assert!((meshes[1].volume() - 0.25).abs() < 1e-14);
    // Scaled about the origin, then moved, then mapped.
    assert_eq!(meshes[1].bounding_box().min, [0.0, 0.0, 1.0]);
    assert_eq!(meshes[1].bounding_box().max, [0.5, 0.5, 2.0]);
    let on: Vec<_> = model.supports().iter().map(|s| place(&s.on[0])).collect();
    assert_eq!(on, [(0, "ends"), (0, "corner"), (0, "edge")]);
    let faces = |set: &str| meshes[0].face_sets.contains_key(set);
    assert_eq!(["ends", "corner", "edge"].map(faces), [true, false, false]);
    assert_eq!(model.nodes(&model.supports()[1].on[0]).len(), 1);
    assert_eq!(
        model.loads()[0].on.names(model.bodies()),
        ["low.bottom plane"]
    );
}

#[test]
fn names_that_are_not_in_the_file_are_near_to_others() {
    for (report, expected) in [
        (
            refused("part = \"left\"", "part = \"lift\""),
            [
                "has no volume group `lift`; did you mean `left`?",
                "its volume groups are `70`, `left`, `right` and `wedges`",
                "\"lift\"",
            ],
        ),
        (
            refused("part = \"left\"", "part = \"ends\""),
            [
                "is no volume group: it consists of surface elements",
                "bodies are physical volumes",
                "\"ends\"",
            ],
        ),
        (
            refused("low.between", "low.betwen"),
            [
                "the body `low` has no face `betwen`",
                "did you mean `low.between`?",
                "the faces of the mesh of `../../../tresca-io/tests/suite/mesh/data/solids-4.1-binary.msh` are `between`, `bottom plane` and `ends`",
            ],
        ),
        (
            refused("[\"low.bottom plane\"]", "[\"low.corner\"]"),
            [
                "`low.corner` is a set of nodes, not a surface",
                "expected faces",
                "only clamps and supports act on points and curves",
            ],
        ),
        (
            refused("\"low.corner\"", "\"low.cornr\""),
            [
                "has no face `cornr`",
                "did you mean `low.corner`?",
                "`bottom plane`, `corner`",
            ],
        ),
        // Of the whole file, the face between two boxes is inside.
        (
            refused(", part = \"left\"", ""),
            [
                "of the surface group `between` of",
                "lies inside of the body, between element",
                "take the inner faces out of the group",
            ],
        ),
        (
            refused("solids-4.1-binary.msh\", part = \"left\"", "solid.msh\""),
            [
                "cannot read the mesh file",
                "solid.msh",
                "from the directory of the case file",
            ],
        ),
        (
            refused("solids-4.1-binary.msh\", part = \"left\"", "plates.inp\""),
            [
                "plates.inp` has no volume elements",
                "it has 0 volume",
                "generated in two dimensions only",
            ],
        ),
        (
            refused("solids-4.1-binary.msh\", part = \"left\"", "generate.py\""),
            [
                "is no mesh file of a known format",
                "Gmsh's .msh files",
                "generate.py",
            ],
        ),
    ] {
        for part in expected {
            assert!(report.contains(part), "{part} is not in\n{report}");
        }
        assert!(report.contains("case.toml:"), "{report}");
    }
}

#[test]
fn a_clamp_may_act_on_the_nodes_of_an_inner_surface() {
    let whole = FILES
        .replace(", part = \"left\"", "")
        .replace("low.corner", "low.between");
    let whole = whole.split("[[contact]]").next().unwrap();
    let case = parse_here(whole).unwrap();
    assert_eq!(place(&case.model.supports()[1].on[0]), (0, "between"));
}

#[test]
fn bricks_are_placed_and_cut_into_cells() {
    let case = parse_here(OBSTACLES).unwrap();
    let bodies = case.model.bodies();
    let cells = |i: usize| bodies[i].mesh.cells[0].kind;
    assert_eq!((cells(0), cells(1)), (CellKind::Tet10, CellKind::Hex8));
    // Twice as large, turned by a right angle, lifted.
    let extent = bodies[0].mesh.bounding_box();
    assert_eq!(
        (extent.min, extent.max),
        ([-2.0, 0.0, 1.0], [0.0, 2.0, 3.0])
    );
    assert_eq!(bodies[0].formulation, Formulation::Full);
    assert_eq!(bodies[1].formulation, Formulation::BBar);
    let plane = |cells: &str| {
        let text = format!(
            "analysis = \"axisymmetric\"\n[[body]]\nname = \"b\"\nmaterial = {{ young = 1, poisson = 0 }}\n\
             mesh = {{ rectangle = {{ min = [-1, 0], max = [1, 1], nodes = [2, 2], cells = \"{cells}\" }}, \
             rotate = {{ angle = 180, about = [1, 0] }} }}"
        );
        let case = parse(&text).unwrap();
        // In the plane the axis is that of z, and a placed rectangle may start left of the axis.
        let mesh = &case.model.bodies()[0].mesh;
        let extent = mesh.bounding_box();
        assert!((extent.min[0] - 1.0).abs() < 1e-14 && (extent.max[0] - 3.0).abs() < 1e-14);
        mesh.cells[0].kind.to_string()
    };
    let kinds = [
        "quad", "quad4", "quad8", "quad9", "triangle", "tri3", "tri6",
    ]
    .map(plane);
    assert_eq!(
        kinds,
        ["quad4", "quad4", "quad8", "quad9", "tri3", "tri3", "tri6"]
    );
}

#[test]
fn impossible_meshes_are_refused() {
    for (text, message, label) in [
        (
            with("{ brick = {", "{ file = \"a.msh\", brick = {"),
            "`brick` and `file` exclude each other",
            "expected one of them",
        ),
        (
            with(
                "{ brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }",
                "{ scale = 2 }",
            ),
            "the body has no mesh",
            "expected `brick`, `rectangle` or `file`",
        ),
        (
            with("{ brick = {", "{ part = \"a\", brick = {"),
            "only the mesh of a file has parts",
            "expected `file` along with it",
        ),
        (
            with("{ brick = {", "{ scale = 0, brick = {"),
            "the scale must be positive",
            "expected more than 0, found 0.0",
        ),
        (
            with("{ brick = {", "{ translate = [1, 2], brick = {"),
            "a list of the wrong length",
            "expected a list of three numbers [x, y, z], found 2 entries",
        ),
        (
            with("{ brick = {", "{ rotate = { angle = 90 }, brick = {"),
            "missing key `axis`",
            "expected `axis` in this table",
        ),
        (
            with(
                "{ brick = {",
                "{ rotate = { angle = 90, axis = [0, 0, 0] }, brick = {",
            ),
            "the axis has no direction",
            "expected a vector that is not zero",
        ),
        (
            with(
                "{ brick = {",
                "{ rotate = { angle = inf, axis = [0, 0, 1] }, brick = {",
            ),
            "the angle is not a finite number",
            "",
        ),
        (
            with(
                "nodes = [16, 16, 16] }",
                "nodes = [16, 16, 16], cells = \"tet\" }",
            ),
            "`tet` is not among the choices here",
            "did you mean `tet4`?",
        ),
        (
            with(
                "poisson = 0.277 }",
                "poisson = 0.277 }\nformulation = \"bbar\"",
            ),
            "`bbar` is not among the choices here",
            "did you mean `b_bar`?",
        ),
    ] {
        let report = report(&text);
        assert!(
            report.contains(message) && report.contains(label),
            "{report}"
        );
    }
}
