//! States of constant strain are exact on any mesh.

#![allow(clippy::needless_range_loop)] // Components i, j, k as in the formulas.

use crate::common::{perturbed_brick, solve};
use tresca_fem::assembly::internal_forces;
use tresca_fem::loads::{resultant, traction};
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, brick};
use tresca_fem::stress;
use tresca_fem::supports::Supports;

/// Displacement, prescribed on the whole boundary of an irregular mesh, that is linear: the interior
/// nodes follow to rounding, and the stress is the constant one everywhere.
#[test]
fn linear_displacement_on_a_perturbed_mesh() {
    let mesh = perturbed_brick([5, 4, 6], 0.25);
    let material = Isotropic::new(1.7, 0.3).unwrap();
    let gradient = [[0.3, -0.2, 0.1], [0.5, 0.4, -0.3], [0.2, 0.7, -0.6]];
    let exact = |p: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|i| 0.1 * i as f64 + (0..3).map(|j| gradient[i][j] * p[j]).sum::<f64>())
    };
    let mut supports = Supports::new(mesh.node_count(), 3);
    for node in mesh.nodes_of_faces(&mesh.boundary_faces()) {
        for (component, value) in exact(mesh.points[node]).into_iter().enumerate() {
            supports.prescribe(node, component, value).unwrap();
        }
    }
    let u = solve(&mesh, &material, &supports, &vec![0.0; mesh.dof_count()]);
    for (u, &p) in u.chunks_exact(3).zip(&mesh.points) {
        for i in 0..3 {
            assert!((u[i] - exact(p)[i]).abs() < 1e-13, "{u:?} at {p:?}");
        }
    }
    let g = gradient;
    let expected = material.stress([
        g[0][0],
        g[1][1],
        g[2][2],
        g[0][1] + g[1][0],
        g[1][2] + g[2][1],
        g[0][2] + g[2][0],
    ]);
    for nodal in stress::recover(&mesh, &material, &u) {
        for k in 0..6 {
            assert!(
                (nodal[k] - expected[k]).abs() < 1e-12,
                "{nodal:?} against {expected:?}"
            );
        }
    }
    // ½ σ : ε × volume 1, as ½ σ : ∇u.
    let [xx, yy, zz, xy, yz, xz] = expected;
    let s = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let energy: f64 = (0..9)
        .map(|k| 0.5 * s[k / 3][k % 3] * g[k / 3][k % 3])
        .sum();
    assert!((stress::strain_energy(&mesh, &material, &u).unwrap() - energy).abs() < 1e-13);
}

/// A bar pulled by p: u = p/E (x, −νy, −νz), σ_xx = p; the supports' reactions balance the pull.
#[test]
fn uniaxial_bar() {
    let spec = BrickSpec {
        min: [0.0; 3],
        max: [4.0, 1.0, 2.0],
        nodes: [6, 3, 4],
    };
    let mesh = brick(&spec).unwrap();
    let (e, nu, p) = (2.0e5, 0.28, 130.0);
    let material = Isotropic::new(e, nu).unwrap();
    let mut supports = Supports::new(mesh.node_count(), 3);
    for (axis, set) in ["x-", "y-", "z-"].into_iter().enumerate() {
        supports
            .hold(&mesh.nodes_of_set(set).unwrap(), axis)
            .unwrap();
    }
    let load = traction(&mesh, mesh.faces_of_set("x+").unwrap(), [p, 0.0, 0.0]);
    let u = solve(&mesh, &material, &supports, &load);
    for (u, x) in u.chunks_exact(3).zip(&mesh.points) {
        let exact = [x[0], -nu * x[1], -nu * x[2]].map(|s| s * p / e);
        for i in 0..3 {
            assert!((u[i] - exact[i]).abs() < 1e-12 * 4.0 * p / e);
        }
    }
    for nodal in stress::recover(&mesh, &material, &u) {
        assert!((nodal[0] - p).abs() < 1e-10 && nodal[1..].iter().all(|s| s.abs() < 1e-10));
        assert!((stress::von_mises(nodal) - p).abs() < 1e-10);
    }
    let internal = internal_forces(&mesh, &material, &u).unwrap();
    let reactions: Vec<f64> = internal.iter().zip(&load).map(|(k, f)| k - f).collect();
    let sum = resultant(&mesh, &reactions, [0.0; 3]);
    assert!(
        (sum.force[0] + 2.0 * p).abs() < 1e-9 && sum.force[1].abs() + sum.force[2].abs() < 1e-9
    );
    // The pull acts at (4, 0.5, 1): its moment is (0, p·2·1, −p·2·0.5).
    assert!((sum.moment[1] + 2.0 * p).abs() < 1e-9 && (sum.moment[2] - p).abs() < 1e-9);
}

/// A plate of one layer of cells: the recovery must not extrapolate what it cannot see.
#[test]
fn one_layer_of_cells_recovers_a_constant_stress() {
    let spec = BrickSpec {
        min: [0.0; 3],
        max: [1.0, 1.0, 0.01],
        nodes: [4, 4, 2],
    };
    let mesh = brick(&spec).unwrap();
    let material = Isotropic::new(1.0, 0.25).unwrap();
    let u: Vec<f64> = mesh
        .points
        .iter()
        .flat_map(|p| [p[0], 0.5 * p[1], 0.0])
        .collect();
    let expected = material.stress([1.0, 0.5, 0.0, 0.0, 0.0, 0.0]);
    for nodal in stress::recover(&mesh, &material, &u) {
        assert!(
            (0..6).all(|k| (nodal[k] - expected[k]).abs() < 1e-12),
            "{nodal:?}"
        );
    }
}
