//! States of constant strain are exact on any mesh.

use crate::common::{kinds, perturbed_brick, solve, solve_with};
use std::collections::BTreeMap;
use tresca_fem::assembly::{Formulation, internal_forces};
use tresca_fem::loads::{resultant, traction};
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellBlock, CellKind, Mesh, Space, brick};
use tresca_fem::stress;
use tresca_fem::supports::Supports;

const GRADIENT: [[f64; 3]; 3] = [[0.3, -0.2, 0.1], [0.5, 0.4, -0.3], [0.2, 0.7, -0.6]];

fn linear(p: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| 0.1 * i as f64 + (0..3).map(|j| GRADIENT[i][j] * p[j]).sum::<f64>())
}

/// Displacement, prescribed on the whole boundary, that is linear: the interior nodes follow to
/// rounding, and the stress is the constant one everywhere.
fn linear_displacement_is_exact(name: &str, mesh: &Mesh, formulation: Formulation) {
    let material = Isotropic::new(1.7, 0.3).unwrap();
    mesh.check_cells().unwrap();
    let mut supports = Supports::new(mesh.node_count(), 3);
    for node in mesh.nodes_of_faces(&mesh.boundary_faces()) {
        for (component, value) in linear(mesh.points[node]).into_iter().enumerate() {
            supports.prescribe(node, component, value).unwrap();
        }
    }
    let no_load = vec![0.0; mesh.dof_count()];
    let u = solve_with(mesh, &material, formulation, &supports, &no_load);
    for (u, &p) in u.chunks_exact(3).zip(&mesh.points) {
        for i in 0..3 {
            assert!(
                (u[i] - linear(p)[i]).abs() < 1e-13,
                "{name}: {u:?} at {p:?}"
            );
        }
    }
    let g = GRADIENT;
    let expected = material.stress([
        g[0][0],
        g[1][1],
        g[2][2],
        g[0][1] + g[1][0],
        g[1][2] + g[2][1],
        g[0][2] + g[2][0],
    ]);
    let samples = stress::samples(mesh, &material, formulation, &u, None);
    let recovered = stress::recover(mesh, &material, formulation, &u, None);
    for stress in samples.iter().map(|sample| sample.stress).chain(recovered) {
        let error = (0..6).map(|k| (stress[k] - expected[k]).abs());
        let error = error.fold(0.0, f64::max);
        assert!(error < 1e-12, "{name}: {stress:?} against {expected:?}");
    }
    // ½ σ : ε × volume 1, as ½ σ : ∇u.
    let [xx, yy, zz, xy, yz, xz] = expected;
    let s = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let energy: f64 = (0..9)
        .map(|k| 0.5 * s[k / 3][k % 3] * g[k / 3][k % 3])
        .sum();
    let found = stress::strain_energy(mesh, &material, formulation, &u).unwrap();
    assert!((found - energy).abs() < 1e-13, "{name}");
}

#[test]
fn linear_displacement_on_distorted_meshes_of_every_kind() {
    for kind in kinds(3) {
        let mesh = perturbed_brick([5, 4, 4], 0.15).with_cells(kind).unwrap();
        linear_displacement_is_exact(kind.name(), &mesh, Formulation::Full);
        if matches!(kind, CellKind::Hex8 | CellKind::Wedge6) {
            linear_displacement_is_exact("B-bar", &mesh, Formulation::BBar);
        }
    }
    linear_displacement_is_exact("hex8", &perturbed_brick([5, 4, 6], 0.25), Formulation::Full);
}

/// Middle nodes off the middles: curved edges and faces inside the body. The four points of tet10 are
/// exact on straight cells only, so it is left out here; it converges on curved meshes at the full rate
/// (see the rates on curved meshes).
#[test]
fn linear_displacement_in_curved_cells() {
    for kind in [CellKind::Hex20, CellKind::Hex27] {
        let straight = perturbed_brick([4, 4, 3], 0.1).with_cells(kind).unwrap();
        let bump = |t: f64| t * (1.0 - t);
        let curved = straight.mapped(|[x, y, z]| {
            let b = bump(x) * bump(y) * bump(z);
            [x + 2.0 * b * (y - 0.3), y + 1.5 * b, z - 2.0 * b * x]
        });
        linear_displacement_is_exact(kind.name(), &curved.unwrap(), Formulation::Full);
    }
}

/// The bricks of a mesh of 4 × 3 × 3 cut each into cells of the kind chosen by its indices.
fn mixed(kind_of: impl Fn([usize; 3]) -> CellKind) -> Mesh {
    let bricks = perturbed_brick([5, 4, 4], 0.1);
    let mut connectivity: BTreeMap<CellKind, Vec<usize>> = BTreeMap::new();
    for kind in [CellKind::Hex8, CellKind::Wedge6, CellKind::Tet4] {
        let cut = bricks.clone().with_cells(kind).unwrap();
        let pieces = cut.cells[0]
            .connectivity
            .chunks(cut.cells[0].connectivity.len() / 36);
        for (brick, pieces) in pieces.enumerate() {
            if kind_of([brick % 4, brick / 4 % 3, brick / 12]) == kind {
                connectivity.entry(kind).or_default().extend(pieces);
            }
        }
    }
    let blocks = connectivity.into_iter();
    let blocks = blocks.map(|(kind, connectivity)| CellBlock { kind, connectivity });
    Mesh::new(
        Space::Solid,
        bricks.points,
        blocks.collect(),
        BTreeMap::new(),
    )
    .unwrap()
}

/// Cells of two kinds in one mesh, and faces of two kinds on one cell.
#[test]
fn linear_displacement_in_mixed_meshes() {
    let beside = mixed(|[i, ..]| {
        if i < 2 {
            CellKind::Hex8
        } else {
            CellKind::Wedge6
        }
    });
    let above = mixed(|[.., k]| {
        if k < 1 {
            CellKind::Wedge6
        } else {
            CellKind::Tet4
        }
    });
    for (name, mesh) in [("hex8 and wedge6", beside), ("wedge6 and tet4", above)] {
        assert_eq!(mesh.cells.len(), 2);
        let surface = mesh.boundary_faces();
        assert!(
            (mesh.area(&surface) - 6.0).abs() < 1e-13,
            "{name} do not match"
        );
        linear_displacement_is_exact(name, &mesh, Formulation::Full);
    }
}

/// A bar pulled by p: u = p/E (x, −νy, −νz), σ_xx = p; the supports' reactions balance the pull.
#[test]
fn uniaxial_bar() {
    let spec = BrickSpec {
        min: [0.0; 3],
        max: [4.0, 1.0, 2.0],
        nodes: [6, 3, 4],
    };
    for kind in kinds(3) {
        let mesh = brick(&spec).unwrap().with_cells(kind).unwrap();
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
        for nodal in stress::recover(&mesh, &material, Formulation::Full, &u, None) {
            assert!((nodal[0] - p).abs() < 1e-10 && nodal[1..].iter().all(|s| s.abs() < 1e-10));
            assert!((stress::von_mises(nodal) - p).abs() < 1e-10);
        }
        let internal = internal_forces(&mesh, &material, Formulation::Full, &u, None).unwrap();
        let reactions: Vec<f64> = internal.iter().zip(&load).map(|(k, f)| k - f).collect();
        let sum = resultant(&mesh, &reactions, [0.0; 3]);
        assert!(
            (sum.force[0] + 2.0 * p).abs() < 1e-9 && sum.force[1].abs() + sum.force[2].abs() < 1e-9
        );
        // The pull acts at (4, 0.5, 1): its moment is (0, p·2·1, −p·2·0.5).
        assert!((sum.moment[1] + 2.0 * p).abs() < 1e-9 && (sum.moment[2] - p).abs() < 1e-9);
    }
}

/// A plate of one layer of cells: the recovery must not extrapolate what it cannot see.
#[test]
fn one_layer_of_cells_recovers_a_constant_stress() {
    let spec = BrickSpec {
        min: [0.0; 3],
        max: [1.0, 1.0, 0.01],
        nodes: [4, 4, 2],
    };
    for kind in kinds(3) {
        let mesh = brick(&spec).unwrap().with_cells(kind).unwrap();
        let material = Isotropic::new(1.0, 0.25).unwrap();
        let u: Vec<f64> = mesh
            .points
            .iter()
            .flat_map(|p| [p[0], 0.5 * p[1], 0.0])
            .collect();
        let expected = material.stress([1.0, 0.5, 0.0, 0.0, 0.0, 0.0]);
        for nodal in stress::recover(&mesh, &material, Formulation::Full, &u, None) {
            assert!(
                (0..6).all(|k| (nodal[k] - expected[k]).abs() < 1e-12),
                "{nodal:?}"
            );
        }
    }
}
