//! Nodes coupled to a point: a beam bent by its end, statics of distributed forces.

use super::bodies::solve;
use super::promises::{check, irregular};
use crate::common::{perturbed_brick, perturbed_rectangle};
use tresca_fem::assembly::{Formulation, stiffness};
use tresca_fem::constraints::{ReferencePoint, distributing, rigid};
use tresca_fem::dofs::DofMap;
use tresca_fem::loads::resultant;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, Mesh, RectangleSpec, Space, brick, rectangle};
use tresca_fem::rigid::RigidMotion;
use tresca_fem::supports::Supports;
use tresca_la::vector::dot;

fn beam() -> Mesh {
    let spec = BrickSpec {
        min: [0.0, -0.5, -0.25],
        max: [4.0, 0.5, 0.25],
        nodes: [4, 2, 2],
    };
    brick(&spec).unwrap().with_cells(CellKind::Hex20).unwrap()
}

/// Bernoulli: a beam of ν = 0 under moments at its end bends in a parabola, which quadratic cells represent.
#[test]
fn a_beam_is_bent_and_stretched_by_its_rigid_end() {
    let young = 50.0;
    let material = Isotropic::new(young, 0.0).unwrap();
    let mesh = beam();
    // Off the axis: a force makes a moment about it.
    let point = ReferencePoint::new([4.0, 0.3, -0.2], mesh.node_count());
    let end = rigid(&mesh, &mesh.nodes_of_set("x+").unwrap(), &point).unwrap();
    let mut supports = Supports::new(mesh.node_count() + ReferencePoint::NODES, 3);
    supports.clamp(&mesh.nodes_of_set("x-").unwrap()).unwrap();
    let (shift, turn) = (3 * point.displacement, 3 * point.rotation);
    let mut load = vec![0.0; shift + 6];
    let (force, about_y, about_z) = (2.0, 0.03, -0.07);
    load[shift] = force;
    (load[turn + 1], load[turn + 2]) = (about_y, about_z);
    let (dofs, u, forces) = solve(&mesh, &material, (&supports, &end), &load);

    // About the centre of the section: M = M_P + r × F.
    let (m_y, m_z) = (about_y + -0.2 * force, about_z - 0.3 * force);
    let (i_y, i_z) = (0.5_f64.powi(3) / 12.0, 0.5 / 12.0);
    let (k_y, k_z) = (m_y / (young * i_y), m_z / (young * i_z));
    let axial = force / (young * 0.5);
    for (node, &[x, y, z]) in mesh.points.iter().enumerate() {
        let expected = [
            axial * x + k_y * x * z - k_z * x * y,
            0.5 * k_z * x * x,
            -0.5 * k_y * x * x,
        ];
        for i in 0..3 {
            let error = (u[3 * node + i] - expected[i]).abs();
            assert!(error < 1e-10, "node {node}: {error:e}");
        }
    }
    assert!((u[turn + 1] - 4.0 * k_y).abs() < 1e-10 && (u[turn + 2] - 4.0 * k_z).abs() < 1e-10);
    // The equations bring the load to the end; at the reference point they take it up.
    assert!((forces[shift] + force).abs() < 1e-10);
    let reactions = dofs.support_forces(&forces);
    let sum = resultant(&mesh, &reactions[..mesh.dof_count()], [4.0, 0.0, 0.0]);
    assert!((sum.force[0] + force).abs() < 1e-10);
    assert!((sum.moment[1] + m_y).abs() < 1e-10 && (sum.moment[2] + m_z).abs() < 1e-11);
    // The work of the load is twice the energy, F²L/EA + …, of the closed form.
    let twice = 4.0 * (force * axial + m_y * k_y + m_z * k_z);
    assert!((dot(&load, &u) - twice).abs() < 1e-10);
}

fn bodies() -> [Mesh; 3] {
    [
        perturbed_brick([3, 3, 3], 0.1),
        perturbed_rectangle(Space::Plane, CellKind::Tri3, [0.0, 0.0], [4, 4], 0.1),
        perturbed_rectangle(
            Space::Axisymmetric,
            CellKind::Quad4,
            [0.5, 0.0],
            [4, 4],
            0.1,
        ),
    ]
}

fn held(mesh: &Mesh, point: &ReferencePoint) -> Supports {
    let mut supports = Supports::new(mesh.node_count() + ReferencePoint::NODES, mesh.dimension());
    point.hold_unused(&mut supports, mesh.space).unwrap();
    supports
}

#[test]
fn every_promise_is_kept_by_couplings() {
    for mesh in bodies() {
        let point = ReferencePoint::new([0.7, 1.5, 0.0], mesh.node_count());
        let nodes = mesh.nodes_of_set("y+").unwrap();
        let weighted: Vec<(usize, f64)> = nodes
            .iter()
            .zip(1..)
            .map(|(&n, w)| (n, f64::from(w)))
            .collect();
        let mut supports = held(&mesh, &point);
        for equations in [
            rigid(&mesh, &nodes, &point).unwrap(),
            distributing(&mesh, &weighted, &point).unwrap(),
        ] {
            check(&mesh, &supports, &equations);
        }
        // A point of another number of nodes in between, and the body held at the point alone.
        supports.prescribe(point.displacement, 1, 0.1).unwrap();
        check(&mesh, &supports, &rigid(&mesh, &nodes, &point).unwrap());
    }
}

#[test]
fn a_distributing_point_follows_rigid_motions_and_hands_on_forces_as_statics_asks() {
    for mesh in bodies() {
        let d = mesh.dimension();
        let position = [0.7, 1.5, if d == 3 { -0.4 } else { 0.0 }];
        let point = ReferencePoint::new(position, mesh.node_count());
        let weights = irregular(mesh.node_count()).into_iter().map(|w| 1.5 + w);
        let nodes: Vec<(usize, f64)> = (0..mesh.node_count()).zip(weights).collect();
        let equations = distributing(&mesh, &nodes, &point).unwrap();
        let dofs = DofMap::constrained(&held(&mesh, &point), &equations).unwrap();
        // Nothing of the body is constrained, or any stiffer.
        let material = Isotropic::new(2.0, 0.2).unwrap();
        let k = |dofs: &DofMap| stiffness(&mesh, &material, Formulation::Full, dofs).unwrap();
        let (with, without) = (k(&dofs), k(&DofMap::unsupported(mesh.node_count(), d)));
        assert_eq!(with.lower().val(), without.lower().val());

        let motion = match mesh.space {
            Space::Solid => ([0.1, -0.2, 0.3], [0.3, 0.2, -0.5]),
            Space::Plane => ([0.1, -0.2, 0.0], [0.0, 0.0, -0.5]),
            Space::Axisymmetric => ([0.0, -0.2, 0.0], [0.0; 3]),
        };
        let motion = RigidMotion {
            translation: motion.0,
            rotation: motion.1,
            center: [0.3, 0.1, 0.2],
        };
        let u = dofs.expand(&motion.displacement(&mesh));
        let moved = motion.at(position);
        for i in 0..d {
            assert!((u[d * point.displacement + i] - moved[i]).abs() < 1e-13);
        }
        let rotation = if d == 3 {
            motion.rotation
        } else {
            [motion.rotation[2], 0.0, 0.0]
        };
        for i in 0..d {
            assert!((u[d * point.rotation + i] - rotation[i]).abs() < 1e-13);
        }

        let mut load = vec![0.0; dofs.full_len()];
        let (force, moment) = ([0.6, -1.0, 0.8], [0.2, 0.5, -0.7]);
        for i in 0..d {
            load[d * point.displacement + i] = force[i];
            load[d * point.rotation + i] = moment[i];
        }
        let sum = resultant(&mesh, &dofs.restrict(&load), position);
        match mesh.space {
            Space::Solid => (0..3).for_each(|i| {
                assert!((sum.force[i] - force[i]).abs() < 1e-13);
                assert!((sum.moment[i] - moment[i]).abs() < 1e-13);
            }),
            Space::Plane => {
                (0..2).for_each(|i| assert!((sum.force[i] - force[i]).abs() < 1e-13));
                assert!((sum.moment[2] - moment[0]).abs() < 1e-13);
            }
            Space::Axisymmetric => assert!((sum.force[1] - force[1]).abs() < 1e-13),
        }
    }
}

#[test]
fn couplings_that_cannot_be_are_refused() {
    let mesh = beam();
    let point = ReferencePoint::new([0.0; 3], mesh.node_count());
    let says = |error: tresca_fem::FemError, part: &str| {
        assert!(error.to_string().contains(part), "{error}");
    };
    says(rigid(&mesh, &[], &point).unwrap_err(), "at least one node");
    says(
        rigid(&mesh, &[mesh.node_count()], &point).unwrap_err(),
        "not in the mesh",
    );
    let line: Vec<(usize, f64)> = (0..mesh.node_count())
        .filter(|&n| mesh.points[n][1] == 0.5 && mesh.points[n][2] == 0.25)
        .map(|n| (n, 1.0))
        .collect();
    assert!(line.len() > 2);
    says(
        distributing(&mesh, &line, &point).unwrap_err(),
        "lie on a line",
    );
    says(
        distributing(&mesh, &[(0, 0.0)], &point).unwrap_err(),
        "positive weights",
    );
    let flat = rectangle(&RectangleSpec {
        space: Space::Plane,
        min: [0.0; 2],
        max: [1.0; 2],
        nodes: [2; 2],
        cells: CellKind::Quad4,
    })
    .unwrap();
    let point = ReferencePoint::new([0.0; 3], 4);
    says(
        distributing(&flat, &[(1, 1.0)], &point).unwrap_err(),
        "in a point",
    );
}
