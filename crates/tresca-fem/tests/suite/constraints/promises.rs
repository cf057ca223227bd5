//! What `DofMap` promises of every set of constraints, as one list of checks.

use crate::common::dense;
use faer::Mat;
use tresca_fem::assembly::{Formulation, internal_forces, reduced_load, stiffness};
use tresca_fem::constraints::{Dof, Equation};
use tresca_fem::dofs::DofMap;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::Mesh;
use tresca_fem::rigid;
use tresca_fem::supports::Supports;
use tresca_la::vector::{dot, norm};

/// A vector of fixed irregular numbers between −1 and 1.
pub fn irregular(n: usize) -> Vec<f64> {
    (0..n)
        .map(|i| 2.0 * ((78.233 * i as f64).sin() * 43758.5453).rem_euclid(1.0) - 1.0)
        .collect()
}

fn close(a: &[f64], b: &[f64], tolerance: f64, what: &str) {
    assert_eq!(a.len(), b.len(), "{what}");
    let scale = norm(b).max(1.0);
    for (a, b) in a.iter().zip(b) {
        assert!((a - b).abs() < tolerance * scale, "{what}: {a} against {b}");
    }
}

/// The conformance list: C and its transpose, u⁰, K̂, f̂, the kernel, multipliers and reactions.
pub fn check(mesh: &Mesh, supports: &Supports, equations: &[Equation]) -> DofMap {
    let material = Isotropic::new(3.0, 0.3).unwrap();
    let dofs = DofMap::constrained(supports, equations).unwrap();
    let (full, free) = (dofs.full_len(), dofs.free_len());
    assert_eq!(dofs.has_equations(), !equations.is_empty());
    assert_eq!(dofs.dependent().count(), equations.len());
    assert_eq!(
        full,
        free + equations.len() + dofs.prescribed().count(),
        "every dof is free, held or dependent"
    );

    // Every û gives a u that satisfies supports and equations.
    let reduced = irregular(free);
    let mut u = supports.values();
    dofs.write_free(&reduced, &mut u);
    let satisfied = |u: &[f64], factor: f64| {
        for dof in dofs.prescribed() {
            assert_eq!(u[dof], factor * supports.at(dof).unwrap());
        }
        for equation in equations {
            let terms = equation.terms.iter();
            let parts: Vec<f64> = terms
                .map(|&(dof, a)| a * u[dof.full(dofs.components())])
                .collect();
            let size: f64 = parts.iter().map(|x| x.abs()).sum();
            let excess = parts.iter().sum::<f64>() - factor * equation.value;
            assert!(
                excess.abs() < 1e-12 * size.max(1.0),
                "{equation:?}: {excess:e}"
            );
        }
    };
    satisfied(&u, 1.0);
    // Writing twice changes nothing, and the free part comes back.
    let again = {
        let mut again = u.clone();
        dofs.write_free(&reduced, &mut again);
        again
    };
    assert_eq!(u, again);
    assert_eq!(dofs.free_part(&u), reduced);
    // u = C û + u⁰.
    let (c_u, offset) = (dofs.expand(&reduced), dofs.offset(&supports.values()));
    satisfied(&offset, 1.0);
    let sum: Vec<f64> = c_u.iter().zip(&offset).map(|(a, b)| a + b).collect();
    close(&sum, &u, 1e-13, "C û + u⁰");
    // restrict is the transpose of expand, row by row.
    let force = irregular(full + 7)[7..].to_vec();
    let back = dofs.restrict(&force);
    assert!((dot(&force, &c_u) - dot(&back, &reduced)).abs() < 1e-11 * norm(&force) * norm(&c_u));
    for dof in 0..full {
        let of_row: f64 = dofs.row(dof).map(|(free, c)| c * reduced[free]).sum();
        assert!((of_row - c_u[dof]).abs() < 1e-12 * norm(&c_u));
    }
    let all = force.iter().copied().enumerate();
    let as_row = dofs.restrict_row(all);
    assert!(as_row.windows(2).all(|w| w[0].0 < w[1].0));
    for (free, value) in as_row {
        assert!((value - back[free]).abs() < 1e-12 * norm(&back));
    }

    // K̂ = CᵀKC and f̂ = Cᵀ(f − K u⁰), with K u from the elements.
    let k = stiffness(mesh, &material, Formulation::Full, &dofs).unwrap();
    assert_eq!(k.order(), free);
    let action = |u: &[f64]| {
        let of_mesh = &u[..mesh.dof_count()];
        let mut forces =
            internal_forces(mesh, &material, Formulation::Full, of_mesh, None).unwrap();
        forces.resize(full, 0.0);
        forces
    };
    let mut product = vec![0.0; free];
    k.mul(&reduced, &mut product);
    close(&product, &dofs.restrict(&action(&c_u)), 1e-12, "K̂ û");
    let values = supports.values();
    let of_load = reduced_load(mesh, &material, Formulation::Full, &dofs, &force, &values).unwrap();
    let expected: Vec<f64> = force
        .iter()
        .zip(action(&offset))
        .map(|(f, k)| f - k)
        .collect();
    close(&of_load, &dofs.restrict(&expected), 1e-12, "f̂");

    // The remaining motions are the kernel of K̂, all of it.
    let motions = rigid::remaining(mesh, &dofs);
    for motion in &motions {
        let r = motion.displacement(mesh);
        satisfied_homogeneous(&dofs, equations, &r);
        let reduced = dofs.free_part(&r);
        close(
            &dofs.expand(&reduced),
            &r,
            1e-9,
            "a motion satisfies the equations",
        );
        let mut force = vec![0.0; free];
        k.mul(&reduced, &mut force);
        assert!(norm(&force) < 1e-9 * norm(&reduced), "{motion}");
    }
    let rows = dense(&k);
    let eigenvalues = Mat::from_fn(free, free, |i, j| rows[i][j])
        .self_adjoint_eigenvalues(faer::Side::Lower)
        .unwrap();
    let largest = eigenvalues[free - 1];
    let null = eigenvalues.iter().filter(|&&x| x < 1e-10 * largest).count();
    assert_eq!(motions.len(), null, "{motions:?}");

    // Forces of supports and of equations come apart again.
    let mu = irregular(equations.len() + 3)[3..].to_vec();
    let mut of_equations = vec![0.0; full];
    for (equation, mu) in equations.iter().zip(&mu) {
        for &(dof, a) in &equation.terms {
            of_equations[dof.full(dofs.components())] += mu * a;
        }
    }
    let mut of_supports = vec![0.0; full];
    for (dof, force) in dofs.prescribed().zip(irregular(full)) {
        of_supports[dof] = force;
    }
    let both: Vec<f64> = of_equations
        .iter()
        .zip(&of_supports)
        .map(|(a, b)| a + b)
        .collect();
    close(&dofs.multipliers(&both), &mu, 1e-11, "multipliers");
    close(
        &dofs.support_forces(&both),
        &of_supports,
        1e-11,
        "reactions",
    );
    // They do no work on what the constraints allow.
    assert!(norm(&dofs.restrict(&both)) < 1e-11 * norm(&both).max(1.0));
    dofs
}

fn satisfied_homogeneous(dofs: &DofMap, equations: &[Equation], u: &[f64]) {
    let value = |dof: Dof| u[dof.full(dofs.components())];
    for equation in equations {
        let sum: f64 = equation.terms.iter().map(|&(dof, a)| a * value(dof)).sum();
        assert!(sum.abs() < 1e-9 * norm(u), "{equation:?}: {sum:e}");
    }
    for dof in dofs.prescribed() {
        assert!(u[dof].abs() < 1e-9 * norm(u));
    }
}
