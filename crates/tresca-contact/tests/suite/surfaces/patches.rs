//! Smooth patches: a node on a sharp edge has a pair on either side of it; a smooth surface is one patch.

use tresca_contact::{
    ContactData, ContactError, ContactSurface, CouplingMethod, RigidShape, RigidSurface,
    SmoothPatches, couple, couple_obstacle, patches,
};
use tresca_fem::mesh::{CellKind, Face, Mesh, RectangleSpec, Space, rectangle};

use super::curved::shell;
use super::flat::KINDS;
use super::support::{Body, INTERFACE, add_product, block, boundary_where, field, mortar};

const SHARP: f64 = 30.0 * std::f64::consts::PI / 180.0;

/// A unit cube with the faces x = 1 and z = 1.
fn wedge(kind: CellKind, cells: [usize; 3]) -> Body {
    let mesh = block(kind, [0.0; 3], [1.0; 3], cells);
    let faces = [0, 2]
        .map(|k| boundary_where(&mesh, |p| p[k] == 1.0))
        .concat();
    in_patches(mesh, faces)
}

fn in_patches(mesh: Mesh, faces: Vec<Face>) -> Body {
    let mut body = Body::new(mesh, |_| false);
    body.patches = Some(patches(&body.mesh, &faces, SHARP).unwrap());
    body.faces = faces;
    body
}

/// What a mesh around the unit cube shows to its sides x = 1 and z = 1: a block with a notch.
fn notch(kind: CellKind, cells: usize) -> Body {
    let whole = block(
        CellKind::Hex8,
        [0.0; 3],
        [2.0, 1.0, 2.0],
        [2 * cells, cells, 2 * cells],
    );
    let outside = |cell: &usize| {
        let nodes = whole.cell(*cell).nodes.iter();
        let centre = nodes.map(|&n| whole.points[n]).fold([0.0; 3], |sum, p| {
            std::array::from_fn(|k| sum[k] + p[k] / 8.0)
        });
        centre[0] > 1.0 || centre[2] > 1.0
    };
    let kept: Vec<usize> = (0..whole.cell_count()).filter(outside).collect();
    let mesh = whole.submesh(&kept).0.with_cells(kind).unwrap();
    Body::new(mesh, |[x, _, z]| {
        (x == 1.0 && z <= 1.0) || (z == 1.0 && x <= 1.0)
    })
}

/// The conformance list of the seam, for a slave of the two faces of a unit cube and whatever partner.
fn check(name: &str, slave: &Body, data: &ContactData) {
    let own = slave.patches.as_ref().unwrap();
    assert_eq!(own.count(), 2, "{name}");
    let surface = ContactSurface::in_patches(&slave.mesh, &slave.faces, own).unwrap();
    let nodes = slave.mesh.nodes_of_faces(&slave.faces);
    let on_edge =
        |node: usize| slave.mesh.points[node][0] == 1.0 && slave.mesh.points[node][2] == 1.0;
    let edge = nodes.iter().filter(|&&node| on_edge(node)).count();
    assert!(edge > 1);
    // Pairs are by node and patch, one for each, and nothing is left out.
    assert_eq!(data.pairs.len(), nodes.len() + edge, "{name}");
    assert_eq!(data.pairs.len(), surface.nodes.len());
    assert!(data.uncoupled.is_empty() && data.held_pairs == 0);
    let keys: Vec<_> = data
        .pairs
        .iter()
        .map(|pair| (pair.slave_node, pair.patch))
        .collect();
    assert!(
        keys.is_sorted() && keys.windows(2).all(|w| w[0] != w[1]),
        "{name}"
    );

    for (pair, node) in data.pairs.iter().zip(&surface.nodes) {
        assert_eq!((pair.slave_node, pair.patch), (node.node, node.patch));
        // The normal and the area of its own patch.
        let axis = if pair.point[0] == 1.0
            && (pair.point[2] < 1.0 || normal_axis(pair.frame.normal) == 0)
        {
            0
        } else {
            2
        };
        for k in 0..3 {
            let expected = if k == axis { 1.0 } else { 0.0 };
            assert!((pair.frame.normal[k] - expected).abs() < 1e-13, "{name}");
            assert!((node.normal[k] - expected).abs() < 1e-13, "{name}");
        }
        assert!(
            (pair.area - node.area).abs() < 1e-13,
            "{name}: {} {}",
            pair.area,
            node.area
        );
        assert!(pair.gap.abs() < 1e-13);
    }
    for of_node in data.pairs.chunk_by(|a, b| a.slave_node == b.slave_node) {
        assert_eq!(
            of_node.len(),
            if on_edge(of_node[0].slave_node) { 2 } else { 1 }
        );
        if let [a, b] = of_node {
            let cosine: f64 = (0..3).map(|k| a.frame.normal[k] * b.frame.normal[k]).sum();
            assert!(cosine.abs() < 1e-13);
        }
    }
    // Each patch has its area, the two together the surface.
    for patch in 0..2 {
        let own = data.pairs.iter().filter(|pair| pair.patch == patch);
        assert!(
            (own.map(|pair| pair.area).sum::<f64>() - 1.0).abs() < 1e-13,
            "{name}"
        );
    }
    assert!((data.overlap_area - 2.0).abs() < 1e-13);
    // Rows of their own: a translation is seen along each normal.
    let motion = [0.3, -0.2, 0.5];
    let mut moved = vec![0.0; data.slave_coupling.nrows()];
    add_product(
        &data.slave_coupling,
        &field(&slave.mesh, |_| motion),
        &mut moved,
    );
    for (pair, approach) in data.pairs.iter().zip(&moved) {
        let expected = motion[normal_axis(pair.frame.normal)];
        assert!((approach - expected).abs() < 1e-12, "{name}");
    }
}

fn normal_axis(normal: [f64; 3]) -> usize {
    usize::from(normal[2] > 0.5) * 2
}

#[test]
fn a_node_on_an_edge_has_a_pair_for_each_of_its_faces() {
    let linear = wedge(CellKind::Hex8, [3, 2, 3]);
    let matching = notch(CellKind::Hex8, 3);
    let as_fine = wedge(CellKind::Hex8, [3, 3, 3]);
    let data = couple(
        as_fine.side(),
        matching.side(),
        INTERFACE,
        CouplingMethod::NodeByNode,
        None,
    )
    .unwrap();
    check("node by node", &as_fine, &data);

    for partner in [CellKind::Hex8, CellKind::Tet4] {
        check("mortar", &linear, &mortar(&linear, &notch(partner, 2)));
    }
    let points = [
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 1.0, 1.0],
        [1.0, 0.0, 1.0],
        [0.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
    ];
    let rigid = RigidShape::Surface(RigidSurface {
        points: points.to_vec(),
        faces: vec![
            (CellKind::Quad4, vec![0, 3, 2, 1]),
            (CellKind::Quad4, vec![4, 5, 2, 3]),
        ],
    });
    for kind in [CellKind::Hex8, CellKind::Wedge6, CellKind::Tet4] {
        let slave = wedge(kind, [3, 2, 3]);
        let data = couple_obstacle(slave.side(), &rigid, INTERFACE, None).unwrap();
        check(kind.name(), &slave, &data);
    }
}

/// Values given by node are those of the node, whatever its patches.
#[test]
fn values_by_node_go_to_every_pair_of_the_node() {
    let slave = wedge(CellKind::Hex8, [2, 2, 2]);
    let count = slave.mesh.nodes_of_faces(&slave.faces).len();
    let values = tresca_contact::ScalarField::Values((0..count).map(|i| i as f64).collect());
    let interface = tresca_contact::Interface {
        gap: &values,
        ..INTERFACE
    };
    let master = notch(CellKind::Hex8, 2);
    let data = couple(
        slave.side(),
        master.side(),
        interface,
        CouplingMethod::Auto,
        None,
    )
    .unwrap();
    let nodes = slave.mesh.nodes_of_faces(&slave.faces);
    for pair in &data.pairs {
        let ordinal = nodes.binary_search(&pair.slave_node).unwrap();
        assert!((pair.gap - ordinal as f64).abs() < 1e-13);
    }
}

#[test]
fn smooth_surfaces_are_one_patch_and_nothing_changes_to_the_bit() {
    for kind in KINDS {
        let master = shell(CellKind::Hex8, [2.001, 2.5], 6, 0.4, 2.001);
        let mut slave = shell(kind, [1.5, 2.0], 4, 0.3, 2.0);
        let without = format!("{:?}", mortar(&slave, &master));
        let cut = patches(&slave.mesh, &slave.faces, SHARP).unwrap();
        assert_eq!(cut, SmoothPatches::one(slave.faces.len()));
        slave.patches = Some(cut);
        assert_eq!(format!("{:?}", mortar(&slave, &master)), without, "{kind}");
        let ball = RigidShape::Sphere {
            center: [0.0; 3],
            radius: 2.1,
            inside: true,
        };
        let obstacle = |body: &Body| {
            format!(
                "{:?}",
                couple_obstacle(body.side(), &ball, INTERFACE, None).unwrap()
            )
        };
        let with = obstacle(&slave);
        slave.patches = None;
        assert_eq!(with, obstacle(&slave), "{kind}");
    }
}

#[test]
fn surfaces_are_cut_where_their_angle_is_sharper() {
    // A tube of 24 flat sides, 15° apart, and its two ends.
    let strip = block(
        CellKind::Hex8,
        [0.0, 1.0, 0.0],
        [23.0 / 24.0, 2.0, 1.0],
        [23, 1, 2],
    );
    let tube = strip
        .mapped(|[t, r, z]| {
            let (s, c) = (std::f64::consts::TAU * t).sin_cos();
            // Against the sense of the angle, which keeps cells right side out.
            [r * s, r * c, z]
        })
        .unwrap();
    let faces = tube.boundary_faces();
    let count = |degrees: f64| {
        patches(&tube, &faces, degrees.to_radians())
            .unwrap()
            .count()
    };
    // Outside, inside, top, bottom and the two cut faces of the open tube.
    assert_eq!(count(20.0), 6);
    assert_eq!(count(10.0), 2 * 23 + 4);
    assert_eq!(count(100.0), 1);
    // In the plane edges are corners.
    let square = rectangle(&RectangleSpec {
        space: Space::Plane,
        min: [0.0; 2],
        max: [1.0; 2],
        nodes: [4, 3],
        cells: CellKind::Quad4,
    })
    .unwrap();
    for kind in [CellKind::Quad4, CellKind::Quad9] {
        let mesh = square.clone().with_cells(kind).unwrap();
        let faces = mesh.boundary_faces();
        let cut = patches(&mesh, &faces, SHARP).unwrap();
        assert_eq!(cut.count(), 4);
        let surface = ContactSurface::in_patches(&mesh, &faces, &cut).unwrap();
        assert_eq!(surface.nodes.len(), surface.node_count() + 4);
        let length: f64 = surface.nodes.iter().map(|node| node.area).sum();
        assert!((length - 4.0).abs() < 1e-13);
    }
    assert_eq!(patches(&tube, &[], SHARP), Err(ContactError::Empty));
    let other = SmoothPatches::one(3);
    let error = ContactSurface::in_patches(&tube, &faces, &other).unwrap_err();
    assert!(
        error.to_string().contains("a surface of 3 faces"),
        "{error}"
    );
}
