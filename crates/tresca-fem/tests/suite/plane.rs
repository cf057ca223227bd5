//! Plane strain, plane stress and bodies of revolution: the assembled matrix against a naive one, and
//! states of constant stress, which are exact on any mesh.

use crate::common::{dense, kinds, perturbed_rectangle, solve};
use tresca_fem::FemError;
use tresca_fem::assembly::{Formulation, internal_forces, stiffness};
use tresca_fem::dofs::DofMap;
use tresca_fem::loads::{pressure, resultant, traction};
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{CellKind, Mesh, Space};
use tresca_fem::rigid;
use tresca_fem::stress;
use tresca_fem::supports::Supports;

const E: f64 = 210.0;
const NU: f64 = 0.3;

fn solid() -> Isotropic {
    Isotropic::new(E, NU).unwrap()
}

/// Every space and material that a plane mesh serves.
fn models() -> [(Space, Isotropic); 3] {
    [
        (Space::Plane, solid()),
        (Space::Plane, solid().plane_stress()),
        (Space::Axisymmetric, solid()),
    ]
}

/// σ = D ε in the order xx, yy, zz, γxy, from the textbook: plane stress with E/(1 − ν²), else with
/// E/((1 + ν)(1 − 2ν)).
fn textbook_elasticity(material: &Isotropic) -> [[f64; 4]; 4] {
    let shear = E / (2.0 * (1.0 + NU));
    if material.is_plane_stress() {
        let c = E / (1.0 - NU * NU);
        let row = [c, NU * c, 0.0, 0.0];
        return [
            row,
            [row[1], row[0], 0.0, 0.0],
            [0.0; 4],
            [0.0, 0.0, 0.0, shear],
        ];
    }
    let c = E / ((1.0 + NU) * (1.0 - 2.0 * NU));
    let (own, other) = (c * (1.0 - NU), c * NU);
    [
        [own, other, other, 0.0],
        [other, own, other, 0.0],
        [other, other, own, 0.0],
        [0.0, 0.0, 0.0, shear],
    ]
}

/// Reference points, weights, values and gradients of a cell, written out by hand.
fn reference(kind: CellKind) -> Vec<(f64, Vec<f64>, Vec<[f64; 2]>)> {
    match kind {
        CellKind::Tri3 => [[1.0, 1.0], [4.0, 1.0], [1.0, 4.0]]
            .into_iter()
            .map(|p| {
                let [x, y] = p.map(|x: f64| x / 6.0);
                let gradients = vec![[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
                (1.0 / 6.0, vec![1.0 - x - y, x, y], gradients)
            })
            .collect(),
        _ => {
            let sign: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            sign.into_iter()
                .map(|p| {
                    let [x, y] = p.map(|s| s / 3f64.sqrt());
                    let factors = sign.map(|[a, b]| [1.0 + a * x, 1.0 + b * y]);
                    let values = factors.iter().map(|[f, g]| 0.25 * f * g).collect();
                    let gradients = sign
                        .iter()
                        .zip(factors)
                        .map(|([a, b], [f, g])| [0.25 * a * g, 0.25 * b * f])
                        .collect();
                    (1.0, values, gradients)
                })
                .collect()
        }
    }
}

/// ∫ Bᵀ D B over all cells, dense.
fn naive(mesh: &Mesh, material: &Isotropic) -> Vec<Vec<f64>> {
    let d = textbook_elasticity(material);
    let mut k = vec![vec![0.0; mesh.dof_count()]; mesh.dof_count()];
    for cell in mesh.iter_cells() {
        let x: Vec<[f64; 3]> = cell.nodes.iter().map(|&a| mesh.points[a]).collect();
        for (weight, values, gradients) in reference(cell.kind) {
            let j: [[f64; 2]; 2] = std::array::from_fn(|r| {
                std::array::from_fn(|c| gradients.iter().zip(&x).map(|(g, x)| g[r] * x[c]).sum())
            });
            let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
            let radius: f64 = values.iter().zip(&x).map(|(v, x)| v * x[0]).sum();
            let axisymmetric = mesh.space == Space::Axisymmetric;
            let circumference = 2.0 * std::f64::consts::PI * radius;
            let measure = weight * det * if axisymmetric { circumference } else { 1.0 };
            let mut b: Vec<[f64; 4]> = Vec::new();
            for (g, value) in gradients.iter().zip(&values) {
                let dx = (j[1][1] * g[0] - j[0][1] * g[1]) / det;
                let dy = (-j[1][0] * g[0] + j[0][0] * g[1]) / det;
                let hoop = if axisymmetric { value / radius } else { 0.0 };
                b.push([dx, 0.0, hoop, dy]);
                b.push([0.0, dy, 0.0, dx]);
            }
            for (r, left) in b.iter().enumerate() {
                for (c, right) in b.iter().enumerate() {
                    for p in 0..4 {
                        for q in 0..4 {
                            k[2 * cell.nodes[r / 2] + r % 2][2 * cell.nodes[c / 2] + c % 2] +=
                                measure * left[p] * d[p][q] * right[q];
                        }
                    }
                }
            }
        }
    }
    k
}

#[test]
fn the_stiffness_equals_a_naive_dense_assembly() {
    for cells in [CellKind::Quad4, CellKind::Tri3] {
        for (space, material) in models() {
            // The axis belongs to the body of revolution.
            let mesh = perturbed_rectangle(space, cells, [0.0, -0.3], [5, 4], 0.2);
            let reference = naive(&mesh, &material);
            let scale = reference
                .iter()
                .flatten()
                .fold(0.0_f64, |a, b| a.max(b.abs()));
            let mut supports = Supports::new(mesh.node_count(), 2);
            supports.clamp(&mesh.nodes_of_set("y-").unwrap()).unwrap();
            supports.hold(&mesh.nodes_of_set("x+").unwrap(), 0).unwrap();
            for supports in [Supports::new(mesh.node_count(), 2), supports] {
                let dofs = DofMap::new(&supports);
                let k = dense(&stiffness(&mesh, &material, Formulation::Full, &dofs).unwrap());
                for r in 0..dofs.free_len() {
                    for c in 0..dofs.free_len() {
                        let expected = reference[dofs.full_of_free(r)][dofs.full_of_free(c)];
                        assert!(
                            (k[r][c] - expected).abs() < 1e-14 * scale,
                            "{space} {cells}: entry {r}, {c}"
                        );
                    }
                }
            }
            // Internal forces are its action, and the strain energy its quadratic form.
            let u: Vec<f64> = (0..mesh.dof_count()).map(|i| (i as f64).sin()).collect();
            let forces = internal_forces(&mesh, &material, Formulation::Full, &u, None).unwrap();
            let mut energy = 0.0;
            for (i, row) in reference.iter().enumerate() {
                let expected: f64 = row.iter().zip(&u).map(|(k, u)| k * u).sum();
                assert!((forces[i] - expected).abs() < 1e-13 * scale);
                energy += 0.5 * u[i] * expected;
            }
            let of_stress = stress::strain_energy(&mesh, &material, Formulation::Full, &u).unwrap();
            assert!((of_stress - energy).abs() < 1e-13 * energy);
        }
    }
}

#[test]
fn bad_cells_are_named() {
    let refused = |mesh: &Mesh, degenerate: bool, cell: usize| {
        let u = vec![0.0; mesh.dof_count()];
        let dofs = DofMap::unsupported(mesh.node_count(), 2);
        for error in [
            stiffness(mesh, &solid(), Formulation::Full, &dofs).unwrap_err(),
            internal_forces(mesh, &solid(), Formulation::Full, &u, None).unwrap_err(),
            mesh.check_cells().unwrap_err(),
        ] {
            match error {
                FemError::InvertedCell { cell: found, .. } if !degenerate => {
                    assert_eq!(found, cell)
                }
                FemError::DegenerateCell { cell: found, .. } if degenerate => {
                    assert_eq!(found, cell)
                }
                other => panic!("{other}"),
            }
        }
    };
    for cells in [CellKind::Quad4, CellKind::Tri3] {
        for (space, _) in models() {
            let mesh = || perturbed_rectangle(space, cells, [0.0, 0.0], [4, 4], 0.1);
            let mut turned = mesh();
            let n = cells.node_count();
            turned.cells[0].connectivity[n * 5..n * 6].reverse();
            refused(&turned, false, 5);
            // All of the body pressed onto the axis.
            refused(&mesh().mapped(|[_, y, _]| [0.0, y, 0.0]).unwrap(), true, 0);
        }
    }
}

#[test]
fn rigid_motions_and_nothing_else_cost_no_energy() {
    for cells in kinds(2) {
        for (space, material) in models() {
            let mesh = perturbed_rectangle(space, cells, [0.0, 0.0], [4, 4], 0.15);
            let dofs = DofMap::unsupported(mesh.node_count(), 2);
            let k = dense(&stiffness(&mesh, &material, Formulation::Full, &dofs).unwrap());
            let motions = rigid::remaining(&mesh, &dofs);
            assert_eq!(motions.len(), if space == Space::Plane { 3 } else { 1 });
            for motion in &motions {
                let u = motion.displacement(&mesh);
                let forces =
                    internal_forces(&mesh, &material, Formulation::Full, &u, None).unwrap();
                assert!(forces.iter().all(|f| f.abs() < 1e-13 * E), "{motion}");
            }
            let n = k.len();
            let eigenvalues = faer::Mat::from_fn(n, n, |i, j| k[i][j])
                .self_adjoint_eigenvalues(faer::Side::Lower)
                .unwrap();
            let largest = eigenvalues[n - 1];
            assert!(eigenvalues[motions.len() - 1].abs() < 1e-13 * largest);
            assert!(
                eigenvalues[motions.len()] > 1e-5 * largest,
                "{space} {cells}"
            );
        }
    }
}

/// Largest difference of a nodal displacement from a field.
fn error(mesh: &Mesh, u: &[f64], exact: impl Fn([f64; 3]) -> [f64; 2]) -> f64 {
    u.chunks_exact(2)
        .zip(&mesh.points)
        .flat_map(|(u, &p)| [u[0] - exact(p)[0], u[1] - exact(p)[1]])
        .fold(0.0, |a, b| a.max(b.abs()))
}

/// Stress at all points of the recovery, and at the nodes, against a constant.
fn has_stress(mesh: &Mesh, material: &Isotropic, u: &[f64], expected: [f64; 6]) {
    let samples = stress::samples(mesh, material, Formulation::Full, u, None);
    let recovered = stress::recover(mesh, material, Formulation::Full, u, None);
    let of_samples = samples.iter().map(|sample| sample.stress);
    for found in of_samples.chain(recovered) {
        assert!(
            (0..6).all(|k| (found[k] - expected[k]).abs() < 1e-11),
            "{found:?} against {expected:?}"
        );
    }
}

/// A linear displacement prescribed on the whole boundary.
#[test]
fn linear_displacement_in_the_plane() {
    let gradient = [[0.3, -0.2], [0.5, 0.4]];
    let exact =
        |p: [f64; 3]| -> [f64; 2] { gradient.map(|row| 0.1 + row[0] * p[0] + row[1] * p[1]) };
    let strain = [0.3, 0.4, 0.0, 0.3];
    for cells in kinds(2) {
        for material in [solid(), solid().plane_stress()] {
            let mesh = perturbed_rectangle(Space::Plane, cells, [0.2, -0.5], [6, 7], 0.25);
            let mut supports = Supports::new(mesh.node_count(), 2);
            for node in mesh.nodes_of_faces(&mesh.boundary_faces()) {
                for (component, value) in exact(mesh.points[node]).into_iter().enumerate() {
                    supports.prescribe(node, component, value).unwrap();
                }
            }
            let u = solve(&mesh, &material, &supports, &vec![0.0; mesh.dof_count()]);
            assert!(error(&mesh, &u, exact) < 1e-13);
            let d = textbook_elasticity(&material);
            let [xx, yy, zz, xy] = d.map(|row| (0..4).map(|k| row[k] * strain[k]).sum::<f64>());
            has_stress(&mesh, &material, &u, [xx, yy, zz, xy, 0.0, 0.0]);
            // Area 1.
            let energy = 0.5 * (xx * strain[0] + yy * strain[1] + xy * strain[3]);
            let found = stress::strain_energy(&mesh, &material, Formulation::Full, &u).unwrap();
            assert!((found - energy).abs() < 1e-12 * energy);
        }
    }
}

/// A strip pulled along x. Plane strain: u = p(1 + ν)/E ((1 − ν)x, −νy), σ_zz = νp; plane stress:
/// u = p/E (x, −νy), σ_zz = 0.
#[test]
fn a_pulled_strip() {
    let p = 3.0;
    for cells in kinds(2) {
        for material in [solid(), solid().plane_stress()] {
            let mesh = perturbed_rectangle(Space::Plane, cells, [0.0, 0.0], [5, 6], 0.2);
            let mut supports = Supports::new(mesh.node_count(), 2);
            supports.hold(&mesh.nodes_of_set("x-").unwrap(), 0).unwrap();
            supports.hold(&mesh.nodes_of_set("y-").unwrap(), 1).unwrap();
            let faces = mesh.faces_of_set("x+").unwrap();
            let load = traction(&mesh, faces, [p, 0.0, 0.0]);
            let u = solve(&mesh, &material, &supports, &load);
            let (along, across, zz) = if material.is_plane_stress() {
                (1.0, -NU, 0.0)
            } else {
                ((1.0 + NU) * (1.0 - NU), -(1.0 + NU) * NU, NU * p)
            };
            let exact = |x: [f64; 3]| [along * x[0], across * x[1]].map(|s| s * p / E);
            assert!(error(&mesh, &u, exact) < 1e-14);
            has_stress(&mesh, &material, &u, [p, 0.0, zz, 0.0, 0.0, 0.0]);
            let forces = internal_forces(&mesh, &material, Formulation::Full, &u, None).unwrap();
            let reactions: Vec<f64> = forces.iter().zip(&load).map(|(k, f)| k - f).collect();
            let sum = resultant(&mesh, &reactions, [0.0; 3]);
            assert!((sum.force[0] + p).abs() < 1e-12 && sum.force[1].abs() < 1e-12);
            assert!((sum.moment[2] - 0.5 * p).abs() < 1e-12);
        }
    }
}

/// A cylinder pulled along its axis: u = p/E (−νr, y), σ_yy = p and no other stress. The axis needs
/// no support.
#[test]
fn a_pulled_cylinder() {
    let p = 3.0;
    for cells in kinds(2) {
        for inner in [0.0, 0.7] {
            let mesh = perturbed_rectangle(Space::Axisymmetric, cells, [inner, 0.0], [6, 5], 0.2);
            let mut supports = Supports::new(mesh.node_count(), 2);
            supports.hold(&mesh.nodes_of_set("y-").unwrap(), 1).unwrap();
            let faces = mesh.faces_of_set("y+").unwrap();
            let load = traction(&mesh, faces, [0.0, p, 0.0]);
            let u = solve(&mesh, &solid(), &supports, &load);
            let exact = |x: [f64; 3]| [-NU * x[0], x[1]].map(|s| s * p / E);
            assert!(error(&mesh, &u, exact) < 1e-13);
            has_stress(&mesh, &solid(), &u, [0.0, p, 0.0, 0.0, 0.0, 0.0]);
            // The reaction is p times the area of the end.
            let forces = internal_forces(&mesh, &solid(), Formulation::Full, &u, None).unwrap();
            let reactions: Vec<f64> = forces.iter().zip(&load).map(|(k, f)| k - f).collect();
            let area = std::f64::consts::PI * ((inner + 1.0).powi(2) - inner * inner);
            let sum = resultant(&mesh, &reactions, [0.0; 3]);
            assert!((sum.force[1] + p * area).abs() < 1e-11);
            assert_eq!((sum.force[0], sum.moment), (0.0, [0.0; 3]));
        }
    }
}

/// A solid cylinder under pressure on its curved face: u = p/E (−(1 − ν)r, 2νy), and
/// σ_rr = σ_θθ = −p.
#[test]
fn a_cylinder_under_radial_pressure() {
    let p = 5.0;
    for cells in kinds(2) {
        let mesh = perturbed_rectangle(Space::Axisymmetric, cells, [0.0, 0.0], [6, 5], 0.2);
        let mut supports = Supports::new(mesh.node_count(), 2);
        supports.hold(&mesh.nodes_of_set("y-").unwrap(), 1).unwrap();
        let load = pressure(&mesh, mesh.faces_of_set("x+").unwrap(), p);
        let u = solve(&mesh, &solid(), &supports, &load);
        let exact = |x: [f64; 3]| [-(1.0 - NU) * x[0], 2.0 * NU * x[1]].map(|s| s * p / E);
        assert!(error(&mesh, &u, exact) < 1e-13);
        has_stress(&mesh, &solid(), &u, [-p, 0.0, -p, 0.0, 0.0, 0.0]);
        // ½ ∫ σ : ε = ½ · 2 · p · (1 − ν)p/E over the volume π.
        let energy = p * p * (1.0 - NU) / E * std::f64::consts::PI;
        let found = stress::strain_energy(&mesh, &solid(), Formulation::Full, &u).unwrap();
        assert!((found - energy).abs() < 1e-12 * energy);
    }
}
