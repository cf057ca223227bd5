//! Rigid obstacles against closed forms.

use tresca_contact::{
    ContactData, ContactError, Discretization, RigidShape, RigidSurface, couple_obstacle,
};
use tresca_fem::loads;
use tresca_fem::mesh::{CellKind, RectangleSpec, Space, rectangle};
use tresca_testkit::is_near;
use tresca_testkit::largest;

use super::flat::KINDS;
use super::support::{
    Body, INTERFACE, add_product, block, elevated, field, smallest_pivot, transposed_product, turn,
};

fn coupled(slave: &Body, obstacle: &RigidShape) -> Result<ContactData, ContactError> {
    couple_obstacle(slave.side(), obstacle, INTERFACE, None)
}

fn unit_block(kind: CellKind) -> Body {
    let mesh = block(kind, [0.0, 0.0, 0.0], [2.0, 1.0, 1.0], [3, 2, 1]);
    Body::new(mesh, |[_, _, z]| z == 0.0)
}

fn close(a: [f64; 3], b: [f64; 3]) -> bool {
    is_near(&a, &b, 1e-13)
}

/// An inclined plane below a block: distances, normals, areas, and consistent forces.
#[test]
fn planes() {
    for kind in KINDS {
        let mut slave = unit_block(kind);
        slave.mesh = slave.mesh.mapped(turn).unwrap();
        let obstacle = RigidShape::Plane {
            point: turn([5.0, -3.0, -0.05]),
            normal: turn([0.0, 0.0, 4.0]),
        };
        let data = coupled(&slave, &obstacle).unwrap();
        assert_eq!(data.discretization, Discretization::Obstacle);
        assert!(data.master_coupling.is_none() && data.uncoupled.is_empty());
        assert_eq!(
            data.pairs.len(),
            slave.mesh.nodes_of_faces(&slave.faces).len()
        );
        let [least, most] = data.gap_range().unwrap();
        assert!((least - 0.05).abs() < 1e-13 && (most - 0.05).abs() < 1e-13);
        let down = turn([0.0, 0.0, -1.0]);
        assert!(data.pairs.iter().all(|pair| close(pair.frame.normal, down)));
        assert!((data.overlap_area - 2.0).abs() < 1e-13);
        // A translation: its normal part is approach, the rest slip.
        let motion = [0.3, -0.2, 0.5];
        let mut moved = vec![0.0; data.slave_coupling.nrows()];
        add_product(
            &data.slave_coupling,
            &field(&slave.mesh, |_| motion),
            &mut moved,
        );
        let m = data.pairs.len();
        for (i, pair) in data.pairs.iter().enumerate() {
            let along = |d: [f64; 3]| (0..3).map(|k| d[k] * motion[k]).sum::<f64>();
            assert!((moved[i] - along(pair.frame.normal)).abs() < 1e-12);
            for t in 0..2 {
                let expected = along(pair.frame.tangents[t]);
                assert!((moved[m + 2 * i + t] - expected).abs() < 1e-12);
            }
        }
        let mut lambda = vec![0.0; data.slave_coupling.nrows()];
        for (lambda, pair) in lambda.iter_mut().zip(&data.pairs) {
            *lambda = 7.0 * pair.area;
        }
        let mut forces = transposed_product(&data.slave_coupling, &lambda);
        let load = loads::pressure(&slave.mesh, &slave.faces, 7.0);
        forces.iter_mut().zip(&load).for_each(|(f, p)| *f += p);
        assert!(largest(&forces) < 1e-12, "{kind}");
        assert!(smallest_pivot(&data, &slave, None) > 1e-2);
    }
}

/// Nodes of linear faces see the nearest point of a sphere and of a turned cylinder, outside and inside.
#[test]
fn round_obstacles_see_each_node() {
    let slave = unit_block(CellKind::Hex8);
    let center = [0.9, 0.4, -3.1];
    let axis = [1.0, 0.5, -0.1];
    let axis_length = (1.0_f64 + 0.25 + 0.01).sqrt();
    let radius = 3.0;
    let arm = |x: [f64; 3], obstacle: &RigidShape| -> [f64; 3] {
        let offset: [f64; 3] = std::array::from_fn(|k| x[k] - center[k]);
        match obstacle {
            RigidShape::Cylinder { .. } => {
                let t = (0..3).map(|k| offset[k] * axis[k]).sum::<f64>() / axis_length.powi(2);
                std::array::from_fn(|k| offset[k] - t * axis[k])
            }
            _ => offset,
        }
    };
    let sphere = |inside| RigidShape::Sphere {
        center,
        radius,
        inside,
    };
    let cylinder = |inside| RigidShape::Cylinder {
        point: center,
        axis,
        radius,
        inside,
    };
    for obstacle in [sphere(false), cylinder(false)] {
        let data = couple_obstacle(slave.side(), &obstacle, INTERFACE, Some(1.0)).unwrap();
        assert_eq!(data.pairs.len(), 12);
        for pair in &data.pairs {
            let arm = arm(pair.point, &obstacle);
            let length = arm.iter().map(|x| x * x).sum::<f64>().sqrt();
            assert!((pair.gap - (length - radius)).abs() < 1e-13);
            assert!(close(pair.frame.normal, arm.map(|x| -x / length)));
        }
    }
    // A block whose upper face looks at the roof of a cavity.
    let mut slave = unit_block(CellKind::Hex8);
    slave.mesh = slave.mesh.mapped(|[x, y, z]| [x, y, z - 1.2]).unwrap();
    slave.faces = super::support::boundary_where(&slave.mesh, |[_, _, z]| z > -0.3);
    for obstacle in [sphere(true), cylinder(true)] {
        let data = couple_obstacle(slave.side(), &obstacle, INTERFACE, Some(1.0)).unwrap();
        for pair in &data.pairs {
            let arm = arm(pair.point, &obstacle);
            let length = arm.iter().map(|x| x * x).sum::<f64>().sqrt();
            assert!((pair.gap - (radius - length)).abs() < 1e-13);
            assert!(close(pair.frame.normal, arm.map(|x| x / length)));
        }
    }
}

/// Circles and lines in the plane.
#[test]
fn obstacles_in_the_plane() {
    let (min, max, nodes) = ([0.0, 0.0], [2.0, 1.0], [5, 2]);
    let (space, cells) = (Space::Plane, CellKind::Quad4);
    let mesh = rectangle(&RectangleSpec {
        space,
        min,
        max,
        nodes,
        cells,
    })
    .unwrap();
    for kind in [CellKind::Quad4, CellKind::Quad8, CellKind::Quad9] {
        let mesh = if kind == cells {
            mesh.clone()
        } else {
            elevated(&mesh, kind)
        };
        let slave = Body::new(mesh, |[_, y, _]| y == 0.0);
        let normal = [-1.0, 10.0, 7.0];
        let point = [0.0, -0.2, 3.0];
        let data = coupled(&slave, &RigidShape::Plane { point, normal }).unwrap();
        let length = 101f64.sqrt();
        for pair in &data.pairs {
            // A linear gap is exact at the corners; between them it is a mean with the same value.
            let expected = (10.0 * 0.2 - pair.point[0]) / length;
            assert!((pair.gap - expected).abs() < 1e-13, "{kind}");
            assert!(close(
                pair.frame.normal,
                [1.0 / length, -10.0 / length, 0.0]
            ));
        }
        let circle = RigidShape::Cylinder {
            point: [1.0, -5.0, 9.0],
            axis: [0.0, 0.0, -2.0],
            radius: 4.9,
            inside: false,
        };
        let data = coupled(&slave, &circle).unwrap();
        let least = data.gap_range().unwrap()[0];
        assert!((least - 0.1).abs() < 1e-2);
        assert!(smallest_pivot(&data, &slave, None) > 1e-2);
        let tilted = RigidShape::Cylinder {
            point: [0.0; 3],
            axis: [1.0, 0.0, 0.0],
            radius: 1.0,
            inside: false,
        };
        assert!(matches!(
            coupled(&slave, &tilted),
            Err(ContactError::Obstacle { .. })
        ));
    }
}

/// A plane of faces is a plane; its own mesh plays no part.
#[test]
fn rigid_surfaces() {
    for kind in KINDS {
        let slave = unit_block(kind);
        let points = vec![
            [-1.0, -1.0, -0.05],
            [3.0, -1.0, -0.05],
            [3.0, 2.0, -0.05],
            [-1.0, 2.0, -0.05],
            [0.7, 0.4, -0.05],
        ];
        let triangle = |nodes: [usize; 3]| (CellKind::Tri3, nodes.to_vec());
        let faces = vec![
            triangle([0, 1, 4]),
            triangle([1, 2, 4]),
            triangle([2, 3, 4]),
            triangle([3, 0, 4]),
        ];
        let surface = RigidSurface { points, faces };
        let by_faces = coupled(&slave, &RigidShape::Surface(surface.clone())).unwrap();
        let plane = RigidShape::Plane {
            point: [0.0, 0.0, -0.05],
            normal: [0.0, 0.0, 1.0],
        };
        let plane = coupled(&slave, &plane).unwrap();
        assert!(by_faces.master_coupling.is_none());
        assert_eq!(by_faces.pairs.len(), plane.pairs.len());
        for (a, b) in by_faces.pairs.iter().zip(&plane.pairs) {
            assert_eq!(a.slave_node, b.slave_node);
            assert!((a.gap - b.gap).abs() < 1e-12 && (a.area - b.area).abs() < 1e-12);
            assert!(close(a.frame.normal, b.frame.normal));
        }
        let n = by_faces.slave_coupling.nrows();
        let mut difference = vec![0.0; n];
        let u = field(&slave.mesh, |[x, y, _]| [x.sin(), (x + y).cos(), x * y - y]);
        add_product(&by_faces.slave_coupling, &u, &mut difference);
        difference.iter_mut().for_each(|x| *x = -*x);
        add_product(&plane.slave_coupling, &u, &mut difference);
        assert!(
            largest(&difference) < 1e-12,
            "{kind}: {:e}",
            largest(&difference)
        );

        let mut broken = surface.clone();
        broken.faces[1].1[2] = 9;
        let error = coupled(&slave, &RigidShape::Surface(broken)).unwrap_err();
        assert_eq!(error, ContactError::FaceNode { node: 9 });
        let mut flat = surface.clone();
        flat.faces[1].1[2] = 1;
        let error = coupled(&slave, &RigidShape::Surface(flat)).unwrap_err();
        assert!(matches!(error, ContactError::DegenerateFace { .. }));
        let mut arrow = surface.clone();
        arrow.points[2] = [0.5, -0.5, -0.05];
        arrow.faces = vec![(CellKind::Quad4, vec![0, 1, 2, 3])];
        let error = coupled(&slave, &RigidShape::Surface(arrow)).unwrap_err();
        assert!(matches!(error, ContactError::DegenerateFace { .. }));
        let mut solid = surface;
        solid.faces.push((CellKind::Tet4, vec![0, 1, 2, 3]));
        let error = coupled(&slave, &RigidShape::Surface(solid)).unwrap_err();
        assert!(matches!(error, ContactError::FaceKind { .. }));
        let none = RigidSurface {
            points: Vec::new(),
            faces: Vec::new(),
        };
        let error = coupled(&slave, &RigidShape::Surface(none)).unwrap_err();
        assert_eq!(error, ContactError::Empty);
    }
}

/// Held nodes leave their share to their neighbours.
#[test]
fn held_nodes_on_an_obstacle() {
    for kind in KINDS {
        let slave = unit_block(kind).held(2, |[x, _, _]| x == 0.0);
        let plane = RigidShape::Plane {
            point: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
        };
        let data = coupled(&slave, &plane).unwrap();
        assert!(data.held_pairs > 0);
        assert!(data.pairs.iter().all(|pair| pair.point[0] > 0.0));
        let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
        assert!((area - 2.0).abs() < 1e-13);
    }
}

#[test]
fn senseless_obstacles_are_refused() {
    let slave = unit_block(CellKind::Hex8);
    let error = |obstacle: &RigidShape| coupled(&slave, obstacle).unwrap_err();
    let center = [1.0, 0.5, -2.0];
    let plane = |normal| RigidShape::Plane {
        point: [0.0; 3],
        normal,
    };
    for normal in [[0.0; 3], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 0.0]] {
        assert!(matches!(
            error(&plane(normal)),
            ContactError::Obstacle { .. }
        ));
    }
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let sphere = RigidShape::Sphere {
            center,
            radius,
            inside: false,
        };
        assert!(matches!(error(&sphere), ContactError::Obstacle { .. }));
    }
    let axis = [0.0; 3];
    let cylinder = RigidShape::Cylinder {
        point: center,
        axis,
        radius: 1.0,
        inside: true,
    };
    assert!(matches!(error(&cylinder), ContactError::Obstacle { .. }));
    // A ball that nearly swallows the face, one that is far off, one on the wrong side.
    let sphere = |z: f64, radius: f64| RigidShape::Sphere {
        center: [1.0, 0.5, z],
        radius,
        inside: false,
    };
    assert!(matches!(
        error(&sphere(-0.4, 3.0)),
        ContactError::TooDeep { .. }
    ));
    assert_eq!(error(&sphere(-9.0, 1.0)), ContactError::Apart);
    assert_eq!(error(&plane([0.0, 0.0, -1.0])), ContactError::Apart);
    // A node at the centre of a cavity.
    let cavity = RigidShape::Sphere {
        center: [2.0, 1.0, 1e-10],
        radius: 1.0,
        inside: true,
    };
    let far = couple_obstacle(slave.side(), &cavity, INTERFACE, Some(5.0));
    assert!(matches!(far, Err(ContactError::AtCenter { .. })));
    assert_eq!(error(&cavity), ContactError::Apart);
}
