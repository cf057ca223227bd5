//! The quadratic tetrahedron.

use super::nodes::with_means;
use super::reference::{Element, ReferenceFace};
use super::simplex::{quadratic_gradients, quadratic_shape};
use super::tet4;
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, tetrahedron};

/// Tetrahedron ξ, η, ζ ≥ 0, ξ + η + ζ ≤ 1; corners and faces like [`super::Tet4`]'s, then the middles
/// of the edges 0–1, 1–2, 2–0, 0–3, 1–3, 2–3.
#[derive(Clone, Copy, Debug)]
pub struct Tet10;

const EDGES: [&[usize]; 6] = [&[0, 1], &[1, 2], &[2, 0], &[0, 3], &[1, 3], &[2, 3]];

const NODES: [[f64; 3]; 10] = with_means(&tet4::NODES, &EDGES);

impl Element for Tet10 {
    fn dimension(&self) -> usize {
        3
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        quadratic_shape::<4>(&EDGES, xi, values);
    }

    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        quadratic_gradients::<4>(&EDGES, xi, gradients);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn face(nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace {
                kind: CellKind::Tri6,
                nodes,
            }
        }
        const FACES: [ReferenceFace; 4] = [
            face(&[0, 1, 3, 4, 8, 7]),
            face(&[1, 2, 3, 5, 9, 8]),
            face(&[2, 0, 3, 6, 7, 9]),
            face(&[0, 2, 1, 6, 5, 4]),
        ];
        &FACES
    }

    // Four points, not the fourteen of the mass matrix: exact on straight cells, of full order on
    // curved ones, and what makes tet10 affordable.
    fn rule(&self) -> Rule {
        tetrahedron(2)
    }

    fn mass_rule(&self) -> Rule {
        tetrahedron(4)
    }

    fn stress_points(&self) -> Rule {
        tetrahedron(2)
    }
}
