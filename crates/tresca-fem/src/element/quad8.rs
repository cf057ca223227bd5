//! The quadratic serendipity quadrilateral, also the face of [`super::Hex20`].

use super::nodes::with_means;
use super::reference::{Element, ReferenceFace};
use super::{quad4, serendipity};
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, gauss_square};

/// Square [−1, 1]²; corners like [`super::Quad4`]'s, then the middles of the edges 0–1, 1–2, 2–3,
/// 3–0.
#[derive(Clone, Copy, Debug)]
pub struct Quad8;

pub(super) const NODES: [[f64; 3]; 8] =
    with_means(&quad4::NODES, &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]]);

/// The edges of quad8 and quad9.
pub(super) const EDGES: [ReferenceFace; 4] = {
    const fn edge(nodes: &'static [usize]) -> ReferenceFace {
        ReferenceFace {
            kind: CellKind::Line3,
            nodes,
        }
    }
    [
        edge(&[0, 1, 4]),
        edge(&[1, 2, 5]),
        edge(&[2, 3, 6]),
        edge(&[3, 0, 7]),
    ]
};

impl Element for Quad8 {
    fn dimension(&self) -> usize {
        2
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        serendipity::shape::<2>(&NODES, xi, values);
    }

    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        serendipity::gradients::<2>(&NODES, xi, gradients);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        &EDGES
    }

    fn rule(&self) -> Rule {
        gauss_square(3)
    }

    fn stress_points(&self) -> Rule {
        gauss_square(2)
    }
}
