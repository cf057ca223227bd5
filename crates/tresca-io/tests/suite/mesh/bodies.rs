//! Bodies out of files: what is left out, put right, and refused.

use tresca_fem::mesh::Space;
use tresca_io::mesh::{MeshFault, MeshFile, MeshFileError, MeshNote, Placement, parse};

use crate::mesh::support::{body, data, solid};

/// Two tetrahedra with a common face, in the text of version 2.2; `elements` goes at the end.
fn tets(elements: &str) -> MeshFile {
    let count = 2 + elements.lines().count();
    let text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 \"skin\"\n3 2 \"body\"\n2 3 \"other\"\n$EndPhysicalNames\n\
         $Nodes\n7\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n6 9 9 9\n7 2 2 2\n$EndNodes\n\
         $Elements\n{count}\n1 4 2 2 1 1 2 3 4\n2 4 2 2 1 2 5 3 4\n{elements}$EndElements\n"
    );
    parse("tets.msh", text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

fn refusal(file: &MeshFile, space: Space, part: Option<&str>) -> MeshFileError {
    let body = file.body(space, part, &Placement::default());
    body.map(|_| ()).expect_err("must be refused")
}

#[test]
fn nodes_that_no_cell_uses_are_dropped() {
    let body = body(&tets("3 2 2 1 1 1 2 3\n"), Space::Solid, Some("body"));
    assert_eq!(body.nodes, [0, 1, 2, 3, 4]);
    assert_eq!(body.cells, [0, 1]);
    assert_eq!(body.mesh.face_sets["skin"].len(), 1);
    assert_eq!(body.mesh.node_sets["skin"], [0, 1, 2]);
    assert!(body.notes.is_empty() && body.unusable.is_empty());
}

#[test]
fn interior_and_missing_faces_spoil_their_group_only() {
    let file = tets("3 2 2 1 1 2 3 4\n4 2 2 3 1 1 2 5\n");
    let body = body(&file, Space::Solid, Some("body"));
    let texts: Vec<String> = body.unusable.values().map(ToString::to_string).collect();
    assert_eq!(
        texts,
        [
            "element 4 of the surface group `other` of `tets.msh` is not a face of any volume element, though its nodes belong to the body",
            "element 3 of the surface group `skin` of `tets.msh` lies inside of the body, between element 1 and element 2",
        ]
    );
    // A support may act on the nodes all the same.
    assert_eq!(body.mesh.node_sets["skin"], [1, 2, 3]);
    // A face of another body is no face of this one, and no fault.
    let loose = tets("3 2 2 1 1 1 2 3\n4 2 2 3 1 5 6 7\n");
    let body = crate::mesh::support::body(&loose, Space::Solid, None);
    assert_eq!(body.mesh.face_sets.keys().collect::<Vec<_>>(), ["skin"]);
    assert!(body.unusable.is_empty());
}

#[test]
fn inverted_and_degenerate_elements_go_by_their_numbers() {
    let inverted = tets("3 4 2 2 1 5 2 7 3\n");
    let text = refusal(&inverted, Space::Solid, None).to_string();
    assert_eq!(
        text,
        "element 3 of `tets.msh` is turned inside out (its centre is at [1.0, 1.0, 0.75])"
    );
    let flat = tets("3 4 2 2 1 1 5 7 2\n");
    let text = refusal(&flat, Space::Solid, None).to_string();
    assert_eq!(
        text,
        "element 3 of `tets.msh` has no volume (its centre is at [1.0, 0.75, 0.75])"
    );
}

#[test]
fn the_wrong_dimension_is_named() {
    let solids = data("solids-4.1-text.msh");
    let text = refusal(&solids, Space::Plane, Some("left")).to_string();
    assert!(
        text.ends_with("has volume elements, but the case is about bodies in a plane (plane)"),
        "{text}"
    );
    let plates = data("plates-2.2-text.msh");
    let error = refusal(&plates, Space::Solid, None);
    assert!(
        matches!(
            error.fault(),
            MeshFault::NoCells {
                dimension: 3,
                found: [4, 22 | 18 | 16.., 0]
            }
        ),
        "{error:?}"
    );
    let text = refusal(&solids, Space::Solid, Some("ends")).to_string();
    assert!(
        text.ends_with("is no volume group: it consists of surface elements"),
        "{text}"
    );
    let text = refusal(&solids, Space::Solid, Some("wedge")).to_string();
    assert!(
        text.ends_with("has no volume group `wedge`; did you mean `wedges`?"),
        "{text}"
    );
}

#[test]
fn plane_bodies_lie_in_the_plane_and_on_one_side_of_the_axis() {
    let plates = data("plates-4.1-text.msh");
    let place = |translation, space| {
        let placement = Placement {
            translation,
            ..Placement::default()
        };
        plates.body(space, Some("squares"), &placement)
    };
    let error = place([0.0, 0.0, 0.5], Space::Plane).unwrap_err();
    assert!(
        matches!(error.fault(), MeshFault::OffPlane { z: 0.5, .. }),
        "{error}"
    );
    let error = place([-1.5, 0.0, 0.0], Space::Axisymmetric).unwrap_err();
    assert!(
        matches!(
            error.fault(),
            MeshFault::NegativeRadius { radius: -0.5, .. }
        ),
        "{error}"
    );
    // Rounding of the placement is not a hole in the body.
    let body = place([-1.0 - 1e-16, 0.0, 1e-17], Space::Axisymmetric).unwrap();
    assert_eq!(body.mesh.bounding_box().min, [0.0; 3]);
    assert!((body.mesh.volume() - std::f64::consts::PI).abs() < 1e-12);
}

#[test]
fn groups_of_one_name_and_several_dimensions_keep_apart() {
    let file = tets("3 2 2 1 1 1 2 3\n4 15 2 7 1 5\n");
    let text = format!(
        "{:?}",
        file.groups
            .iter()
            .map(|g| (&g.name, g.dimension))
            .collect::<Vec<_>>()
    );
    assert_eq!(text, r#"[("body", 3), ("skin", 2), ("7", 0)]"#);
    let clash = parse(
        "clash.inp",
        b"*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n\
          *NSET, NSET=top\n4\n*SURFACE, NAME=top\n1, S1\n",
    )
    .unwrap();
    let mesh = solid(&clash, None);
    assert_eq!(mesh.node_sets["top"], [0, 1, 2]);
    assert_eq!(mesh.node_sets["0:top"], [3]);
}

#[test]
fn a_body_that_falls_apart_is_noted() {
    // Two squares that meet along x = 1 without sharing its nodes.
    let file = parse(
        "apart.inp",
        b"*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n12, 1, 0\n15, 2, 0\n16, 2, 1\n13, 1, 1\n\
          *ELEMENT, TYPE=CPS4, ELSET=one\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=CPS4, ELSET=two\n2, 12, 15, 16, 13\n",
    )
    .unwrap();
    let both = body(&file, Space::Plane, None);
    assert_eq!(
        both.notes,
        [MeshNote::DuplicateNodes {
            pairs: 2,
            first: [2, 12],
            at: [1.0, 0.0, 0.0]
        }]
    );
    assert!(both.notes[0].to_string().contains("such as 2 and 12"));
    assert!(body(&file, Space::Plane, Some("one")).notes.is_empty());
}

#[test]
fn a_middle_node_that_folds_its_element_is_named() {
    let with = |y: &str| {
        let text = format!(
            "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n4, 0.5, {y}\n5, 0.5, 0.5\n6, 0, 0.5\n*ELEMENT, TYPE=CPS6\n7, 1, 2, 3, 4, 5, 6\n"
        );
        let file = parse("curved.inp", text.as_bytes()).unwrap();
        file.body(Space::Plane, None, &Placement::default())
    };
    assert!(with("-0.1").is_ok());
    let error = with("0.6").unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("element 7 of `curved.inp` is folded"),
        "{error}"
    );
}
