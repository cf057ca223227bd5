//! Stiffness and internal forces of every kind, space and formulation against a naive dense assembly.

use crate::common::{dense, kinds, perturbed_brick, perturbed_rectangle};
use faer::linalg::solvers::DenseSolveCore;
use tresca_fem::assembly::{Formulation, internal_forces, stiffness};
use tresca_fem::dofs::DofMap;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{Mesh, Space};
use tresca_fem::stress;

/// Rows xx, yy, zz, γxy, γyz, γxz of B at a point of a cell, by dof of the cell, and the measure there.
type Strain = (Vec<[f64; 6]>, f64);

/// The textbook's B at every point of the stiffness rule.
fn strains(mesh: &Mesh, cell: usize) -> Vec<Strain> {
    let (of, d) = (mesh.cell(cell), mesh.dimension());
    let (element, n) = (of.kind.element(), of.nodes.len());
    let rule = element.rule();
    let x: Vec<[f64; 3]> = of.nodes.iter().map(|&node| mesh.points[node]).collect();
    let at_point = |(&xi, &weight): (&[f64; 3], &f64)| {
        let (mut values, mut gradients) = (vec![0.0; n], vec![[0.0; 3]; n]);
        element.shape(xi, &mut values);
        element.gradients(xi, &mut gradients);
        // J = ∂x/∂ξ; ∇φ = J⁻ᵀ ∂φ/∂ξ by a general solver.
        let j = faer::Mat::from_fn(d, d, |i, k| -> f64 {
            (0..n).map(|a| x[a][i] * gradients[a][k]).sum()
        });
        let inverse = j.partial_piv_lu().inverse();
        let mut measure = weight * j.determinant();
        let radius: f64 = (0..n).map(|a| values[a] * x[a][0]).sum();
        let hoop = mesh.space == Space::Axisymmetric;
        if hoop {
            measure *= 2.0 * std::f64::consts::PI * radius;
        }
        let mut b = Vec::new();
        for a in 0..n {
            let g: Vec<f64> = (0..d)
                .map(|i| (0..d).map(|k| gradients[a][k] * inverse[(k, i)]).sum())
                .collect();
            if d == 3 {
                b.push([g[0], 0.0, 0.0, g[1], 0.0, g[2]]);
                b.push([0.0, g[1], 0.0, g[0], g[2], 0.0]);
                b.push([0.0, 0.0, g[2], 0.0, g[1], g[0]]);
            } else {
                let zz = if hoop { values[a] / radius } else { 0.0 };
                b.push([g[0], 0.0, zz, g[1], 0.0, 0.0]);
                b.push([0.0, g[1], 0.0, g[0], 0.0, 0.0]);
            }
        }
        (b, measure)
    };
    rule.points
        .iter()
        .zip(&rule.weights)
        .map(at_point)
        .collect()
}

/// B̄ = B + ⅓ m (b̄ − b), b = mᵀB the divergence and b̄ its mean over the cell (Hughes 1980).
fn with_mean_dilatation(strains: &mut [Strain]) {
    let volume: f64 = strains.iter().map(|(_, measure)| measure).sum();
    let divergence = |column: &[f64; 6]| column[0] + column[1] + column[2];
    for dof in 0..strains[0].0.len() {
        let points = strains.iter();
        let integral: f64 = points
            .map(|(b, measure)| measure * divergence(&b[dof]))
            .sum();
        for (b, _) in strains.iter_mut() {
            let change = (integral / volume - divergence(&b[dof])) / 3.0;
            b[dof][..3].iter_mut().for_each(|e| *e += change);
        }
    }
}

/// ∫ Bᵀ D B over all cells, dense.
fn naive(mesh: &Mesh, material: &Isotropic, formulation: Formulation) -> Vec<Vec<f64>> {
    let (d, elasticity) = (mesh.dimension(), material.elasticity());
    let mut k = vec![vec![0.0; mesh.dof_count()]; mesh.dof_count()];
    for cell in 0..mesh.cell_count() {
        let mut strains = strains(mesh, cell);
        if formulation == Formulation::BBar {
            with_mean_dilatation(&mut strains);
        }
        let nodes = mesh.cell(cell).nodes;
        for (b, measure) in strains {
            for (c, column) in b.iter().enumerate() {
                let stress = elasticity.map(|row| (0..6).map(|k| row[k] * column[k]).sum::<f64>());
                for (r, row) in b.iter().enumerate() {
                    let entry: f64 = (0..6).map(|k| row[k] * stress[k]).sum();
                    k[d * nodes[r / d] + r % d][d * nodes[c / d] + c % d] += measure * entry;
                }
            }
        }
    }
    k
}

fn check(mesh: &Mesh, material: &Isotropic) {
    let kind = mesh.cells[0].kind;
    for formulation in Formulation::ALL {
        if formulation.check(mesh, material).is_err() {
            continue;
        }
        let reference = naive(mesh, material, formulation);
        let all = reference.iter().flatten();
        let scale = all.fold(0.0_f64, |a, b| a.max(b.abs()));
        let dofs = DofMap::unsupported(mesh.node_count(), mesh.dimension());
        let k = dense(&stiffness(mesh, material, formulation, &dofs).unwrap());
        for (row, expected) in k.iter().zip(&reference) {
            for (found, expected) in row.iter().zip(expected) {
                let error = (found - expected).abs();
                assert!(error < 1e-13 * scale, "{kind} {formulation}: {error:e}");
            }
        }
        let u: Vec<f64> = (0..mesh.dof_count()).map(|i| (i as f64).sin()).collect();
        let forces = internal_forces(mesh, material, formulation, &u, None).unwrap();
        let mut energy = 0.0;
        for (i, row) in reference.iter().enumerate() {
            let expected: f64 = row.iter().zip(&u).map(|(k, u)| k * u).sum();
            assert!(
                (forces[i] - expected).abs() < 1e-12 * scale,
                "{kind} {formulation}"
            );
            energy += 0.5 * u[i] * expected;
        }
        let found = stress::strain_energy(mesh, material, formulation, &u).unwrap();
        assert!((found - energy).abs() < 1e-12 * energy);
    }
}

#[test]
fn solid_kinds_equal_a_naive_dense_assembly() {
    for kind in kinds(3) {
        let mesh = perturbed_brick([3, 3, 3], 0.1).with_cells(kind).unwrap();
        // Curved edges where there are middle nodes.
        let mesh = mesh.mapped(|[x, y, z]| [x + 0.1 * y * y, y, z + 0.1 * x * x]);
        check(&mesh.unwrap(), &Isotropic::new(210.0, 0.3).unwrap());
    }
}

#[test]
fn plane_kinds_equal_a_naive_dense_assembly() {
    let material = Isotropic::new(210.0, 0.4).unwrap();
    for kind in kinds(2) {
        for (space, material) in [
            (Space::Plane, material),
            (Space::Plane, material.plane_stress()),
            (Space::Axisymmetric, material),
        ] {
            let mesh = perturbed_rectangle(space, kind, [0.0, -0.3], [4, 3], 0.1);
            let mesh = mesh.mapped(|[x, y, _]| [x * (1.0 + 0.1 * y * y), y + 0.1 * x * x, 0.0]);
            check(&mesh.unwrap(), &material);
        }
    }
}
