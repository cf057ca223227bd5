//! The bilinear quadrilateral, the face of [`super::Hex8`].

use super::reference::{Element, ReferenceFace};
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, gauss_square};

/// Square [−1, 1]², corners counter-clockwise from (−1, −1).
#[derive(Clone, Copy, Debug)]
pub struct Quad4;

pub(super) const NODES: [[f64; 3]; 4] = [
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
];

impl Element for Quad4 {
    fn dimension(&self) -> usize {
        2
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, [x, y, _]: [f64; 3], values: &mut [f64]) {
        for (value, [a, b, _]) in values.iter_mut().zip(NODES) {
            *value = 0.25 * (1.0 + a * x) * (1.0 + b * y);
        }
    }

    fn gradients(&self, [x, y, _]: [f64; 3], gradients: &mut [[f64; 3]]) {
        for (gradient, [a, b, _]) in gradients.iter_mut().zip(NODES) {
            *gradient = [0.25 * a * (1.0 + b * y), 0.25 * b * (1.0 + a * x), 0.0];
        }
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn edge(nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace {
                kind: CellKind::Line2,
                nodes,
            }
        }
        const EDGES: [ReferenceFace; 4] =
            [edge(&[0, 1]), edge(&[1, 2]), edge(&[2, 3]), edge(&[3, 0])];
        &EDGES
    }

    fn rule(&self) -> Rule {
        gauss_square(2)
    }

    fn stress_points(&self) -> Rule {
        gauss_square(1)
    }
}
