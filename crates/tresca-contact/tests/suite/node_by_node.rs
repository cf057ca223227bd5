//! Node-by-node coupling: B, gaps, areas and slip bounds against what geometry demands.

use faer::sparse::SparseRowMat;
use tresca_contact::{
    ContactData, ContactError, FrictionLaw, Interface, ScalarField, Side, Sliding,
    couple_node_by_node,
};
use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{BrickSpec, Mesh, brick};
use tresca_fem::supports::Supports;

const LAW: FrictionLaw = FrictionLaw::Tresca {
    bound: ScalarField::Constant(0.5),
};
const INTERFACE: Interface<'static> = Interface {
    friction: &LAW,
    gap: &ScalarField::Constant(0.0),
};

fn block(min: [f64; 3], max: [f64; 3], nodes: [usize; 3]) -> Mesh {
    brick(&BrickSpec { min, max, nodes }).unwrap()
}

fn free(mesh: &Mesh) -> DofMap {
    DofMap::unsupported(mesh.node_count(), 3)
}

fn clamped(mesh: &Mesh, set: &str) -> DofMap {
    let mut supports = Supports::new(mesh.node_count(), 3);
    supports.clamp(&mesh.nodes_of_set(set).unwrap()).unwrap();
    DofMap::new(&supports)
}

fn couple(
    slave: (&Mesh, &str, &DofMap),
    master: (&Mesh, &str, &DofMap),
) -> Result<ContactData, ContactError> {
    let side = |(mesh, set, dofs)| {
        let mesh: &Mesh = mesh;
        Side {
            mesh,
            faces: mesh.faces_of_set(set).unwrap(),
            dofs,
            patches: None,
            taken: &[],
        }
    };
    couple_node_by_node(side(slave), side(master), INTERFACE)
}

/// y ← y + B u, with the rows in the order [N; T].
fn add_product(matrix: &SparseRowMat<usize, f64>, u: &[f64], y: &mut [f64]) {
    let matrix = matrix.as_ref();
    for (row, y) in y.iter_mut().enumerate() {
        for (column, value) in matrix.col_idx_of_row(row).zip(matrix.val_of_row(row)) {
            *y += value * u[column];
        }
    }
}

fn field(mesh: &Mesh, u: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<f64> {
    mesh.points.iter().flat_map(|&point| u(point)).collect()
}

#[test]
fn common_motions_cost_nothing_and_approach_is_positive() {
    // An inclined interface: both blocks turned by the same rotation.
    let (sin, cos) = 0.4_f64.sin_cos();
    let turn = |mesh: &mut Mesh| {
        for point in &mut mesh.points {
            let [x, y, z] = *point;
            *point = [cos * x + sin * z, y, cos * z - sin * x];
        }
    };
    let mut upper = block([0.0, 0.0, 1.0], [2.0, 1.0, 2.0], [4, 5, 3]);
    let mut lower = block([0.0, 0.0, 0.0], [2.0, 1.0, 1.0], [4, 5, 2]);
    turn(&mut upper);
    turn(&mut lower);
    let dofs = [free(&upper), free(&lower)];
    let data = couple((&upper, "z-", &dofs[0]), (&lower, "z+", &dofs[1])).unwrap();
    let m = data.pairs.len();
    assert_eq!(m, 20);

    let relative = |u_upper: [f64; 3], u_lower: [f64; 3]| {
        let mut relative = vec![0.0; 3 * m];
        add_product(
            &data.slave_coupling,
            &field(&upper, |_| u_upper),
            &mut relative,
        );
        add_product(
            data.master_coupling.as_ref().unwrap(),
            &field(&lower, |_| u_lower),
            &mut relative,
        );
        relative
    };
    let common = relative([1.0, -2.0, 3.0], [1.0, -2.0, 3.0]);
    assert!(common.iter().all(|x| x.abs() < 1e-14));

    // The upper block pushed along its outward normal, into the lower one, approaches by that much.
    let down = [-sin, 0.0, -cos];
    let approach = relative(down.map(|x| 0.25 * x), [0.0; 3]);
    for i in 0..m {
        assert!((approach[i] - 0.25).abs() < 1e-14, "N u > 0 is approach");
        assert!(approach[m + 2 * i].abs() < 1e-14 && approach[m + 2 * i + 1].abs() < 1e-14);
    }
    // A motion of the slave in the plane is slip, of the same length, and no approach.
    let slip = relative([0.3 * cos, 0.4, -0.3 * sin], [0.0; 3]);
    for i in 0..m {
        let [a, b] = [slip[m + 2 * i], slip[m + 2 * i + 1]];
        assert!(slip[i].abs() < 1e-14 && (a.hypot(b) - 0.5).abs() < 1e-14);
    }
    // Areas add up to the face, slip bounds to bound × area.
    let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
    let bound = |sliding: Sliding| match sliding {
        Sliding::Bounded([a, b]) if a == b => a,
        other => panic!("{other:?}"),
    };
    let bounds: f64 = data.pairs.iter().map(|pair| bound(pair.sliding)).sum();
    assert!((area - 2.0).abs() < 1e-13 && (bounds - 1.0).abs() < 1e-13);
    assert!(data.pairs.iter().all(|pair| pair.gap.abs() < 1e-14));
}

#[test]
fn pairing_does_not_depend_on_the_order_of_nodes() {
    let upper = block([0.0, 0.0, 1.0], [2.0, 1.0, 2.0], [6, 4, 2]);
    let mut lower = block([0.0, 0.0, 0.0], [2.0, 1.0, 1.0], [6, 4, 2]);
    // Mirror the lower block in x, which reverses its rows of nodes.
    for point in &mut lower.points {
        point[0] = 2.0 - point[0];
    }
    let dofs = [free(&upper), free(&lower)];
    let data = couple((&upper, "z-", &dofs[0]), (&lower, "z+", &dofs[1])).unwrap();
    assert_eq!(data.pairs.len(), 24);
    for pair in &data.pairs {
        let (a, b) = (
            upper.points[pair.slave_node],
            lower.points[pair.master_node.unwrap()],
        );
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-12));
    }
}

#[test]
fn held_pairs_have_no_row() {
    let upper = block([0.0, 0.0, 1.0], [2.0, 1.0, 2.0], [3, 3, 3]);
    let lower = block([0.0, 0.0, 0.0], [2.0, 1.0, 1.0], [3, 3, 3]);
    let opposite = [clamped(&upper, "x+"), clamped(&lower, "x-")];
    let data = couple((&upper, "z-", &opposite[0]), (&lower, "z+", &opposite[1])).unwrap();
    assert_eq!((data.pairs.len(), data.held_pairs), (9, 0));
    assert_eq!(data.slave_coupling.ncols(), opposite[0].full_len());
    // One entry for each of three directions.
    assert_eq!(data.slave_coupling.compute_nnz(), 27);

    let same_end = [clamped(&upper, "x+"), clamped(&lower, "x+")];
    let data = couple((&upper, "z-", &same_end[0]), (&lower, "z+", &same_end[1])).unwrap();
    assert_eq!((data.pairs.len(), data.held_pairs), (6, 3));
}

#[test]
fn surfaces_that_do_not_match_are_told_apart() {
    let upper = block([0.0, 0.0, 1.0], [2.0, 1.0, 2.0], [3, 3, 2]);
    let dofs = free(&upper);
    let refused = |lower: &Mesh, set: &str| {
        let lower_dofs = free(lower);
        couple((&upper, "z-", &dofs), (lower, set, &lower_dofs)).unwrap_err()
    };
    let finer = block([0.0; 3], [2.0, 1.0, 1.0], [4, 3, 2]);
    assert_eq!(
        refused(&finer, "z+"),
        ContactError::NodeCounts {
            slave: 9,
            master: 12
        }
    );
    let shifted = block([0.1, 0.0, 0.0], [2.1, 1.0, 1.0], [3, 3, 2]);
    match refused(&shifted, "z+") {
        ContactError::NoPartner { distance, .. } => assert!((distance - 0.1).abs() < 1e-12),
        other => panic!("{other}"),
    }
    let bad = couple_node_by_node(
        Side {
            mesh: &upper,
            faces: &[],
            dofs: &dofs,
            patches: None,
            taken: &[],
        },
        Side {
            mesh: &upper,
            faces: &[],
            dofs: &dofs,
            patches: None,
            taken: &[],
        },
        INTERFACE,
    );
    assert_eq!(bad.unwrap_err(), ContactError::Empty);
    for bound in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(FrictionLaw::tresca(bound).validate().is_err());
    }
}
