//! Flat interfaces: everything is exact.

use tresca_contact::{ContactError, CouplingMethod, Discretization, couple, couple_node_by_node};
use tresca_fem::loads;
use tresca_fem::mesh::CellKind;
use tresca_fem::vector3::cross;
use tresca_testkit::largest;

use super::support::{
    Body, INTERFACE, add_product, block, elevated, mortar, relative, smallest_pivot,
    transposed_product, turn,
};

pub const KINDS: [CellKind; 6] = [
    CellKind::Hex8,
    CellKind::Wedge6,
    CellKind::Tet4,
    CellKind::Hex20,
    CellKind::Hex27,
    CellKind::Tet10,
];

/// Two boxes on one another, the interface z = 0 turned in space. The slave covers (0, 2) × (0, 1), the
/// master a rectangle of its own.
fn boxes(kinds: [CellKind; 2], cells: [[usize; 2]; 2], low: [f64; 2], high: [f64; 2]) -> [Body; 2] {
    let body = |k: usize, min: [f64; 3], max: [f64; 3]| {
        let [nx, ny] = cells[k];
        let mesh = block(kinds[k], min, max, [nx, ny, 1]);
        let mut body = Body::new(mesh, |[_, _, z]| z == 0.0);
        body.mesh = body.mesh.mapped(turn).unwrap();
        body
    };
    [
        body(0, [0.0, 0.0, 0.0], [2.0, 1.0, 0.5]),
        body(1, [low[0], low[1], -0.5], [high[0], high[1], 0.0]),
    ]
}

fn pairs_of_kinds() -> impl Iterator<Item = [CellKind; 2]> {
    KINDS.into_iter().flat_map(|a| KINDS.map(|b| [a, b]))
}

#[test]
fn rigid_motions_of_both_bodies_are_neither_approach_nor_slip() {
    for kinds in pairs_of_kinds() {
        for (low, high) in [([0.0, 0.0], [2.0, 1.0]), ([0.7, -0.3], [2.6, 0.45])] {
            let [slave, master] = boxes(kinds, [[3, 2], [4, 3]], low, high);
            let data = mortar(&slave, &master);
            assert_eq!(data.discretization, Discretization::Mortar);
            let overlap = (high[0].min(2.0) - low[0]) * (high[1] - low[1].max(0.0));
            let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
            assert!((area - overlap).abs() < 1e-12, "{kinds:?}: {area}");
            assert!((data.overlap_area - overlap).abs() < 1e-12);
            assert!(data.pairs.iter().all(|pair| pair.area > 0.0));
            let [least, most] = data.gap_range().unwrap();
            assert!(
                least > -1e-12 && most < 1e-12,
                "{kinds:?}: {least:e} {most:e}"
            );
            let motion = |x: [f64; 3]| {
                let w = cross([0.3, -0.5, 0.2], x);
                [1.0 + w[0], w[1] - 2.0, 0.5 + w[2]]
            };
            let moved = relative(&data, &slave, &master, [&motion, &motion]);
            assert!(largest(&moved) < 2e-12, "{kinds:?}: {:e}", largest(&moved));
            // An approach of 1 is one.
            let normal = turn([0.0, 0.0, -1.0]);
            let zero = |_: [f64; 3]| [0.0; 3];
            let approach = relative(&data, &slave, &master, [&|_| normal, &zero]);
            let m = data.pairs.len();
            assert!(approach[..m].iter().all(|x| (x - 1.0).abs() < 1e-12));
            assert!(largest(&approach[m..]) < 1e-12);
        }
    }
}

/// Forces of any multipliers cancel, and so do their moments.
#[test]
fn forces_and_moments_balance() {
    for kinds in pairs_of_kinds() {
        let [slave, master] = boxes(kinds, [[3, 2], [2, 5]], [0.4, 0.1], [2.2, 1.3]);
        let data = mortar(&slave, &master);
        let lambda: Vec<f64> = (0..data.slave_coupling.nrows())
            .map(|i| (1.0 + i as f64 * 12.9898).sin())
            .collect();
        let sums = [
            (&slave, Some(&data.slave_coupling)),
            (&master, data.master_coupling.as_ref()),
        ]
        .map(|(body, coupling)| {
            let forces = transposed_product(coupling.unwrap(), &lambda);
            loads::resultant(&body.mesh, &forces, [0.1, 0.2, 0.3])
        });
        let scale = largest(&sums[0].force) + largest(&sums[0].moment);
        for k in 0..3 {
            assert!((sums[0].force[k] + sums[1].force[k]).abs() < 1e-12 * scale);
            assert!((sums[0].moment[k] + sums[1].moment[k]).abs() < 1e-12 * scale);
        }
    }
}

/// Multipliers of one pressure are the consistent loads of that pressure on both sides: what the
/// contact patch test needs.
#[test]
fn a_constant_pressure_is_consistent_on_both_sides() {
    for kinds in pairs_of_kinds() {
        // The slave inside of the master, and the master inside of the slave.
        for (low, high) in [([-0.3, -0.2], [2.1, 1.7]), ([0.3, 0.2], [1.9, 0.8])] {
            let [slave, master] = boxes(kinds, [[4, 3], [3, 2]], low, high);
            let data = mortar(&slave, &master);
            let mut lambda = vec![0.0; data.slave_coupling.nrows()];
            for (lambda, pair) in lambda.iter_mut().zip(&data.pairs) {
                *lambda = 7.0 * pair.area;
            }
            let covered = if low[0] < 0.0 {
                (&slave, &data.slave_coupling)
            } else {
                (&master, data.master_coupling.as_ref().unwrap())
            };
            let mut forces = transposed_product(covered.1, &lambda);
            let load = loads::pressure(&covered.0.mesh, &covered.0.faces, 7.0);
            forces.iter_mut().zip(&load).for_each(|(f, p)| *f += p);
            assert!(
                largest(&forces) < 1e-12,
                "{kinds:?}: {:e}",
                largest(&forces)
            );
        }
    }
}

/// A linear field of the master, and a slave that follows it, have no gap between them.
#[test]
fn linear_displacements_meet() {
    for kinds in pairs_of_kinds() {
        let [slave, master] = boxes(kinds, [[3, 4], [5, 2]], [-0.1, 0.35], [1.1, 1.2]);
        let data = mortar(&slave, &master);
        let u = |[x, y, z]: [f64; 3]| [x - 2.0 * y + z, 0.5 * z - x, 3.0 * y + 0.1 * x];
        let moved = relative(&data, &slave, &master, [&u, &u]);
        assert!(largest(&moved) < 5e-12, "{kinds:?}: {:e}", largest(&moved));
    }
}

#[test]
fn on_matching_meshes_both_couplings_are_one() {
    for kind in [CellKind::Hex8, CellKind::Wedge6, CellKind::Tet4] {
        let [slave, master] = boxes([kind; 2], [[3, 2]; 2], [0.0, 0.0], [2.0, 1.0]);
        let mortar = mortar(&slave, &master);
        let nodes = couple_node_by_node(slave.side(), master.side(), INTERFACE).unwrap();
        assert_eq!(mortar.pairs.len(), nodes.pairs.len());
        for (a, b) in mortar.pairs.iter().zip(&nodes.pairs) {
            assert_eq!(a.slave_node, b.slave_node);
            assert!((a.area - b.area).abs() < 1e-14 && (a.gap - b.gap).abs() < 1e-14);
        }
        // The same matrices, entry by entry, on vectors that tell all entries apart.
        let u = |n: usize| {
            (0..n)
                .map(|i| (1.0 + 7.3 * i as f64).sin())
                .collect::<Vec<_>>()
        };
        for (a, b) in [
            (Some(&mortar.slave_coupling), Some(&nodes.slave_coupling)),
            (
                mortar.master_coupling.as_ref(),
                nodes.master_coupling.as_ref(),
            ),
        ] {
            let (a, b) = (a.unwrap(), b.unwrap());
            let mut y = vec![0.0; a.nrows()];
            add_product(a, &u(a.ncols()), &mut y);
            y.iter_mut().for_each(|y| *y = -*y);
            add_product(b, &u(b.ncols()), &mut y);
            assert!(largest(&y) < 1e-13, "{kind}: {:e}", largest(&y));
        }
        // Auto sees that the nodes match.
        let auto = CouplingMethod::Auto;
        let data = couple(slave.side(), master.side(), INTERFACE, auto, None).unwrap();
        assert_eq!(data.discretization, Discretization::NodeByNode);
    }
}

#[test]
fn auto_takes_mortar_where_nodes_or_elements_do_not_match() {
    let auto = |slave: &Body, master: &Body| {
        let auto = CouplingMethod::Auto;
        let data = couple(slave.side(), master.side(), INTERFACE, auto, None);
        data.unwrap().discretization
    };
    let [a, b] = boxes([CellKind::Hex8; 2], [[3, 2], [3, 3]], [0.0; 2], [2.0, 1.0]);
    assert_eq!(auto(&a, &b), Discretization::Mortar);
    let [a, b] = boxes([CellKind::Hex20; 2], [[3, 2]; 2], [0.0; 2], [2.0, 1.0]);
    assert_eq!(auto(&a, &b), Discretization::Mortar);
    let by_node = couple_node_by_node(a.side(), b.side(), INTERFACE);
    let kind = CellKind::Quad8;
    assert_eq!(by_node.unwrap_err(), ContactError::QuadraticFaces { kind });
}

/// Coarse over fine, fine over coarse, and a master that covers a corner, an edge, or a spot in the
/// middle of a slave face: the rows of B are independent.
#[test]
fn rows_are_independent() {
    let places: [([f64; 2], [f64; 2]); 6] = [
        ([0.0, 0.0], [2.0, 1.0]),
        ([-0.5, -0.5], [2.5, 1.5]),
        ([1.7, 0.8], [2.5, 1.5]),
        ([0.21, 0.1], [0.24, 0.13]),
        ([1.001, -1.0], [3.0, 2.0]),
        ([0.999, 0.499], [1.001, 0.501]),
    ];
    let partners = [CellKind::Wedge6, CellKind::Hex27];
    for kinds in KINDS.into_iter().flat_map(|a| partners.map(|b| [a, b])) {
        for cells in [[[2, 1], [5, 3]], [[5, 3], [2, 1]], [[3, 2], [3, 2]]] {
            for (low, high) in places {
                let [slave, master] = boxes(kinds, cells, low, high);
                let data = mortar(&slave, &master);
                let pivot = smallest_pivot(&data, &slave, Some(&master));
                assert!(pivot > 1e-3, "{kinds:?} {cells:?} {low:?}: {pivot:e}");
                let nodes = slave.mesh.nodes_of_faces(&slave.faces).len();
                assert_eq!(data.pairs.len() + data.uncoupled.len(), nodes);
                // Whatever is covered is transmitted.
                let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
                let size = |k: usize| high[k].min([2.0, 1.0][k]) - low[k].max(0.0);
                assert!(
                    (area / (size(0) * size(1)) - 1.0).abs() < 1e-9,
                    "{low:?}: {area:e}"
                );
            }
        }
    }
}

#[test]
fn surfaces_that_do_not_see_each_other_are_told() {
    let apart = |offset: [f64; 3], search| {
        let kinds = [CellKind::Hex8; 2];
        let [slave, mut master] = boxes(kinds, [[2, 2]; 2], [0.0; 2], [2.0, 1.0]);
        master.mesh = master
            .mesh
            .mapped(|x| std::array::from_fn(|k| x[k] + turn(offset)[k]))
            .unwrap();
        let method = CouplingMethod::Mortar;
        couple(slave.side(), master.side(), INTERFACE, method, search)
    };
    let gap = apart([0.0, 0.0, -0.3], None).unwrap().gap_range().unwrap();
    assert!((gap[0] - 0.3).abs() < 1e-12 && (gap[1] - 0.3).abs() < 1e-12);
    let gap = apart([0.0, 0.0, 0.3], None).unwrap().gap_range().unwrap();
    assert!((gap[0] + 0.3).abs() < 1e-12 && (gap[1] + 0.3).abs() < 1e-12);
    assert_eq!(
        apart([0.0, 0.0, -0.3], Some(0.2)).unwrap_err(),
        ContactError::Apart
    );
    assert_eq!(
        apart([3.0, 0.0, 0.0], None).unwrap_err(),
        ContactError::Apart
    );
    let far = apart([0.0, 0.0, -30.0], None);
    assert_eq!(far.unwrap_err(), ContactError::Apart);
    assert!(apart([0.0, 0.0, -30.0], Some(f64::INFINITY)).is_ok());
    for search in [0.0, -1.0, f64::NAN] {
        let error = apart([0.0; 3], Some(search)).unwrap_err();
        assert!(matches!(error, ContactError::Search { .. }));
    }
}

/// Faces that are flat and straight, but no parallelograms: their shape functions are no polynomials on the
/// face, and quadrature leaves what its degree cannot.
#[test]
fn distorted_flat_faces() {
    distorted(1.0);
    distorted(0.07);
}

fn distorted(amplitude: f64) {
    let bend = |[x, y, z]: [f64; 3]| {
        let [u, v] = [x * (2.0 - x), y * (1.0 - y)].map(|bubble| amplitude * bubble);
        [
            x + 0.15 * u * (2.5 * y).sin(),
            y + 0.25 * v * (2.0 * x).cos(),
            z,
        ]
    };
    let back = |x: [f64; 3]| {
        let [x, y, z] = bend([2.0 - x[0], 1.0 - x[1], x[2]]);
        [2.0 - x, 1.0 - y, z]
    };
    let body = |kind: CellKind, low: f64, cells: [usize; 3], map: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let linear = match kind {
            CellKind::Hex20 | CellKind::Hex27 => CellKind::Hex8,
            CellKind::Tet10 => CellKind::Tet4,
            other => other,
        };
        let mesh = block(linear, [0.0, 0.0, low], [2.0, 1.0, low + 0.5], cells);
        let mesh = mesh.mapped(map).unwrap();
        let mesh = if kind == linear {
            mesh
        } else {
            elevated(&mesh, kind)
        };
        Body::new(mesh, |[_, _, z]| z == 0.0)
    };
    for kinds in pairs_of_kinds() {
        let slave = body(kinds[0], 0.0, [4, 3, 1], &bend);
        let master = body(kinds[1], -0.5, [3, 4, 1], &back);
        let data = mortar(&slave, &master);
        assert!((data.overlap_area - 2.0).abs() < 1e-12);
        let mut lambda = vec![0.0; data.slave_coupling.nrows()];
        for (lambda, pair) in lambda.iter_mut().zip(&data.pairs) {
            *lambda = pair.area;
        }
        let error = |body: &Body, coupling| {
            let mut forces = transposed_product(coupling, &lambda);
            let load = loads::pressure(&body.mesh, &body.faces, 1.0);
            forces.iter_mut().zip(&load).for_each(|(f, p)| *f += p);
            largest(&forces) / largest(&load)
        };
        let errors = [
            error(&slave, &data.slave_coupling),
            error(&master, data.master_coupling.as_ref().unwrap()),
        ];
        println!(
            "{amplitude} {kinds:?}: {:.1e}, {:.1e}",
            errors[0], errors[1]
        );
        assert!(largest(&errors) < 1e-10, "{kinds:?}: {errors:?}");
        let u = |[x, y, z]: [f64; 3]| [x - 2.0 * y + z, 0.5 * z - x, 3.0 * y + 0.1 * x];
        let moved = relative(&data, &slave, &master, [&u, &u]);
        assert!(largest(&moved) < 1e-11, "{kinds:?}: {:e}", largest(&moved));
    }
}
