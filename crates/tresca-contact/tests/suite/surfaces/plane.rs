//! Lines in the plane and in the meridian section of a body of revolution.

use std::f64::consts::PI;
use tresca_testkit::largest;

use tresca_fem::loads;
use tresca_fem::mesh::{CellKind, RectangleSpec, Space, rectangle};

use super::support::{Body, elevated, mortar, relative, smallest_pivot, transposed_product};

pub const KINDS: [CellKind; 5] = [
    CellKind::Quad4,
    CellKind::Tri3,
    CellKind::Tri6,
    CellKind::Quad8,
    CellKind::Quad9,
];

fn strip(space: Space, kind: CellKind, x: [f64; 2], y: [f64; 2], cells: usize) -> Body {
    let linear = match kind {
        CellKind::Tri3 | CellKind::Tri6 => CellKind::Tri3,
        _ => CellKind::Quad4,
    };
    let mesh = rectangle(&RectangleSpec {
        space,
        min: [x[0], y[0]],
        max: [x[1], y[1]],
        nodes: [cells + 1, 2],
        cells: linear,
    })
    .unwrap();
    let mesh = if kind == linear {
        mesh
    } else {
        elevated(&mesh, kind)
    };
    Body::new(mesh, |[_, y, _]| y == 0.0)
}

#[test]
fn flat_lines_are_exact() {
    for space in [Space::Plane, Space::Axisymmetric] {
        for (a, b) in KINDS.into_iter().flat_map(|a| KINDS.map(|b| (a, b))) {
            for ends in [[0.0, 3.0], [0.35, 4.0], [1.2, 1.3]] {
                let slave = strip(space, a, [0.0, 3.0], [0.0, 1.0], 4);
                let master = strip(space, b, ends, [-1.0, 0.0], 7);
                let data = mortar(&slave, &master);
                let high = ends[1].min(3.0);
                let overlap = match space {
                    Space::Axisymmetric => PI * (high * high - ends[0] * ends[0]),
                    _ => high - ends[0],
                };
                let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
                assert!(
                    (area / overlap - 1.0).abs() < 1e-12,
                    "{a} {b} {ends:?}: {area}"
                );
                assert!(data.pairs.iter().all(|pair| pair.area > 0.0));
                let u = |[x, y, _]: [f64; 3]| [0.3 + x - 2.0 * y, 0.4 * x - 1.0, 0.0];
                let moved = relative(&data, &slave, &master, [&u, &u]);
                assert!(
                    largest(&moved) < 1e-11,
                    "{a} {b} {ends:?}: {:e}",
                    largest(&moved)
                );
                let pivot = smallest_pivot(&data, &slave, Some(&master));
                assert!(pivot > 1e-3, "{a} {b} {ends:?}: {pivot:e}");

                // A constant pressure is the consistent load where the surface is covered.
                let mut lambda = vec![0.0; data.slave_coupling.nrows()];
                for (lambda, pair) in lambda.iter_mut().zip(&data.pairs) {
                    *lambda = 7.0 * pair.area;
                }
                let check = |body: &Body, coupling| {
                    let mut forces = transposed_product(coupling, &lambda);
                    let load = loads::pressure(&body.mesh, &body.faces, 7.0);
                    forces.iter_mut().zip(&load).for_each(|(f, p)| *f += p);
                    assert!(largest(&forces) < 1e-10, "{a} {b}: {:e}", largest(&forces));
                };
                if ends == [0.0, 3.0] {
                    check(&slave, &data.slave_coupling);
                }
                if ends[1] <= 3.0 {
                    check(&master, data.master_coupling.as_ref().unwrap());
                }
            }
        }
    }
}
