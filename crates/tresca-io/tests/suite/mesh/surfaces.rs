//! Rigid surfaces.

use tresca_io::mesh::{MeshFile, Placement, Rotation, SurfaceMesh, parse};

use crate::mesh::support::data;

fn surface(file: &MeshFile, group: Option<&str>, flip: bool) -> SurfaceMesh {
    let surface = file.surface(3, group, &Placement::default(), flip);
    surface.unwrap_or_else(|error| panic!("{error}"))
}

/// ∫ x·n dΓ over the corners' triangles: three times the volume that a closed surface encloses.
fn flux(surface: &SurfaceMesh) -> f64 {
    let triple = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    let of_face = |nodes: &[usize], corners: usize| -> f64 {
        let p = |i: usize| surface.points[nodes[i]];
        (1..corners - 1)
            .map(|i| 0.5 * triple(p(0), p(i), p(i + 1)))
            .sum()
    };
    let faces = surface.faces.iter();
    faces
        .map(|(kind, nodes)| of_face(nodes, kind.corner_count()))
        .sum()
}

/// A cube of triangles and quadrilaterals, of which every second face is turned inwards.
const CUBE: &str = "*NODE
1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1
*ELEMENT, TYPE=R3D4, ELSET=Skin
1, 1, 2, 3, 4
2, 5, 6, 7, 8
3, 1, 4, 8, 5
4, 2, 3, 7, 6
5, 1, 2, 6, 5
*ELEMENT, TYPE=R3D3, ELSET=Skin
6, 4, 8, 7
7, 4, 7, 3
";

#[test]
fn a_closed_surface_has_its_normals_outwards() {
    let cube = parse("cube.inp", CUBE.as_bytes()).unwrap();
    assert!((flux(&surface(&cube, Some("Skin"), false)) - 3.0).abs() < 1e-14);
    assert!((flux(&surface(&cube, None, true)) + 3.0).abs() < 1e-14);
    // Far away from the origin too, where volumes are differences of large numbers.
    let far = Placement {
        scale: 2.0,
        rotation: Some(Rotation {
            axis: [1.0, 2.0, 3.0],
            angle: 30.0,
            about: [0.0; 3],
        }),
        translation: [0.0; 3],
    };
    let placed = cube.surface(3, None, &far, false).unwrap();
    assert!((flux(&placed) - 24.0).abs() < 1e-13);
}

#[test]
fn an_open_surface_has_the_side_of_most_of_its_faces() {
    // Without the top: of the six faces left, 1, 3 and 4 and the two triangles differ in sides.
    let open = CUBE.replace("2, 5, 6, 7, 8\n", "");
    let cube = parse("cube.inp", open.as_bytes()).unwrap();
    let (one, other) = (surface(&cube, None, false), surface(&cube, None, true));
    assert_eq!(flux(&one), -flux(&other));
    // All faces agree: what is enclosed by them and the missing top is the same, up to the sign.
    assert!((flux(&one).abs() - 2.0).abs() < 1e-14, "{}", flux(&one));
    // In the file 4, 5, 6 and 7 look outwards, 1 and 3 inwards.
    assert!(flux(&one) > 0.0);
}

#[test]
fn surfaces_that_have_no_two_sides_are_refused() {
    let error = |text: &str| {
        let file = parse("strip.inp", text.as_bytes()).unwrap();
        let error = file
            .surface(3, None, &Placement::default(), false)
            .unwrap_err();
        error.to_string()
    };
    let third = CUBE.to_owned() + "8, 1, 2, 7\n";
    let text = error(&third);
    assert!(text.contains("element 8: three faces meet there"), "{text}");
    // A strip of three quadrilaterals, joined to its beginning after half a turn.
    let strip = "*NODE\n1, 0, 0, 0\n2, 0, 0, 1\n3, 1, 0, 0\n4, 1, 0, 1\n5, 0, 1, 0\n6, 0, 1, 1
*ELEMENT, TYPE=S4\n1, 1, 3, 4, 2\n2, 3, 5, 6, 4\n3, 5, 2, 1, 6\n";
    let text = error(strip);
    assert!(text.contains("one side only"), "{text}");
}

#[test]
fn sides_of_solids_and_groups_of_gmsh_are_surfaces_too() {
    let ball = data("ball-4.1-text.msh");
    let round = surface(&ball, Some("round"), false);
    assert_eq!(round.faces.len(), 6);
    assert!(
        round
            .points
            .iter()
            .all(|p| (p.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-6)
    );
    let plates = data("plates-4.1-text.msh");
    let left = plates
        .surface(2, Some("left"), &Placement::default(), false)
        .unwrap();
    assert_eq!((left.points.len(), left.faces.len()), (3, 2));
    let turned = Placement {
        rotation: Some(Rotation {
            axis: [1.0, 0.0, 0.0],
            angle: 30.0,
            about: [0.0; 3],
        }),
        ..Placement::default()
    };
    let error = plates.surface(2, Some("left"), &turned, false).unwrap_err();
    assert!(error.to_string().contains("has z = "), "{error}");
    let error = plates
        .surface(3, Some("left"), &Placement::default(), false)
        .unwrap_err();
    assert_eq!(
        error.to_string().split(": ").last().unwrap(),
        "it consists of lines"
    );
}
