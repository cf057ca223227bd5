//! Obstacles, and contacts that find their pairs.

use tresca_contact::{CouplingMethod, RigidShape as Shape};
use tresca_model::{ObstacleId, Partner, Step};

use crate::support::{OBSTACLES, PLANE, changed, parse, parse_here, place, report_here};

fn refused(from: &str, to: &str) -> String {
    report_here(&changed(OBSTACLES, from, to))
}

#[test]
fn every_shape_is_read() {
    let case = parse_here(OBSTACLES).unwrap();
    let [table, ball, bore, tool] = case.model.obstacles() else {
        panic!("{:?}", case.model.obstacles())
    };
    assert_eq!(table.name, "table");
    assert_eq!(table.motion, Some([0.0, 0.0, 0.5]));
    let Shape::Plane { point, normal } = table.shape else {
        panic!("{table:?}")
    };
    assert_eq!((point, normal), ([0.0, 0.0, 1.0], [0.0, 0.0, 3.0]));
    let Shape::Sphere {
        center,
        radius,
        inside,
    } = ball.shape
    else {
        panic!("{ball:?}")
    };
    assert_eq!((center, radius, inside), ([5.0, 0.0, 2.0], 2.0, false));
    assert_eq!(ball.motion, None);
    let Shape::Cylinder {
        axis,
        radius,
        inside,
        ..
    } = bore.shape
    else {
        panic!("{bore:?}")
    };
    assert_eq!((axis, radius, inside), ([0.0, 0.0, 1.0], 4.0, true));
    let Shape::Surface(surface) = &tool.shape else {
        panic!("{tool:?}")
    };
    for [x, y, z] in &surface.points {
        let radius = (x * x + y * y + (z - 9.0) * (z - 9.0)).sqrt();
        assert!((radius - 0.5).abs() < 1e-6, "{radius}");
    }
}

#[test]
fn contacts_have_a_surface_an_obstacle_or_a_distance() {
    let case = parse_here(OBSTACLES).unwrap();
    let [stand, near, tool] = case.model.contacts() else {
        panic!("{:?}", case.model.contacts())
    };
    assert_eq!(place(&stand.slave), (0, "z-"));
    assert_eq!(stand.master, Partner::Obstacle(ObstacleId(0)));
    assert_eq!(
        (stand.coupling, stand.search),
        (CouplingMethod::Mortar, Some(0.5))
    );
    assert_eq!(place(&near.slave), (0, "near:lid"));
    assert_eq!(near.master.surface().map(place), Some((1, "near:block")));
    assert_eq!(
        (near.coupling, near.search),
        (CouplingMethod::Auto, Some(0.1))
    );
    assert_eq!(tool.master, Partner::Obstacle(ObstacleId(3)));
    // Without a list all bodies are looked at.
    let all = parse_here(&changed(OBSTACLES, "bodies = [\"lid\", \"block\"]\n", "")).unwrap();
    assert_eq!(all.model.contacts()[1].slave, near.slave);
}

#[test]
fn motions_follow_the_steps() {
    let case = parse_here(OBSTACLES).unwrap();
    let motion = |step: &Step, i: usize| {
        let obstacle = &case.model.obstacles()[i];
        obstacle.motion_by(step.amount(ObstacleId(i)))
    };
    let steps = case.model.steps().iter();
    let motions: Vec<_> = steps.map(|s| [motion(s, 0), motion(s, 1)]).collect();
    let still = [0.0; 3];
    assert_eq!(
        motions,
        [
            [[0.0, 0.0, 0.25], still],
            [[0.0, 0.0, -0.375], [0.5, 0.0, 0.0]],
            [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0]],
        ]
    );
    let once = OBSTACLES.split("[[step]]").next().unwrap();
    let case = parse_here(once).unwrap();
    assert_eq!(motion(&case.model.whole_step(), 0), [0.0, 0.0, 0.5]);
}

#[test]
fn in_the_plane_there_are_lines_and_circles() {
    let with = |obstacle: &str| {
        format!(
            "{PLANE}\n[[obstacle]]\nname = \"rigid\"\n{obstacle}\n[[contact]]\npair = [\"block.y+\", \"rigid\"]\nfriction = {{ law = \"frictionless\" }}\n"
        )
    };
    let case = parse(&with(
        "circle = { center = [1, 3], radius = 2 }\nmotion = [0, -1]",
    ))
    .unwrap();
    let Shape::Cylinder { point, axis, .. } = case.model.obstacles()[0].shape else {
        panic!("{:?}", case.model.obstacles())
    };
    assert_eq!((point, axis), ([1.0, 3.0, 0.0], [0.0, 0.0, 1.0]));
    assert_eq!(case.model.obstacles()[0].motion, Some([0.0, -1.0, 0.0]));
    let case = parse(&with("plane = { point = [0, 1], normal = [0, -1] }")).unwrap();
    assert!(matches!(
        case.model.obstacles()[0].shape,
        Shape::Plane {
            normal: [0.0, -1.0, 0.0],
            ..
        }
    ));
    for (shape, expected) in [
        (
            "sphere = { center = [0, 0, 0], radius = 1 }",
            "a sphere does not belong in a case with `analysis = \"plane_strain\"`",
        ),
        (
            "plane = { point = [0, 1, 0], normal = [0, -1] }",
            "expected a list of two numbers [x, y], found 3 entries",
        ),
    ] {
        let report = report_here(&with(shape));
        assert!(report.contains(expected), "{report}");
    }
}

#[test]
fn impossible_obstacles_and_contacts_are_refused() {
    for (report, expected) in [
        (
            refused("name = \"ball\"", "name = \"Lid\""),
            [
                "the name `Lid` is given twice",
                "bodies and obstacles have different names",
            ],
        ),
        (
            refused("name = \"ball\"", "name = \"a.b\""),
            ["this cannot be the name of an obstacle", "found `.`"],
        ),
        (
            refused("sphere = { center = [5, 0, 2], radius = 2 }", ""),
            [
                "the obstacle `ball` has no shape",
                "`plane`, `sphere`, `cylinder`, `circle` and `surface`",
            ],
        ),
        (
            refused(
                "sphere = {",
                "plane = { point = [0, 0, 0], normal = [0, 0, 1] }\nsphere = {",
            ),
            [
                "`plane` and `sphere` exclude each other",
                "the second shape",
            ],
        ),
        (
            refused("normal = [0, 0, 3]", "normal = [0, 0, 0]"),
            [
                "the normal has no direction",
                "expected a vector that is not zero",
            ],
        ),
        (
            refused("radius = 2 }", "radius = -2 }"),
            [
                "the radius must be positive",
                "`inside = true` puts the body into",
            ],
        ),
        (
            refused(
                "sphere = { center = [5, 0, 2]",
                "circle = { center = [5, 0, 2]",
            ),
            [
                "a circle does not belong in a case with `analysis = \"solid\"`",
                "expected `cylinder`",
            ],
        ),
        (
            refused("group = \"round\"", "group = \"sound\""),
            [
                "has no surface group `sound`; did you mean `round`?",
                "its surface groups are `floor` and `round`",
            ],
        ),
        (
            refused("[\"block.z-\", \"table\"]", "[\"block.z-\", \"tabel\"]"),
            ["there is no obstacle `tabel`", "did you mean `table`?"],
        ),
        (
            refused("[\"block.z-\", \"table\"]", "[\"table\", \"block.z-\"]"),
            [
                "the first of a pair is a surface of a body",
                "write the obstacle second",
            ],
        ),
        (
            refused("[\"lid.z+\", \"tool\"]", "[\"block.z-\", \"table\"]"),
            [
                "these two surfaces are already a contact pair",
                "the second time",
            ],
        ),
        (
            refused(
                "within = 0.1",
                "within = 0.1\npair = [\"lid.z+\", \"tool\"]",
            ),
            [
                "`pair` and `within` exclude each other",
                "remove one of the two",
            ],
        ),
        (
            refused("within = 0.1\nbodies = [\"lid\", \"block\"]", ""),
            ["missing key `pair`", "`within = 0.1` finds the pairs"],
        ),
        (
            refused("within = 0.1", "pair = [\"lid.z-\", \"table\"]"),
            [
                "a given pair takes no `bodies`",
                "expected `within` along with it",
            ],
        ),
        (
            refused("bodies = [\"lid\", \"block\"]", "bodies = [\"lid\"]"),
            [
                "pairs are found between different bodies",
                "expected two bodies or more",
            ],
        ),
        (
            refused("search = 0.5", "search = 0"),
            ["the search distance must be positive", "found 0.0"],
        ),
        (
            refused("coupling = \"mortar\"", "coupling = \"mortars\""),
            [
                "`mortars` is not among the choices here",
                "did you mean `mortar`?",
            ],
        ),
        (
            refused("factors = { table = 0.5 }", "factors = { ball = 0.5 }"),
            [
                "the obstacle `ball` has no motion",
                "give it a key `motion`",
            ],
        ),
        (
            refused("ball = [1, 0, 0]", "ball = [1, 0]"),
            ["a list of the wrong length", "found 2 entries"],
        ),
        (
            refused("name = \"stand\"", "name = \"table\""),
            [
                "the name `table` is given twice",
                "supports, loads, obstacles and contacts",
            ],
        ),
    ] {
        for part in expected {
            assert!(report.contains(part), "{part} is not in\n{report}");
        }
    }
}
