//! Rigid motions of parts that equations couple, and their grounding.

use super::promises::check;
use crate::common::{dense, perturbed_brick, side_by_side};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use tresca_fem::assembly::{Formulation, stiffness};
use tresca_fem::constraints::{Dof, Equation, ReferencePoint, rigid};
use tresca_fem::dofs::DofMap;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::Mesh;
use tresca_fem::rigid::{self as motions, Grounding};
use tresca_fem::supports::Supports;

/// Two cubes, the second one beside the first, with the nodes that meet.
fn two_cubes() -> (Mesh, Vec<[usize; 2]>) {
    let cube = perturbed_brick([3, 3, 3], 0.1);
    let moved = cube.clone().mapped(|[x, y, z]| [x + 1.0, y, z]).unwrap();
    let mesh = side_by_side(&cube, &moved);
    let [left, right] = ["x+", "second x-"].map(|set| mesh.nodes_of_set(set).unwrap());
    let pairs = left.into_iter().zip(right).map(|(a, b)| [b, a]);
    (mesh, pairs.collect())
}

fn tied(pairs: &[[usize; 2]], components: &[usize]) -> Vec<Equation> {
    let tie = |&[a, b]: &[usize; 2]| {
        let component =
            move |&i: &usize| Equation::dependent(Dof::new(a, i), [(Dof::new(b, i), 1.0)]);
        components.iter().map(component).collect::<Vec<_>>()
    };
    pairs.iter().flat_map(tie).collect()
}

/// K K_reg⁻¹ K = K and S = (RᵀC CᵀR)⁻¹.
fn grounded(mesh: &Mesh, supports: &Supports, equations: &[Equation], preferred: &[usize]) {
    let material = Isotropic::new(2.0, 0.3).unwrap();
    let dofs = DofMap::constrained(supports, equations).unwrap();
    let remaining = motions::remaining(mesh, &dofs);
    let k = stiffness(mesh, &material, Formulation::Full, &dofs).unwrap();
    let grounding = Grounding::new(mesh, &material, &dofs, &remaining, preferred);
    let matrix = |k: &tresca_la::SymmetricMatrix| {
        let rows = dense(k);
        Mat::from_fn(k.order(), k.order(), |i, j| rows[i][j])
    };
    let largest = |a: &Mat<f64>| a.norm_max();
    let (regular, k) = (matrix(&grounding.add_to(&k)), matrix(&k));
    let llt = regular.llt(Side::Lower).unwrap();
    let back = &k * llt.solve(&k) - &k;
    assert!(largest(&back) < 1e-12 * largest(&k), "{:e}", largest(&back));
    let r = Mat::from_fn(dofs.free_len(), remaining.len(), |i, j| grounding.r[j][i]);
    let mut c = Mat::zeros(dofs.free_len(), remaining.len());
    for (row, &dof) in grounding.dofs.iter().enumerate() {
        for column in 0..remaining.len() {
            c[(dof, column)] = grounding.c[column][row];
        }
    }
    let s = Mat::from_fn(remaining.len(), remaining.len(), |i, j| grounding.s[i][j]);
    let rc = r.transpose() * &c;
    let unit = Mat::<f64>::identity(remaining.len(), remaining.len());
    assert!(largest(&(s * (&rc * rc.transpose()) - unit)) < 1e-9);
}

#[test]
fn tied_parts_move_as_one_and_hinges_and_sliders_leave_more() {
    let (mesh, pairs) = two_cubes();
    let free = Supports::new(mesh.node_count(), 3);
    let hinge: Vec<[usize; 2]> = pairs
        .iter()
        .copied()
        .filter(|&[a, _]| mesh.points[a][1] == 0.0)
        .collect();
    // All tied; along an edge, about which they turn; in x alone, so that they slide in y and z and about x.
    let cases = [
        (tied(&pairs, &[0, 1, 2]), 6),
        (tied(&hinge, &[0, 1, 2]), 7),
        (tied(&pairs, &[0]), 9),
        (tied(&pairs[..1], &[0, 1, 2]), 9),
    ];
    let preferred = mesh.nodes_of_set("second x+").unwrap();
    for (equations, count) in cases {
        // The edge's three nodes hold its direction thrice; the list has only what is independent.
        let dofs = check(&mesh, &free, &equations);
        let remaining = motions::remaining(&mesh, &dofs);
        assert_eq!(remaining.len(), count);
        assert!(
            remaining
                .iter()
                .all(|motion| motion.nodes().len() == mesh.node_count())
        );
        for preferred in [&preferred[..], &[]] {
            grounded(&mesh, &free, &equations, preferred);
        }
    }
    // One part held: what the hinge leaves of the other.
    let mut supports = free;
    supports.clamp(&mesh.nodes_of_set("x-").unwrap()).unwrap();
    let dofs = check(&mesh, &supports, &tied(&hinge, &[0, 1, 2]));
    let remaining = motions::remaining(&mesh, &dofs);
    assert_eq!(remaining.len(), 1);
    let words = remaining[0].to_string();
    assert!(words.starts_with("rotation about (0, 0, "), "{words}");
    assert!(words.ends_with(" of part 2 of 2"), "{words}");
    grounded(&mesh, &supports, &tied(&hinge, &[0, 1, 2]), &[]);
}

#[test]
fn a_point_that_strains_nothing_is_a_motion_too() {
    let mesh = perturbed_brick([3, 3, 3], 0.1);
    let point = ReferencePoint::new([0.0, 0.0, 2.0], mesh.node_count());
    let mut supports = Supports::new(mesh.node_count() + ReferencePoint::NODES, 3);
    // A line of nodes does not see the rotation of the point about itself.
    let line: Vec<usize> = (0..mesh.node_count())
        .filter(|&n| mesh.points[n][0] == 0.0 && mesh.points[n][1] == 0.0)
        .collect();
    let equations = rigid(&mesh, &line, &point).unwrap();
    let dofs = check(&mesh, &supports, &equations);
    assert_eq!(motions::remaining(&mesh, &dofs).len(), 7);
    grounded(&mesh, &supports, &equations, &[]);
    // Held but for that one.
    supports.clamp(&mesh.nodes_of_set("x+").unwrap()).unwrap();
    let dofs = check(&mesh, &supports, &equations);
    let remaining = motions::remaining(&mesh, &dofs);
    assert_eq!(
        remaining[0].to_string(),
        "motion of a reference point that strains nothing"
    );
    grounded(&mesh, &supports, &equations, &[]);
    supports.clamp(&[point.rotation]).unwrap();
    check(&mesh, &supports, &equations);
}
