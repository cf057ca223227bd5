//! The linear triangle.

use super::reference::{Element, ReferenceFace};
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, triangle};

/// Triangle ξ, η ≥ 0, ξ + η ≤ 1; corners (0, 0), (1, 0), (0, 1).
#[derive(Clone, Copy, Debug)]
pub struct Tri3;

pub(super) const NODES: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

impl Element for Tri3 {
    fn dimension(&self) -> usize {
        2
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, [x, y, _]: [f64; 3], values: &mut [f64]) {
        values.copy_from_slice(&[1.0 - x - y, x, y]);
    }

    fn gradients(&self, _xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        gradients.copy_from_slice(&[[-1.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn edge(nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace {
                kind: CellKind::Line2,
                nodes,
            }
        }
        const EDGES: [ReferenceFace; 3] = [edge(&[0, 1]), edge(&[1, 2]), edge(&[2, 0])];
        &EDGES
    }

    fn rule(&self) -> Rule {
        // The mass matrix is quadratic.
        triangle(2)
    }

    fn stress_points(&self) -> Rule {
        triangle(1)
    }
}
