//! Curved interfaces: what is not exact converges at its order.

use std::f64::consts::PI;
use tresca_testkit::largest;

use tresca_contact::{ContactData, RigidShape, couple_obstacle};
use tresca_fem::loads;
use tresca_fem::mesh::{CellKind, RectangleSpec, Space, rectangle};

use super::flat::KINDS;
use super::plane;
use super::support::{Body, INTERFACE, block, elevated, mortar, relative, transposed_product};

const INNER: f64 = 2.0;
const OUTER: f64 = 2.001;

/// A patch of a spherical shell between two radii, its edges not aligned with anything.
pub fn shell(kind: CellKind, radii: [f64; 2], cells: usize, size: f64, at: f64) -> Body {
    let n = [cells, cells, 1];
    let (min, max) = ([-size, -size, radii[0]], [size, size, radii[1]]);
    let mesh = block(kind, min, max, n)
        .mapped(|[x, y, r]| {
            // Equidistant angles of the cubed sphere, slightly turned.
            let (x, y) = (x + 0.1 * y, y - 0.05 * x);
            let d = [x.tan(), y.tan(), 1.0];
            let length = d.iter().map(|x| x * x).sum::<f64>().sqrt();
            d.map(|d| r * d / length)
        })
        .unwrap();
    Body::new(mesh, |x| {
        let r = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        (r - at).abs() < 1e-9
    })
}

fn order(kind: CellKind) -> usize {
    kind.faces()[0].kind.order()
}

/// The mean error of the gap over the surface.
fn error(data: &ContactData, gap: f64) -> f64 {
    let errors = data
        .pairs
        .iter()
        .map(|pair| pair.area * (pair.gap - gap).abs());
    errors.sum::<f64>() / data.overlap_area
}

fn check_rates(name: &str, order: usize, errors: &[f64]) {
    let rates: Vec<f64> = errors.windows(2).map(|e| (e[0] / e[1]).log2()).collect();
    let shown: Vec<String> = errors.iter().map(|e| format!("{e:.2e}")).collect();
    println!("{name}: errors {}, rates {rates:.2?}", shown.join(", "));
    let last = rates[rates.len() - 1];
    assert!(last > order as f64 - 0.25, "{name}: {shown:?}, {rates:?}");
}

#[test]
fn the_gap_between_concentric_spheres_converges() {
    for kind in KINDS {
        for partner in [CellKind::Hex8, CellKind::Tet10] {
            let errors = [4, 8, 16].map(|n| {
                let slave = shell(kind, [1.5, INNER], n, 0.3, INNER);
                let master = shell(partner, [OUTER, 2.5], n * 3 / 2, 0.4, OUTER);
                let data = mortar(&slave, &master);
                assert!(data.uncoupled.is_empty());
                error(&data, OUTER - INNER)
            });
            // Facets leave h², parabolas h³.
            let rate = 1 + order(kind).min(order(partner));
            check_rates(&format!("{kind} in {partner}"), rate, &errors);
        }
    }
}

#[test]
fn areas_and_forces_of_curved_faces() {
    for kind in KINDS {
        let slave = shell(kind, [1.5, INNER], 6, 0.3, INNER);
        let master = shell(CellKind::Hex8, [INNER, 2.5], 10, 0.5, INNER);
        let data = mortar(&slave, &master);
        let area: f64 = data.pairs.iter().map(|pair| pair.area).sum();
        let expected = slave.mesh.area(&slave.faces);
        let error = (area / expected - 1.0).abs();
        assert!(error < 1e-4, "{kind}: {area} against {expected}");
        assert!((data.overlap_area / area - 1.0).abs() < 1e-12);
        // Forces cancel whatever the geometry.
        let lambda: Vec<f64> = (0..data.slave_coupling.nrows())
            .map(|i| (1.0 + i as f64 * 12.9898).sin())
            .collect();
        let force = |body: &Body, coupling| {
            let forces = transposed_product(coupling, &lambda);
            loads::resultant(&body.mesh, &forces, [0.0; 3]).force
        };
        let a = force(&slave, &data.slave_coupling);
        let b = force(&master, data.master_coupling.as_ref().unwrap());
        assert!((0..3).all(|k| (a[k] + b[k]).abs() < 1e-12 * largest(&lambda)));
        // Common translations are no approach.
        let v = |_: [f64; 3]| [1.0, -2.0, 3.0];
        let moved = relative(&data, &slave, &master, [&v, &v]);
        assert!(largest(&moved) < 1e-12);
    }
}

fn arc(
    kind: CellKind,
    space: Space,
    radii: [f64; 2],
    cells: usize,
    range: [f64; 2],
    at: f64,
) -> Body {
    let linear = match kind {
        CellKind::Tri3 | CellKind::Tri6 => CellKind::Tri3,
        _ => CellKind::Quad4,
    };
    // In angle and radius first, the angle downwards so that cells keep their orientation.
    let mut mesh = rectangle(&RectangleSpec {
        space: Space::Plane,
        min: [-range[1], radii[0]],
        max: [-range[0], radii[1]],
        nodes: [cells + 1, 2],
        cells: linear,
    })
    .unwrap();
    if kind != linear {
        mesh = elevated(&mesh, kind);
    }
    let mut mesh = mesh
        .mapped(|[t, r, _]| [(r * (-t).cos()).max(0.0), r * (-t).sin(), 0.0])
        .unwrap();
    mesh.space = space;
    mesh.validate().unwrap();
    Body::new(mesh, |[x, y, _]| (x.hypot(y) - at).abs() < 1e-9)
}

#[test]
fn the_gap_between_concentric_circles_converges() {
    for space in [Space::Plane, Space::Axisymmetric] {
        for kind in plane::KINDS {
            for partner in [CellKind::Tri3, CellKind::Quad8] {
                let range = [-0.5 * PI, 0.5 * PI];
                let errors = [16, 32, 64].map(|n| {
                    let slave = arc(kind, space, [1.5, INNER], n, range, INNER);
                    let master = arc(partner, space, [OUTER, 2.5], n * 5 / 4, range, OUTER);
                    error(&mortar(&slave, &master), OUTER - INNER)
                });
                let rate = 1 + order(kind).min(order(partner));
                check_rates(&format!("{space} {kind} in {partner}"), rate, &errors);
            }
        }
    }
}

/// A ball's surface on a plane: the gap of each multiplier is the mean of the true one against it.
#[test]
fn the_gap_between_a_sphere_and_a_plane_converges() {
    for kind in KINDS {
        let errors = [4, 8, 16].map(|n| {
            let slave = shell(kind, [1.5, INNER], n, 0.3, INNER);
            let plane = RigidShape::Plane {
                point: [0.0, 0.0, INNER],
                normal: [0.0, 0.0, -1.0],
            };
            let data = couple_obstacle(slave.side(), &plane, INTERFACE, None).unwrap();
            // Σ a_j d_j = ∫ g: 2 − z over the patch; compare with a fine rule on the same nodes.
            let total: f64 = data.pairs.iter().map(|pair| pair.area * pair.gap).sum();
            let fine = shell(CellKind::Hex27, [1.5, INNER], 48, 0.3, INNER);
            let exact =
                loads::traction_field(&fine.mesh, &fine.faces, |[_, _, z]| [0.0, 0.0, INNER - z]);
            let exact: f64 = exact.iter().sum();
            (total / exact - 1.0).abs()
        });
        check_rates(&format!("{kind} on a plane"), 2 * order(kind), &errors);
    }
}
