//! The assembled stiffness against a naive dense assembly, and its invariants.

use crate::common::{dense, perturbed_brick};
use tresca_fem::assembly::{Formulation, internal_forces, reduced_load, stiffness};
use tresca_fem::dofs::DofMap;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{CellBlock, CellKind, Mesh, RectangleSpec, Space, rectangle};
use tresca_fem::supports::Supports;
use tresca_fem::{FemError, rigid, stress};

/// Element stiffness by the textbook formula ∫ Bᵀ D B with an 8×8 Gauss-point loop of its own.
fn naive_element(x: &[[f64; 3]; 8], d: &[[f64; 6]; 6]) -> [[f64; 24]; 24] {
    const SIGN: [[f64; 3]; 8] = [
        [-1.0, -1.0, -1.0],
        [1.0, -1.0, -1.0],
        [1.0, 1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
        [1.0, -1.0, 1.0],
        [1.0, 1.0, 1.0],
        [-1.0, 1.0, 1.0],
    ];
    let mut k = [[0.0; 24]; 24];
    for gauss in SIGN {
        let xi = gauss.map(|s| s / 3f64.sqrt());
        let dn: Vec<[f64; 3]> = SIGN
            .iter()
            .map(|s| {
                let f: Vec<f64> = (0..3).map(|i| 1.0 + s[i] * xi[i]).collect();
                [
                    s[0] * f[1] * f[2] / 8.0,
                    f[0] * s[1] * f[2] / 8.0,
                    f[0] * f[1] * s[2] / 8.0,
                ]
            })
            .collect();
        // J[i][j] = ∂x_j/∂ξ_i, inverted by cofactors.
        let j: [[f64; 3]; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|c| (0..8).map(|a| dn[a][i] * x[a][c]).sum())
        });
        let cofactor = |r: usize, c: usize| {
            let (r1, r2, c1, c2) = ((r + 1) % 3, (r + 2) % 3, (c + 1) % 3, (c + 2) % 3);
            j[r1][c1] * j[r2][c2] - j[r1][c2] * j[r2][c1]
        };
        let det: f64 = (0..3).map(|c| j[0][c] * cofactor(0, c)).sum();
        let mut b = [[0.0; 24]; 6];
        for a in 0..8 {
            let g: Vec<f64> = (0..3)
                .map(|c| (0..3).map(|i| cofactor(i, c) / det * dn[a][i]).sum())
                .collect();
            for i in 0..3 {
                b[i][3 * a + i] = g[i];
            }
            (b[3][3 * a], b[3][3 * a + 1]) = (g[1], g[0]);
            (b[4][3 * a + 1], b[4][3 * a + 2]) = (g[2], g[1]);
            (b[5][3 * a], b[5][3 * a + 2]) = (g[2], g[0]);
        }
        for r in 0..24 {
            for c in 0..24 {
                for p in 0..6 {
                    for q in 0..6 {
                        k[r][c] += det * b[p][r] * d[p][q] * b[q][c];
                    }
                }
            }
        }
    }
    k
}

fn naive(mesh: &Mesh, material: &Isotropic) -> Vec<Vec<f64>> {
    let mut k = vec![vec![0.0; mesh.dof_count()]; mesh.dof_count()];
    for cell in mesh.iter_cells() {
        let points = std::array::from_fn(|a| mesh.points[cell.nodes[a]]);
        let element = naive_element(&points, &material.elasticity());
        for (r, row) in element.iter().enumerate() {
            for (c, value) in row.iter().enumerate() {
                k[3 * cell.nodes[r / 3] + r % 3][3 * cell.nodes[c / 3] + c % 3] += value;
            }
        }
    }
    k
}

fn some_supports(mesh: &Mesh) -> Supports {
    let mut supports = Supports::new(mesh.node_count(), 3);
    supports.clamp(&mesh.nodes_of_set("x-").unwrap()).unwrap();
    supports.hold(&mesh.nodes_of_set("y+").unwrap(), 1).unwrap();
    supports.prescribe(mesh.node_count() - 1, 2, 0.01).unwrap();
    supports
}

#[test]
fn equals_a_naive_dense_assembly() {
    let mesh = perturbed_brick([4, 3, 3], 0.15);
    let material = Isotropic::new(210.0, 0.3).unwrap();
    let reference = naive(&mesh, &material);
    let scale = reference
        .iter()
        .flatten()
        .fold(0.0_f64, |a, b| a.max(b.abs()));
    for supports in [Supports::new(mesh.node_count(), 3), some_supports(&mesh)] {
        let dofs = DofMap::new(&supports);
        let k = dense(&stiffness(&mesh, &material, Formulation::Full, &dofs).unwrap());
        for r in 0..dofs.free_len() {
            for c in 0..dofs.free_len() {
                let expected = reference[dofs.full_of_free(r)][dofs.full_of_free(c)];
                assert!((k[r][c] - expected).abs() < 1e-14 * scale, "entry {r}, {c}");
            }
        }
    }
}

#[test]
fn the_pattern_is_exactly_the_nodes_that_share_a_cell() {
    let mesh = perturbed_brick([3, 4, 3], 0.1);
    let dofs = DofMap::new(&some_supports(&mesh));
    let k = stiffness(
        &mesh,
        &Isotropic::new(1.0, 0.2).unwrap(),
        Formulation::Full,
        &dofs,
    )
    .unwrap();
    for c in 0..dofs.free_len() {
        let node = dofs.full_of_free(c) / 3;
        let expected: Vec<usize> = (c..dofs.free_len())
            .filter(|&r| {
                let other = dofs.full_of_free(r) / 3;
                mesh.iter_cells()
                    .any(|cell| cell.nodes.contains(&node) && cell.nodes.contains(&other))
            })
            .collect();
        assert_eq!(k.lower().row_idx_of_col(c).collect::<Vec<_>>(), expected);
    }
}

#[test]
fn several_blocks_give_the_matrix_of_one() {
    let mesh = perturbed_brick([4, 3, 3], 0.1);
    let mut split = mesh.clone();
    let tail = split.cells[0].connectivity.split_off(5 * 8);
    split.cells.push(CellBlock {
        kind: CellKind::Hex8,
        connectivity: tail,
    });
    let material = Isotropic::new(7.0, 0.1).unwrap();
    let dofs = DofMap::new(&some_supports(&mesh));
    let one = stiffness(&mesh, &material, Formulation::Full, &dofs).unwrap();
    let two = stiffness(&split, &material, Formulation::Full, &dofs).unwrap();
    assert_eq!(one.lower().val(), two.lower().val());
    let u: Vec<f64> = (0..mesh.dof_count()).map(|i| (i as f64).cos()).collect();
    assert_eq!(
        internal_forces(&mesh, &material, Formulation::Full, &u, None).unwrap(),
        internal_forces(&split, &material, Formulation::Full, &u, None).unwrap()
    );
}

#[test]
fn free_bodies_have_six_zero_energy_modes_and_no_more() {
    let mesh = perturbed_brick([3, 3, 3], 0.1);
    let material = Isotropic::new(3.0, 0.3).unwrap();
    let dofs = DofMap::unsupported(mesh.node_count(), 3);
    let k = stiffness(&mesh, &material, Formulation::Full, &dofs).unwrap();
    let motions = rigid::motions(&mesh, &mesh.parts()[0]);
    assert_eq!(motions.len(), 6);
    let mut forces = vec![0.0; mesh.dof_count()];
    for motion in &motions {
        let u = motion.displacement(&mesh);
        k.mul(&u, &mut forces);
        assert!(forces.iter().all(|f| f.abs() < 1e-13), "{motion}");
        assert!(
            stress::strain_energy(&mesh, &material, Formulation::Full, &u)
                .unwrap()
                .abs()
                < 1e-13
        );
    }
    let n = k.order();
    let full = dense(&k);
    let matrix = faer::Mat::from_fn(n, n, |i, j| full[i][j]);
    let eigenvalues = matrix.self_adjoint_eigenvalues(faer::Side::Lower).unwrap();
    let largest = eigenvalues[n - 1];
    assert!(
        eigenvalues[..6].iter().all(|x| x.abs() < 1e-13 * largest),
        "{:?}",
        &eigenvalues[..7]
    );
    assert!(eigenvalues[6] > 1e-4 * largest, "{:?}", &eigenvalues[..7]);
}

#[test]
fn threads_do_not_change_a_bit() {
    for kind in [CellKind::Hex8, CellKind::Tet10] {
        let mesh = perturbed_brick([7, 6, 5], 0.1);
        threads_do_not_change(&mesh.with_cells(kind).unwrap());
    }
}

fn threads_do_not_change(mesh: &Mesh) {
    let material = Isotropic::new(5e4, 0.35).unwrap();
    let dofs = DofMap::new(&some_supports(mesh));
    let u: Vec<f64> = (0..mesh.dof_count())
        .map(|i| (0.1 * i as f64).sin())
        .collect();
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            let k = stiffness(mesh, &material, Formulation::Full, &dofs).unwrap();
            let forces = internal_forces(mesh, &material, Formulation::Full, &u, None).unwrap();
            let stresses = stress::recover(mesh, &material, Formulation::Full, &u, None);
            (
                k.lower().col_ptr().to_vec(),
                k.lower().row_idx().to_vec(),
                k.lower().val().to_vec(),
                forces,
                stresses,
            )
        })
    };
    let one = run(1);
    for threads in [2, 3] {
        assert!(one == run(threads), "{threads} threads differ from one");
    }
}

#[test]
fn internal_forces_are_the_action_of_the_whole_matrix() {
    let mesh = perturbed_brick([4, 4, 3], 0.12);
    let material = Isotropic::new(11.0, 0.4).unwrap();
    let k = stiffness(
        &mesh,
        &material,
        Formulation::Full,
        &DofMap::unsupported(mesh.node_count(), 3),
    )
    .unwrap();
    let u: Vec<f64> = (0..mesh.dof_count()).map(|i| (i as f64).sin()).collect();
    let mut expected = vec![0.0; u.len()];
    k.mul(&u, &mut expected);
    let forces = internal_forces(&mesh, &material, Formulation::Full, &u, None).unwrap();
    let scale = expected.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    assert!(
        forces
            .iter()
            .zip(&expected)
            .all(|(a, b)| (a - b).abs() < 1e-14 * scale)
    );

    // f_f − K_fc u_c from the dense matrix.
    let supports = some_supports(&mesh);
    let dofs = DofMap::new(&supports);
    let load: Vec<f64> = (0..u.len()).map(|i| i as f64).collect();
    let reduced = reduced_load(
        &mesh,
        &material,
        Formulation::Full,
        &dofs,
        &load,
        &supports.values(),
    )
    .unwrap();
    let full = dense(&k);
    for (free, value) in reduced.iter().enumerate() {
        let row = dofs.full_of_free(free);
        let moved: f64 = dofs
            .prescribed()
            .map(|c| full[row][c] * supports.values()[c])
            .sum();
        assert!((value - (load[row] - moved)).abs() < 1e-12);
    }
}

#[test]
fn bad_cells_and_spaces_are_named() {
    let material = Isotropic::new(1.0, 0.3).unwrap();
    let mut mesh = perturbed_brick([4, 4, 4], 0.1);
    let dofs = DofMap::unsupported(mesh.node_count(), 3);
    // Turn two cells inside out; the lower one must be named.
    for cell in [20, 13] {
        mesh.cells[0].connectivity[8 * cell..8 * cell + 8].rotate_left(4);
    }
    let u = vec![0.0; mesh.dof_count()];
    for error in [
        stiffness(&mesh, &material, Formulation::Full, &dofs).unwrap_err(),
        internal_forces(&mesh, &material, Formulation::Full, &u, None).unwrap_err(),
    ] {
        match error {
            FemError::InvertedCell {
                cell: 13,
                determinant,
                ..
            } => assert!(determinant < 0.0),
            other => panic!("{other}"),
        }
    }
    assert!(
        stiffness(&mesh, &material, Formulation::Full, &dofs)
            .unwrap_err()
            .to_string()
            .starts_with("cell 13, around (")
    );

    let mut flat = perturbed_brick([3, 3, 3], 0.0);
    for point in &mut flat.points {
        point[2] = 0.5 * point[0] + 0.25 * point[1];
    }
    let dofs = DofMap::unsupported(flat.node_count(), 3);
    let error = stiffness(&flat, &material, Formulation::Full, &dofs).unwrap_err();
    assert!(
        matches!(error, FemError::DegenerateCell { cell: 0, .. }),
        "{error}"
    );

    let tube = rectangle(&RectangleSpec {
        space: Space::Axisymmetric,
        min: [1.0, 0.0],
        max: [2.0, 1.0],
        nodes: [2, 2],
        cells: CellKind::Quad4,
    })
    .unwrap();
    let error = stiffness(
        &tube,
        &material.plane_stress(),
        Formulation::Full,
        &DofMap::unsupported(4, 2),
    )
    .unwrap_err();
    assert_eq!(
        error,
        FemError::PlaneStress {
            space: Space::Axisymmetric
        }
    );
}

#[test]
fn a_body_without_free_dofs_has_an_empty_matrix() {
    let mesh = perturbed_brick([2, 2, 2], 0.0);
    let mut supports = Supports::new(8, 3);
    supports.clamp(&[0, 1, 2, 3, 4, 5, 6, 7]).unwrap();
    let k = stiffness(
        &mesh,
        &Isotropic::new(1.0, 0.3).unwrap(),
        Formulation::Full,
        &DofMap::new(&supports),
    )
    .unwrap();
    assert_eq!(k.order(), 0);
}
