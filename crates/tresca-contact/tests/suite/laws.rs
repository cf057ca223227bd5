//! What friction laws, gaps and supports make of a pair.

use std::sync::Arc;
use tresca_contact::{
    ContactData, ContactError, FrictionLaw, Interface, Mobility, Opening, ScalarField, Side,
    Sliding, couple_node_by_node,
};
use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{BrickSpec, CellKind, Mesh, RectangleSpec, Space, brick, rectangle};
use tresca_fem::supports::Supports;

fn blocks() -> [Mesh; 2] {
    [1.0, 0.0].map(|low| {
        let (min, max) = ([0.0, 0.0, low], [2.0, 1.0, low + 1.0]);
        let nodes = [3; 3];
        brick(&BrickSpec { min, max, nodes }).unwrap()
    })
}

fn couple_held(
    meshes: &[Mesh; 2],
    faces: [&str; 2],
    held: &[(&str, usize)],
    friction: FrictionLaw,
    gap: ScalarField,
) -> Result<ContactData, ContactError> {
    let dofs = meshes.each_ref().map(|mesh| {
        let mut supports = Supports::new(mesh.node_count(), mesh.dimension());
        for (set, component) in held {
            let nodes = mesh.nodes_of_set(set).unwrap();
            supports.hold(&nodes, *component).unwrap();
        }
        DofMap::new(&supports)
    });
    let side = |k: usize| Side {
        mesh: &meshes[k],
        faces: meshes[k].faces_of_set(faces[k]).unwrap(),
        dofs: &dofs[k],
        patches: None,
        taken: &[],
    };
    let interface = Interface {
        friction: &friction,
        gap: &gap,
    };
    couple_node_by_node(side(0), side(1), interface)
}

fn couple(friction: FrictionLaw, gap: ScalarField) -> Result<ContactData, ContactError> {
    couple_held(&blocks(), ["z-", "z+"], &[], friction, gap)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-13
}

#[test]
fn bounds_and_gaps_by_function_and_by_values() {
    let function = ScalarField::Function(Arc::new(|[x, _, _]| 0.1 * (1.0 + x)));
    let data = couple(
        FrictionLaw::Tresca { bound: function },
        ScalarField::Function(Arc::new(|[x, y, _]| 0.01 * x * y - 0.002)),
    )
    .unwrap();
    for pair in &data.pairs {
        let [x, y, _] = pair.point;
        let bound = 0.1 * (1.0 + x) * pair.area;
        assert!(matches!(pair.sliding, Sliding::Bounded([a, b]) if close(a, bound) && a == b));
        assert!(close(pair.gap, 0.01 * x * y - 0.002));
    }
    let values = ScalarField::Values((0..9).map(f64::from).collect());
    let data = couple(FrictionLaw::Tresca { bound: values }, 0.0.into()).unwrap();
    for (k, pair) in data.pairs.iter().enumerate() {
        let bound = k as f64 * pair.area;
        assert!(matches!(pair.sliding, Sliding::Bounded([a, _]) if close(a, bound)));
    }
}

#[test]
fn impossible_figures_are_named() {
    let refused = |law, gap| couple(law, gap).unwrap_err().to_string();
    let negative = ScalarField::Function(Arc::new(|[x, _, _]| 1.0 - x));
    let message = refused(FrictionLaw::Tresca { bound: negative }, 0.0.into());
    assert!(message.contains("found -1 at (2, "), "{message}");
    let infinite = ScalarField::Function(Arc::new(|[x, _, _]| x.recip()));
    let message = refused(FrictionLaw::Frictionless, infinite);
    assert!(
        message.contains("gap") && message.contains("inf"),
        "{message}"
    );
    let few = FrictionLaw::tresca(ScalarField::Values(vec![1.0; 4]));
    assert_eq!(
        couple(few, 0.0.into()).unwrap_err(),
        ContactError::ValueCount {
            expected: 9,
            found: 4
        }
    );
    let along_normal = FrictionLaw::Orthotropic {
        bounds: [1.0.into(), 2.0.into()],
        axis: [0.0, 0.0, 1.0],
    };
    let message = refused(along_normal, 0.0.into());
    assert!(
        message.contains("no direction in the tangent plane"),
        "{message}"
    );
    for law in [
        FrictionLaw::coulomb(-0.1),
        FrictionLaw::coulomb(f64::NAN),
        FrictionLaw::tresca(f64::INFINITY),
        FrictionLaw::Orthotropic {
            bounds: [1.0.into(), 1.0.into()],
            axis: [0.0; 3],
        },
    ] {
        assert!(law.validate().is_err(), "{law:?}");
    }
}

#[test]
fn an_orthotropic_law_turns_the_frame_to_its_axis() {
    let law = FrictionLaw::Orthotropic {
        bounds: [0.2.into(), 0.1.into()],
        axis: [3.0, 4.0, 17.0],
    };
    let data = couple(law, 0.0.into()).unwrap();
    for pair in &data.pairs {
        let [t1, t2] = pair.frame.tangents;
        assert!(close(t1[0], 0.6) && close(t1[1], 0.8) && close(t1[2], 0.0));
        assert!(close(t1[0] * t2[0] + t1[1] * t2[1], 0.0));
        assert!(matches!(pair.sliding,
            Sliding::Bounded([a, b]) if close(a, 0.2 * pair.area) && close(b, 0.1 * pair.area)));
    }
}

/// On a symmetry plane slip is possible along one line only, and the bound is where that line leaves
/// the ellipse.
#[test]
fn symmetry_planes_cut_the_ellipse() {
    let (g1, g2) = (0.2, 0.1);
    let law = FrictionLaw::Orthotropic {
        bounds: [g1.into(), g2.into()],
        axis: [1.0, 1.0, 0.0],
    };
    let meshes = blocks();
    let data = couple_held(&meshes, ["z-", "z+"], &[("y-", 1)], law, 0.0.into()).unwrap();
    assert_eq!((data.pairs.len(), data.held_pairs), (9, 0));
    let radius = (0.5 / (g1 * g1) + 0.5 / (g2 * g2)).sqrt().recip();
    let mut on_plane = 0;
    for pair in &data.pairs {
        if pair.point[1] > 0.0 {
            assert_eq!(pair.mobility, Mobility::FULL);
            continue;
        }
        on_plane += 1;
        assert_eq!(pair.mobility.tangents, [true, false]);
        assert!(close(pair.frame.tangents[0][0].abs(), 1.0));
        assert!(matches!(pair.sliding, Sliding::Bounded([a, _]) if close(a, radius * pair.area)));
    }
    assert_eq!(on_plane, 3);

    let coulomb = FrictionLaw::Coulomb {
        coefficients: [0.4, 0.0],
        axis: Some([0.0, 1.0, 0.0]),
        limit: Some(3.0.into()),
    };
    let data = couple_held(&meshes, ["z-", "z+"], &[("y-", 1)], coulomb, 0.0.into()).unwrap();
    for pair in data.pairs.iter().filter(|pair| pair.point[1] == 0.0) {
        // Along x this law does not resist at all.
        assert_eq!(pair.sliding.bounds(10.0), Some([0.0, 0.0]));
    }
}

#[test]
fn coulomb_bounds_follow_the_normal_force_up_to_their_limit() {
    let law = FrictionLaw::Coulomb {
        coefficients: [0.5, 0.25],
        axis: Some([1.0, 0.0, 0.0]),
        limit: Some(2.0.into()),
    };
    assert!(law.is_coulomb() && law.opening() == Opening::Unilateral);
    let data = couple(law, 0.0.into()).unwrap();
    let pair = &data.pairs[0];
    let area = pair.area;
    assert_eq!(pair.sliding.bounds(-1.0), Some([0.0, 0.0]));
    let bounds = pair.sliding.bounds(2.0 * area).unwrap();
    assert!(close(bounds[0], area) && close(bounds[1], 0.5 * area));
    let bounds = pair.sliding.bounds(100.0 * area).unwrap();
    assert!(close(bounds[0], 2.0 * area) && close(bounds[1], area));
    assert_eq!(FrictionLaw::Tied.opening(), Opening::Never);
    let data = couple(FrictionLaw::Tied, 0.0.into()).unwrap();
    assert!(
        data.pairs
            .iter()
            .all(|pair| pair.sliding.bounds(1.0).is_none())
    );
}

/// In the plane a pair has two rows: the normal and the one tangent in the plane.
#[test]
fn plane_contacts_have_two_rows_per_pair() {
    let meshes = [1.0, 0.0].map(|low| {
        rectangle(&RectangleSpec {
            space: Space::Plane,
            min: [0.0, low],
            max: [3.0, low + 1.0],
            nodes: [4, 2],
            cells: CellKind::Quad4,
        })
        .unwrap()
    });
    let law = FrictionLaw::tresca(0.5);
    let data = couple_held(&meshes, ["y-", "y+"], &[], law, 0.0.into()).unwrap();
    assert_eq!(data.pairs.len(), 4);
    assert_eq!(
        (data.slave_coupling.nrows(), data.slave_coupling.ncols()),
        (8, 16)
    );
    for (i, pair) in data.pairs.iter().enumerate() {
        assert!(close(pair.frame.normal[1], -1.0) && close(pair.frame.tangents[0][0], 1.0));
        assert_eq!(pair.mobility.tangents, [true, false]);
        let row = |row: usize| -> Vec<(usize, f64)> {
            let matrix = data.slave_coupling.as_ref();
            let values = matrix.val_of_row(row).iter().copied();
            matrix.col_idx_of_row(row).zip(values).collect()
        };
        assert_eq!(row(i), [(2 * pair.slave_node + 1, -1.0)]);
        assert_eq!(row(4 + i), [(2 * pair.slave_node, 1.0)]);
    }
    let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
    assert!(close(area, 3.0), "per thickness");
}

#[test]
fn every_law_has_its_name_and_number() {
    let bound = || ScalarField::Constant(1.0);
    let laws = [
        FrictionLaw::Frictionless,
        FrictionLaw::tresca(1.0),
        FrictionLaw::Orthotropic {
            bounds: [bound(), bound()],
            axis: [1.0, 0.0, 0.0],
        },
        FrictionLaw::coulomb(0.3),
        FrictionLaw::Tied,
        FrictionLaw::Bilateral { bound: None },
    ];
    let names = [
        "frictionless",
        "tresca",
        "orthotropic",
        "coulomb",
        "tied",
        "bilateral",
    ];
    assert_eq!(FrictionLaw::NAMES, names);
    for (number, law) in laws.iter().enumerate() {
        assert_eq!(usize::from(law.number()), number);
        assert_eq!(law.name(), names[number]);
    }
}
