//! Nearly incompressible bodies: what locks, and what does not.
//!
//! Lamé's cylinder 1 ≤ r ≤ 2 under inner pressure in plane strain, as a quarter ring, as a body of
//! revolution and as a slice in space. As ν → ½ the displacement becomes isochoric, u = β/r.

use crate::common::{kinds, solve_with};
use tresca_fem::assembly::Formulation;
use tresca_fem::loads::pressure;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, Mesh, RectangleSpec, Space, brick, rectangle};
use tresca_fem::stress;
use tresca_fem::supports::Supports;

const YOUNG: f64 = 100.0;
const PRESSURE: f64 = 3.0;
/// p a²/(b² − a²).
const C: f64 = PRESSURE / 3.0;

/// Radial displacement at the inner face: αa + β/a with α = (1 + ν)(1 − 2ν) C/E, β = (1 + ν) C b²/E.
fn inner_displacement(nu: f64) -> f64 {
    (1.0 + nu) * C / YOUNG * ((1.0 - 2.0 * nu) + 4.0)
}

/// The ring of n cells across and 2n around; in space one layer of height 1/n.
fn ring(space: Space, kind: CellKind, n: usize) -> Mesh {
    let quarter = std::f64::consts::FRAC_PI_2;
    let h = 1.0 / n as f64;
    let turn = |[r, angle, z]: [f64; 3]| [r * angle.cos(), r * angle.sin(), z];
    let mesh = match space {
        Space::Solid => brick(&BrickSpec {
            min: [1.0, 0.0, 0.0],
            max: [2.0, quarter, h],
            nodes: [n + 1, 2 * n + 1, 2],
        }),
        _ => rectangle(&RectangleSpec {
            space,
            min: [1.0, 0.0],
            max: [
                2.0,
                if space == Space::Plane {
                    quarter
                } else {
                    2.0 * h
                },
            ],
            nodes: [n + 1, if space == Space::Plane { 2 * n + 1 } else { 3 }],
            cells: kind.linear(),
        }),
    };
    let mesh = mesh.unwrap().with_cells(kind).unwrap();
    match space {
        Space::Axisymmetric => mesh,
        _ => mesh.mapped(turn).unwrap(),
    }
}

/// The solution with ν, and the error of the mean radial displacement at the inner face relative to the
/// exact one: negative for too stiff.
fn solve_ring(mesh: &Mesh, nu: f64, formulation: Formulation) -> (Vec<f64>, f64) {
    let material = Isotropic::new(YOUNG, nu).unwrap();
    let mut supports = Supports::new(mesh.node_count(), mesh.dimension());
    let held: &[(&str, usize)] = match mesh.space {
        Space::Axisymmetric => &[("y-", 1), ("y+", 1)],
        Space::Plane => &[("y-", 1), ("y+", 0)],
        Space::Solid => &[("y-", 1), ("y+", 0), ("z-", 2), ("z+", 2)],
    };
    for (set, component) in held {
        let nodes = mesh.nodes_of_set(set).unwrap();
        supports.hold(&nodes, *component).unwrap();
    }
    let load = pressure(mesh, mesh.faces_of_set("x-").unwrap(), PRESSURE);
    let u = solve_with(mesh, &material, formulation, &supports, &load);
    let inner = mesh.nodes_of_set("x-").unwrap();
    let d = mesh.dimension();
    let radial = inner.iter().map(|&node| {
        let ([x, y, _], v) = (mesh.points[node], &u[d * node..]);
        if mesh.space == Space::Axisymmetric {
            v[0]
        } else {
            (v[0] * x + v[1] * y) / x.hypot(y)
        }
    });
    let mean = radial.sum::<f64>() / inner.len() as f64;
    (u, mean / inner_displacement(nu) - 1.0)
}

/// The error of a formulation on meshes of 4 and of 8 cells across, printed.
fn ring_errors(space: Space, kind: CellKind, nu: f64, formulation: Formulation) -> [f64; 2] {
    let errors = [4, 8].map(|n| solve_ring(&ring(space, kind, n), nu, formulation).1);
    let [coarse, fine] = errors.map(|x| 100.0 * x);
    println!("{space:<12} {kind:<6} {formulation:<5} ν = {nu}: {coarse:+8.4} %, {fine:+8.4} %");
    errors
}

#[test]
fn what_locks_and_what_does_not() {
    for space in [Space::Plane, Space::Axisymmetric, Space::Solid] {
        for kind in kinds(space.dimension()) {
            let [steel, _] = ring_errors(space, kind, 0.3, Formulation::Full);
            assert!(steel.abs() < 0.05, "{space} {kind}: {steel}");
            let [coarse, fine] = ring_errors(space, kind, 0.4999, Formulation::Full);
            match kind {
                // One constraint per cell or point for two or three dofs: these lock.
                _ if kind.order() == 1 => assert!(coarse < -0.1, "{space} {kind}: {coarse}"),
                // These do not at all.
                CellKind::Tri6 | CellKind::Tet10 => {
                    assert!(coarse.abs() < 0.003, "{kind}: {coarse}")
                }
                // The full rule of quadrilaterals and hexahedra stiffens coarse meshes, and the error
                // falls with order 4.
                _ => {
                    assert!(
                        coarse.abs() < 0.1 && fine.abs() < 0.01,
                        "{space} {kind}: {coarse}"
                    );
                    assert!(
                        (coarse / fine).log2() > 3.5,
                        "{space} {kind}: {coarse}, {fine}"
                    );
                }
            }
        }
    }
}

/// One dilatation per cell is right for quadrilaterals and hexahedra. Wedges have two cells where
/// hexahedra have one, and stay as stiff as the triangles that they stand on.
#[test]
fn what_b_bar_does() {
    for (space, kind) in [
        (Space::Plane, CellKind::Quad4),
        (Space::Axisymmetric, CellKind::Quad4),
        (Space::Solid, CellKind::Hex8),
    ] {
        let [coarse, fine] = ring_errors(space, kind, 0.4999, Formulation::BBar);
        assert!(
            coarse.abs() < 0.01 && fine.abs() < 0.003,
            "{space} {kind}: {coarse}"
        );
    }
    let [wedge, _] = ring_errors(Space::Solid, CellKind::Wedge6, 0.4999, Formulation::BBar);
    let [triangle, _] = ring_errors(Space::Plane, CellKind::Tri3, 0.4999, Formulation::Full);
    assert!(
        (wedge - triangle).abs() < 0.01 * triangle.abs(),
        "{wedge} {triangle}"
    );
}

/// B-bar converges with order 2 all the same, displacement and hydrostatic stress.
#[test]
fn b_bar_converges_near_incompressibility() {
    let nu = 0.4999;
    for (space, kind) in [
        (Space::Plane, CellKind::Quad4),
        (Space::Axisymmetric, CellKind::Quad4),
        (Space::Solid, CellKind::Hex8),
    ] {
        let errors = [8, 16].map(|n| {
            let mesh = ring(space, kind, n);
            let material = Isotropic::new(YOUNG, nu).unwrap();
            let (u, displacement) = solve_ring(&mesh, nu, Formulation::BBar);
            // σ_xx + σ_yy + σ_zz = 2(1 + ν) C in a quarter ring, the same with r, θ, z.
            let exact = 2.0 * (1.0 + nu) * C;
            let recovered = stress::recover(&mesh, &material, Formulation::BBar, &u, None);
            let squares = recovered
                .iter()
                .map(|s| (s[0] + s[1] + s[2] - exact).powi(2));
            let rms = (squares.sum::<f64>() / recovered.len() as f64).sqrt() / exact;
            [displacement.abs(), rms]
        });
        let rates = [0, 1].map(|k| (errors[0][k] / errors[1][k]).log2());
        println!(
            "{space:<12} {kind:<7} b_bar  displacement, pressure {errors:.5?} rates {rates:.2?}"
        );
        assert!((rates[0] - 2.0).abs() < 0.2, "{space} {kind}: {rates:?}");
        assert!(rates[1] > 1.8, "{space} {kind}: {rates:?}");
    }
}
