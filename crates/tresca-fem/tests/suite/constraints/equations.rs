//! Lists of equations: chains, and what cannot be.

use super::promises::check;
use crate::common::{perturbed_brick, perturbed_rectangle};
use tresca_fem::FemError;
use tresca_fem::constraints::{Dof, Equation};
use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{CellKind, Space};
use tresca_fem::supports::Supports;

/// Dofs of a body of one component per node, for short.
fn equation(terms: &[(usize, f64)], value: f64) -> Equation {
    let dofs = terms.iter().map(|&(node, a)| (Dof::new(node, 0), a));
    Equation::new(dofs.collect(), value)
}

fn numbered(held: &[(usize, f64)], equations: &[Equation]) -> Result<DofMap, FemError> {
    let mut supports = Supports::new(8, 1);
    for &(node, value) in held {
        supports.prescribe(node, 0, value).unwrap();
    }
    DofMap::constrained(&supports, equations)
}

#[test]
fn chains_are_resolved_in_any_order() {
    // u0 = 2 u1 + 1, u1 = 3 u2 − u3, u2 = u4 + 5, u4 held at 7.
    let list = [
        equation(&[(0, 1.0), (1, -2.0)], 1.0),
        equation(&[(1, -1.0), (2, 3.0), (3, -1.0)], 0.0),
        equation(&[(2, 2.0), (4, -2.0)], 10.0),
    ];
    for order in [
        [0, 1, 2],
        [2, 1, 0],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [0, 2, 1],
    ] {
        let dofs = numbered(&[(4, 7.0)], &order.map(|k| list[k].clone())).unwrap();
        assert_eq!(dofs.free_len(), 4);
        let mut u = vec![0.0; 8];
        u[4] = 7.0;
        dofs.write_free(&[10.0, 0.5, 0.25, 0.125], &mut u);
        assert_eq!(u, [53.0, 26.0, 12.0, 10.0, 7.0, 0.5, 0.25, 0.125]);
        assert_eq!(dofs.expand(&[10.0, 0.0, 0.0, 0.0])[0], -20.0);
        assert_eq!(dofs.row(0).collect::<Vec<_>>(), [(0, -2.0)]);
        // Another value of the held dof: the map does not know it.
        u[4] = 0.0;
        assert_eq!(dofs.offset(&u)[..3], [31.0, 15.0, 5.0]);
        assert!(dofs.moves(0, 0) && !dofs.moves(2, 0) && !dofs.moves(4, 0));
    }
}

#[test]
fn equations_that_refer_to_each_other_are_solved_together() {
    // u0 = 2 u1 + u2, u1 = u0 + u3, so u1 = −u2 − u3, u0 = −u2 − 2 u3.
    let list = [
        equation(&[(0, 1.0), (1, -2.0), (2, -1.0)], 0.0),
        equation(&[(1, 1.0), (0, -1.0), (3, -1.0)], 0.0),
    ];
    let dofs = numbered(&[], &list).unwrap();
    assert_eq!(dofs.row(0).collect::<Vec<_>>(), [(0, -1.0), (1, -2.0)]);
    assert_eq!(dofs.row(1).collect::<Vec<_>>(), [(0, -1.0), (1, -1.0)]);
}

#[test]
fn what_cannot_be_is_said_with_the_dofs() {
    type Held = &'static [(usize, f64)];
    let faults: [(Held, Vec<Equation>, &str); 10] = [
        (
            &[],
            vec![
                equation(&[(0, 1.0), (1, -1.0)], 0.0),
                equation(&[(1, 1.0), (0, -1.0)], 0.0),
            ],
            "equation 1, between component 0 of node 1, component 0 of node 0, says nothing new once \
             equation 0 is put in and supports hold what they hold",
        ),
        (
            &[],
            vec![
                equation(&[(0, 1.0), (1, -1.0)], 0.0),
                equation(&[(1, 1.0), (0, -1.0)], 2.0),
            ],
            "equation 1, between component 0 of node 1, component 0 of node 0, cannot hold once equation 0 \
             is put in and supports hold what they hold: its two sides differ by -2.000e0",
        ),
        (
            &[],
            vec![
                equation(&[(0, 1.0), (1, -1.0)], 0.0),
                equation(&[(1, 1.0), (2, -1.0)], 0.0),
                equation(&[(2, 0.1), (0, -0.1)], 0.0),
            ],
            "equation 2, between component 0 of node 2, component 0 of node 0, says nothing new once \
             equations 0, 1 are put in and supports hold what they hold",
        ),
        (
            &[],
            vec![
                equation(&[(0, 1.0), (1, -1.0), (2, 1.0)], 0.0),
                equation(&[(1, 1.0), (0, -1.0), (3, 1.0)], 0.0),
            ],
            "equation 1, between component 0 of node 1, component 0 of node 0, component 0 of node 3, does \
             not determine component 0 of node 1 any more once equation 0 is put in: they refer to each \
             other in a circle; put another dof first",
        ),
        (
            &[],
            vec![
                equation(&[(0, 1.0), (1, -1.0)], 0.0),
                equation(&[(0, 1.0), (2, -1.0)], 0.0),
            ],
            "equations 0 and 1 are both to determine component 0 of node 0; put another dof first in one \
             of them",
        ),
        (
            &[(0, 0.5)],
            vec![equation(&[(0, 1.0), (1, -1.0)], 0.0)],
            "equation 0 is to determine component 0 of node 0, which a support holds; put another of its \
             dofs first",
        ),
        (
            &[(1, 0.5), (2, 0.5)],
            vec![
                equation(&[(0, 1.0), (1, -1.0)], 0.0),
                equation(&[(3, 1.0), (0, -1.0)], 0.0),
                equation(&[(3, 1.0), (2, -1.0)], 0.25),
            ],
            "equation 2, between component 0 of node 3, component 0 of node 2, cannot hold once equations \
             0, 1 are put in and supports hold what they hold: its two sides differ by -2.500e-1",
        ),
        (
            &[],
            vec![equation(&[], 0.0)],
            "equation 0 is none: it has no dofs",
        ),
        (
            &[],
            vec![equation(&[(3, 1.0), (3, -1.0), (1, 1.0)], 0.0)],
            "equation 0 is none: the coefficient of its dependent dof, the first, is zero",
        ),
        (
            &[],
            vec![equation(&[(3, 1.0), (8, -1.0)], 0.0)],
            "equation 0 is none: it names a dof that the body does not have",
        ),
    ];
    for (held, equations, message) in faults {
        assert_eq!(numbered(held, &equations).unwrap_err().to_string(), message);
    }
    let wrong = |a, b| numbered(&[], &[equation(&[(0, 1.0), (1, a)], b)]).is_err();
    assert!(wrong(f64::NAN, 0.0) && wrong(1.0, f64::INFINITY) && !wrong(1.0, 1.0));
}

#[test]
fn every_promise_is_kept_by_a_list_of_equations() {
    let solid = perturbed_brick([3, 3, 4], 0.1);
    let plane = perturbed_rectangle(Space::Plane, CellKind::Quad4, [0.0, 0.0], [4, 5], 0.1);
    let ring = perturbed_rectangle(Space::Axisymmetric, CellKind::Tri3, [1.0, 0.0], [4, 4], 0.1);
    for mesh in [&solid, &plane, &ring] {
        let d = mesh.dimension();
        let dof = |node: usize, i: usize| Dof::new(node, i % d);
        let list = [
            Equation::new(
                vec![(dof(5, 0), 2.0), (dof(9, 1), -1.0), (dof(9, 0), 0.3)],
                0.0,
            ),
            Equation::new(
                vec![(dof(9, 1), 1.0), (dof(2, 1), -1.0), (dof(7, 1), 0.5)],
                0.2,
            ),
            Equation::new(
                vec![(dof(7, 1), 1.0), (dof(0, 0), -1.0), (dof(11, 1), 4.0)],
                -0.1,
            ),
        ];
        // Free, and with node 0 held, a dof of which is in an equation.
        let mut supports = Supports::new(mesh.node_count(), d);
        check(mesh, &supports, &list);
        supports.prescribe(0, 0, 0.25).unwrap();
        check(mesh, &supports, &list);
        check(mesh, &supports, &list[..1]);
        check(mesh, &supports, &[]);
    }
}
