//! The quadratic triangle, also the face of [`super::Tet10`].

use super::nodes::with_means;
use super::reference::{Element, ReferenceFace};
use super::simplex::{quadratic_gradients, quadratic_shape};
use super::tri3;
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, triangle};

/// Triangle ξ, η ≥ 0, ξ + η ≤ 1; corners like [`super::Tri3`]'s, then the middles of the edges 0–1,
/// 1–2, 2–0.
#[derive(Clone, Copy, Debug)]
pub struct Tri6;

const EDGES: [&[usize]; 3] = [&[0, 1], &[1, 2], &[2, 0]];

const NODES: [[f64; 3]; 6] = with_means(&tri3::NODES, &EDGES);

impl Element for Tri6 {
    fn dimension(&self) -> usize {
        2
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        quadratic_shape::<3>(&EDGES, xi, values);
    }

    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        quadratic_gradients::<3>(&EDGES, xi, gradients);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn edge(nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace {
                kind: CellKind::Line3,
                nodes,
            }
        }
        const FACES: [ReferenceFace; 3] = [edge(&[0, 1, 3]), edge(&[1, 2, 4]), edge(&[2, 0, 5])];
        &FACES
    }

    fn rule(&self) -> Rule {
        triangle(2)
    }

    fn mass_rule(&self) -> Rule {
        triangle(4)
    }

    fn stress_points(&self) -> Rule {
        triangle(2)
    }
}
