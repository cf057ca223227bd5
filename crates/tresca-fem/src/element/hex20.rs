//! The quadratic serendipity hexahedron.

use super::nodes::with_means;
use super::reference::{Element, ReferenceFace};
use super::{hex8, serendipity};
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, gauss_cube};

/// Cube [−1, 1]³; corners and faces like [`super::Hex8`]'s, then the middles of the bottom's edges
/// 0–1, 1–2, 2–3, 3–0, of the top's 4–5, 5–6, 6–7, 7–4, and of the upright ones 0–4, 1–5, 2–6, 3–7.
#[derive(Clone, Copy, Debug)]
pub struct Hex20;

pub(super) const NODES: [[f64; 3]; 20] = with_means(&hex8::NODES, &EDGES);

/// The edges by their corners.
const EDGES: [&[usize]; 12] = [
    &[0, 1],
    &[1, 2],
    &[2, 3],
    &[3, 0],
    &[4, 5],
    &[5, 6],
    &[6, 7],
    &[7, 4],
    &[0, 4],
    &[1, 5],
    &[2, 6],
    &[3, 7],
];

impl Element for Hex20 {
    fn dimension(&self) -> usize {
        3
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        serendipity::shape::<3>(&NODES, xi, values);
    }

    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        serendipity::gradients::<3>(&NODES, xi, gradients);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn face(nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace {
                kind: CellKind::Quad8,
                nodes,
            }
        }
        const FACES: [ReferenceFace; 6] = [
            face(&[0, 4, 7, 3, 16, 15, 19, 11]),
            face(&[1, 2, 6, 5, 9, 18, 13, 17]),
            face(&[0, 1, 5, 4, 8, 17, 12, 16]),
            face(&[3, 7, 6, 2, 19, 14, 18, 10]),
            face(&[0, 3, 2, 1, 11, 10, 9, 8]),
            face(&[4, 5, 6, 7, 12, 13, 14, 15]),
        ];
        &FACES
    }

    fn rule(&self) -> Rule {
        gauss_cube(3)
    }

    fn stress_points(&self) -> Rule {
        gauss_cube(2)
    }
}
