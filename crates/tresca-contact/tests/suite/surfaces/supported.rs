//! Slave nodes that supports hold, or that another contact has.

use tresca_contact::{ContactData, RigidShape, couple_obstacle};
use tresca_fem::loads;
use tresca_fem::mesh::CellKind;
use tresca_testkit::largest;

use super::flat::KINDS;
use super::support::{
    Body, INTERFACE, block, boundary_where, mortar, smallest_pivot, transposed_product,
};

fn boxes(kind: CellKind) -> [Body; 2] {
    let on = |[_, _, z]: [f64; 3]| z == 0.0;
    let slave = block(kind, [0.0; 3], [2.0, 1.0, 0.5], [4, 2, 1]);
    let master = block(kind, [-0.2, -0.3, -0.5], [2.3, 1.5, 0.0], [3, 3, 1]);
    [Body::new(slave, on), Body::new(master, on)]
}

/// The multipliers of held nodes are gone, and a constant pressure is still one.
#[test]
fn neighbours_carry_the_share_of_held_nodes() {
    for kind in KINDS {
        let [slave, master] = boxes(kind);
        let [_, own] = [0, 1].map(|_| mortar(&slave, &master).pairs.len());
        let edge = |[x, _, _]: [f64; 3]| x == 0.0;
        let slave = (0..3).fold(slave, |slave, component| slave.held(component, edge));
        let data = mortar(&slave, &master);
        assert!(data.held_pairs > 0 && data.pairs.len() + data.held_pairs == own);
        assert!(data.pairs.iter().all(|pair| pair.point[0] > 0.0));
        let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
        assert!((area - 2.0).abs() < 1e-12);
        let mut lambda = vec![0.0; data.slave_coupling.nrows()];
        for (lambda, pair) in lambda.iter_mut().zip(&data.pairs) {
            *lambda = 7.0 * pair.area;
        }
        let mut forces = transposed_product(&data.slave_coupling, &lambda);
        let load = loads::pressure(&slave.mesh, &slave.faces, 7.0);
        forces.iter_mut().zip(&load).for_each(|(f, p)| *f += p);
        assert!(largest(&forces) < 1e-12, "{kind}: {:e}", largest(&forces));
        assert!(smallest_pivot(&data, &slave, Some(&master)) > 1e-3);
    }
}

/// On a symmetry plane of both bodies the direction across it has no row.
#[test]
fn symmetry_planes_take_a_tangent_away() {
    for kind in KINDS {
        let [slave, master] = boxes(kind);
        let slave = slave.held(0, |[x, _, _]| x == 0.0);
        let master = master.held(0, |[x, _, _]| x == -0.2);
        let data = mortar(&slave, &master);
        assert_eq!(data.held_pairs, 0);
        for pair in &data.pairs {
            assert!(pair.mobility.normal && pair.mobility.tangents[0]);
            assert_eq!(pair.mobility.tangents[1], pair.point[0] > 0.0, "{kind}");
            if pair.point[0] == 0.0 {
                assert!(pair.frame.tangents[0][0].abs() < 1e-14);
            }
        }
        assert!(smallest_pivot(&data, &slave, Some(&master)) > 1e-3);
    }
}

/// A slave that is held as a whole still has rows: the master moves against it.
#[test]
fn a_held_surface_is_an_obstacle() {
    let kind = CellKind::Hex8;
    let hold = |body: Body| (0..3).fold(body, |body, component| body.held(component, |_| true));
    let slave = block(kind, [0.0; 3], [2.0, 1.0, 0.5], [2, 1, 1]);
    let slave = hold(Body::new(slave, |[_, _, z]| z == 0.0));
    let [_, master] = boxes(kind);
    let data = mortar(&slave, &master);
    assert_eq!((data.pairs.len(), data.held_pairs), (6, 0));
    assert!(smallest_pivot(&data, &slave, Some(&master)) > 1e-3);
    // Held along y only: so is the master then, and there is no row along y.
    let [slave, master] = boxes(kind);
    let (slave, master) = (slave.held(1, |_| true), master.held(1, |_| true));
    let data = mortar(&slave, &master);
    assert!(
        data.pairs
            .iter()
            .all(|pair| pair.mobility.tangents == [true, false])
    );
    // With a master that moves along y there is.
    let [_, master] = boxes(kind);
    let data = mortar(&slave, &master);
    assert!(
        data.pairs
            .iter()
            .all(|pair| pair.mobility.tangents == [true, true])
    );
}

/// Two contacts of one body that meet at an edge: the rows of both together are independent, and each
/// transmits its pressure.
#[test]
fn contacts_share_an_edge() {
    for kind in KINDS {
        let mesh = || block(kind, [0.0; 3], [2.0, 1.0, 0.5], [4, 2, 1]);
        // One floor in two parts, and a wall at the end of the floor.
        type On = fn([f64; 3]) -> bool;
        let parts: [(On, [f64; 3]); 3] = [
            (|[x, _, z]| z == 0.0 && x <= 1.0, [0.0, 0.0, 1.0]),
            (|[x, _, z]| z == 0.0 && x >= 1.0, [0.0, 0.0, 1.0]),
            (|[x, _, _]| x == 2.0, [-1.0, 0.0, 0.0]),
        ];
        let mut taken = Vec::new();
        let mut all: Option<(Body, ContactData)> = None;
        for (on, normal) in parts {
            let mut slave = Body::new(mesh(), on);
            slave.taken.clone_from(&taken);
            let point = [2.0, 0.0, 0.0];
            let plane = RigidShape::Plane { point, normal };
            let data = couple_obstacle(slave.side(), &plane, INTERFACE, None).unwrap();
            assert!(data.uncoupled.is_empty());
            let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
            assert!((area - slave.mesh.area(&slave.faces)).abs() < 1e-12);
            assert!(
                data.pairs
                    .iter()
                    .all(|pair| !taken.contains(&pair.slave_node))
            );
            taken.extend(data.pairs.iter().map(|pair| pair.slave_node));
            assert!(smallest_pivot(&data, &slave, None) > 1e-2);
            all = Some((slave, data));
        }
        let nodes = all.map(|(slave, _)| {
            let floor = boundary_where(&slave.mesh, |[x, _, z]| z == 0.0 || x == 2.0);
            slave.mesh.nodes_of_faces(&floor)
        });
        taken.sort_unstable();
        assert_eq!(Some(taken), nodes, "every node has one pair");
    }
}

/// The same to the last bit, whatever the number of threads.
#[test]
fn results_do_not_depend_on_threads() {
    let [slave, master] = boxes(CellKind::Tet10);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| mortar(&slave, &master))
    };
    let (one, three) = (run(1), run(3));
    assert_eq!(one.pairs, three.pairs);
    let values = |data: &ContactData| data.slave_coupling.val().to_vec();
    assert_eq!(values(&one), values(&three));
}
