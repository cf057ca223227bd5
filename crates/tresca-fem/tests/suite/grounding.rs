//! Floating bodies: K K_reg⁻¹ K = K, and K_reg is as well conditioned as a clamped body's K.

use crate::common::{dense, perturbed_brick, perturbed_rectangle};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use tresca_fem::assembly::{Formulation, internal_forces, stiffness};
use tresca_fem::dofs::DofMap;
use tresca_fem::loads::pressure;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, Mesh, Space, brick};
use tresca_fem::rigid::{self, Grounding};
use tresca_fem::supports::Supports;
use tresca_la::SymmetricMatrix;

fn material() -> Isotropic {
    Isotropic::new(2.1e5, 0.3).unwrap()
}

fn full(k: &SymmetricMatrix) -> Mat<f64> {
    let rows = dense(k);
    Mat::from_fn(k.order(), k.order(), |i, j| rows[i][j])
}

fn largest(a: &Mat<f64>) -> f64 {
    (0..a.ncols())
        .flat_map(|j| (0..a.nrows()).map(move |i| a[(i, j)].abs()))
        .fold(0.0, f64::max)
}

/// Of columns with the given numbers of rows.
fn columns(of: &[Vec<f64>], rows: usize) -> Mat<f64> {
    Mat::from_fn(rows, of.len(), |i, j| of[j][i])
}

fn condition(k: &Mat<f64>) -> f64 {
    let eigenvalues = k.self_adjoint_eigenvalues(Side::Lower).unwrap();
    eigenvalues[eigenvalues.len() - 1] / eigenvalues[0]
}

/// The whole list of what a grounding promises, for a body with remaining motions.
/// `held` is a support that leaves no motion, to compare the condition with.
fn check(name: &str, mesh: &Mesh, supports: &Supports, preferred: &[usize], held: &Supports) {
    let material = material();
    let dofs = DofMap::new(supports);
    let n = dofs.free_len();
    let motions = rigid::remaining(mesh, &dofs);
    assert!(!motions.is_empty(), "{name}");
    let stiffness_matrix = stiffness(mesh, &material, Formulation::Full, &dofs).unwrap();
    let grounding = Grounding::new(mesh, &material, &dofs, &motions, preferred);
    let k = full(&stiffness_matrix);
    let k_reg = full(&grounding.add_to(&stiffness_matrix));
    let scale = largest(&k);

    // R is the kernel of K, and C lives on the dofs that it says.
    let r = columns(&grounding.r, n);
    assert!(largest(&(&k * &r)) < 1e-12 * scale, "{name}");
    let mut c = Mat::zeros(n, motions.len());
    for (row, &dof) in grounding.dofs.iter().enumerate() {
        for column in 0..motions.len() {
            c[(dof, column)] = grounding.c[column][row];
        }
    }
    assert!(grounding.dofs.is_sorted(), "{name}");
    assert!(
        largest(&(&k + &c * c.transpose() - &k_reg)) < 1e-14 * scale,
        "{name}"
    );

    // S = (RᵀC CᵀR)⁻¹ is the flexibility of the support: K_reg⁻¹ C = R (CᵀR)⁻¹, so CᵀK_reg⁻¹C = I.
    let s = columns(&grounding.s, motions.len());
    let rc = r.transpose() * &c;
    let identity = &s * (&rc * rc.transpose());
    let unit = Mat::<f64>::identity(motions.len(), motions.len());
    assert!(largest(&(identity - &unit)) < 1e-10, "{name}");
    let llt = k_reg.llt(Side::Lower).unwrap();
    assert!(
        largest(&(c.transpose() * llt.solve(&c) - &unit)) < 1e-9,
        "{name}"
    );

    // The generalised inverse, to rounding.
    let (of_k_reg, of_held) = (
        condition(&k_reg),
        condition(&full(
            &stiffness(mesh, &material, Formulation::Full, &DofMap::new(held)).unwrap(),
        )),
    );
    let back = &k * llt.solve(&k) - &k;
    let error = largest(&back) / scale;
    assert!(error < 1e-14, "{name}: {error:e}");
    assert!(
        of_k_reg < 1e2 * of_held,
        "{name}: condition {of_k_reg:e}, held {of_held:e}"
    );
}

fn held_on(mesh: &Mesh, set: &str) -> Supports {
    let mut supports = Supports::new(mesh.node_count(), mesh.dimension());
    supports.clamp(&mesh.nodes_of_set(set).unwrap()).unwrap();
    supports
}

#[test]
fn a_free_brick() {
    let mesh = perturbed_brick([6, 5, 4], 0.1);
    let free = Supports::new(mesh.node_count(), 3);
    let contact = mesh.nodes_of_set("z+").unwrap();
    check("free", &mesh, &free, &contact, &held_on(&mesh, "z-"));
    // Without preferred nodes some are found.
    check("anywhere", &mesh, &free, &[], &held_on(&mesh, "z-"));
}

#[test]
fn a_brick_that_slides_and_turns() {
    let mesh = perturbed_brick([5, 5, 4], 0.1);
    let mut supports = Supports::new(mesh.node_count(), 3);
    supports.hold(&mesh.nodes_of_set("y-").unwrap(), 1).unwrap();
    let contact = mesh.nodes_of_set("z+").unwrap();
    check("slides", &mesh, &supports, &contact, &held_on(&mesh, "z-"));
    // All preferred nodes are held altogether: none of their dofs is free.
    let mut hinged = Supports::new(mesh.node_count(), 3);
    let edge: Vec<usize> = (0..mesh.node_count())
        .filter(|&a| mesh.points[a][0] == 0.0 && mesh.points[a][2] == 0.0)
        .collect();
    hinged.clamp(&edge).unwrap();
    check("hinged", &mesh, &hinged, &edge, &held_on(&mesh, "z-"));
}

#[test]
fn contact_along_a_line_and_in_a_point_needs_more_nodes() {
    let mesh = perturbed_brick([5, 4, 4], 0.0);
    let free = Supports::new(mesh.node_count(), 3);
    let line: Vec<usize> = (0..mesh.node_count())
        .filter(|&a| mesh.points[a][1] == 0.0 && mesh.points[a][2] == 1.0)
        .collect();
    assert_eq!(line.len(), 5);
    for contact in [&line[..], &line[..1]] {
        check("line", &mesh, &free, contact, &held_on(&mesh, "z-"));
        let dofs = DofMap::new(&free);
        let motions = rigid::remaining(&mesh, &dofs);
        let grounding = Grounding::new(&mesh, &material(), &dofs, &motions, contact);
        let grounded: Vec<usize> = grounding.dofs.iter().map(|dof| dof / 3).collect();
        assert!(contact.iter().all(|node| grounded.contains(node)));
        assert!(grounding.dofs.len() <= 3 * (contact.len() + 3));
    }
}

/// A punch in the middle of a face: the preferred nodes see a rotation about the patch weakly.
#[test]
fn a_small_contact_patch() {
    let mesh = perturbed_brick([9, 9, 4], 0.0);
    let free = Supports::new(mesh.node_count(), 3);
    let patch: Vec<usize> = (0..mesh.node_count())
        .filter(|&a| {
            let [x, y, z] = mesh.points[a];
            z == 1.0 && (x - 0.5).abs() < 0.13 && (y - 0.5).abs() < 0.13
        })
        .collect();
    assert_eq!(patch.len(), 9);
    check("patch", &mesh, &free, &patch, &held_on(&mesh, "z-"));
}

#[test]
fn few_of_many_preferred_nodes_are_taken() {
    let mesh = perturbed_brick([9, 9, 3], 0.0);
    let dofs = DofMap::unsupported(mesh.node_count(), 3);
    let motions = rigid::remaining(&mesh, &dofs);
    let contact = mesh.nodes_of_set("z+").unwrap();
    let grounding = Grounding::new(&mesh, &material(), &dofs, &motions, &contact);
    assert_eq!(grounding.dofs.len(), 3 * 24);
    assert!(
        grounding
            .dofs
            .iter()
            .all(|dof| contact.contains(&(dof / 3)))
    );
    // A unit translation meets 0.1 E × diagonal.
    let translation = grounding.c.iter().map(|c| {
        let along: f64 = c.iter().step_by(3).sum();
        along * along
    });
    let stiffness = 0.1 * material().young() * 3f64.sqrt();
    assert!((translation.sum::<f64>() / stiffness - 1.0).abs() < 1e-12);
}

#[test]
fn two_parts_are_grounded_apart() {
    let mut mesh = brick(&BrickSpec {
        min: [0.0; 3],
        max: [5.0, 1.0, 2.0],
        nodes: [6, 3, 4],
    })
    .unwrap();
    mesh.face_sets.clear();
    // Without the third of five slabs two parts are left.
    let mut cell = 0;
    let kept: Vec<usize> = mesh.cells[0]
        .cells()
        .filter(|_| {
            cell += 1;
            (cell - 1) % 5 != 2
        })
        .flatten()
        .copied()
        .collect();
    mesh.cells[0].connectivity = kept;
    mesh.validate().unwrap();
    assert_eq!(mesh.parts().len(), 2);
    let nodes_at = |z: f64| -> Vec<usize> {
        (0..mesh.node_count())
            .filter(|&a| mesh.points[a][2] == z)
            .collect()
    };
    let mut held = Supports::new(mesh.node_count(), 3);
    held.clamp(&nodes_at(0.0)).unwrap();
    let free = Supports::new(mesh.node_count(), 3);
    check("two parts", &mesh, &free, &nodes_at(2.0), &held);
    // Contact on one part only, the other one resting on rollers.
    let mut rollers = free.clone();
    let of_second: Vec<usize> = nodes_at(0.0)
        .into_iter()
        .filter(|&a| mesh.points[a][0] > 2.5)
        .collect();
    rollers.hold(&of_second, 2).unwrap();
    let of_first: Vec<usize> = nodes_at(2.0)
        .into_iter()
        .filter(|&a| mesh.points[a][0] < 2.5)
        .collect();
    check("one on rollers", &mesh, &rollers, &of_first, &held);

    let dofs = DofMap::new(&rollers);
    let motions = rigid::remaining(&mesh, &dofs);
    assert_eq!(motions.len(), 6 + 3);
    let grounding = Grounding::new(&mesh, &material(), &dofs, &motions, &of_first);
    for (k, l) in [(0, 6), (8, 5)] {
        assert_eq!(grounding.s[k][l], 0.0);
        let both = grounding.c[k].iter().zip(&grounding.c[l]);
        assert!(both.into_iter().all(|(a, b)| a * b == 0.0));
    }
}

#[test]
fn plane_and_axisymmetric_bodies() {
    for cells in [CellKind::Quad4, CellKind::Tri3, CellKind::Quad8] {
        let nodes = if cells.order() == 2 { [5, 4] } else { [8, 7] };
        for space in [Space::Plane, Space::Axisymmetric] {
            let mesh = perturbed_rectangle(space, cells, [0.0, 0.0], nodes, 0.1);
            let free = Supports::new(mesh.node_count(), 2);
            let contact = mesh.nodes_of_set("y+").unwrap();
            let name = format!("{space} {cells}");
            check(&name, &mesh, &free, &contact, &held_on(&mesh, "y-"));
        }
    }
}

#[test]
fn a_body_of_quadratic_tetrahedra() {
    let mesh = perturbed_brick([4, 3, 3], 0.1);
    let mesh = mesh.with_cells(CellKind::Tet10).unwrap();
    let free = Supports::new(mesh.node_count(), 3);
    let contact = mesh.nodes_of_set("z-").unwrap();
    check("tet10", &mesh, &free, &contact, &held_on(&mesh, "x-"));
}

/// A free brick under pressure from all sides: K_reg⁻¹f is an equilibrium, whatever carries C.
#[test]
fn a_load_in_equilibrium_meets_no_support() {
    let mesh = perturbed_brick([4, 5, 4], 0.1);
    let material = material();
    let dofs = DofMap::unsupported(mesh.node_count(), 3);
    let motions = rigid::remaining(&mesh, &dofs);
    let contact = mesh.nodes_of_set("x-").unwrap();
    let k = stiffness(&mesh, &material, Formulation::Full, &dofs).unwrap();
    let grounding = Grounding::new(&mesh, &material, &dofs, &motions, &contact);
    let f = pressure(&mesh, &mesh.boundary_faces(), 10.0);
    let llt = full(&grounding.add_to(&k)).llt(Side::Lower).unwrap();
    let solved = llt.solve(faer::Col::from_fn(f.len(), |i| f[i]));
    let u: Vec<f64> = (0..f.len()).map(|i| solved[i]).collect();
    let forces = internal_forces(&mesh, &material, Formulation::Full, &u, None).unwrap();
    assert!((0..f.len()).all(|i| (forces[i] - f[i]).abs() < 1e-12 * 10.0));
    for stress in tresca_fem::stress::recover(&mesh, &material, Formulation::Full, &u, None) {
        let expected = [-10.0, -10.0, -10.0, 0.0, 0.0, 0.0];
        assert!((0..6).all(|k| (stress[k] - expected[k]).abs() < 1e-10));
    }
}
