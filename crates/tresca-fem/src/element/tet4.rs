//! The linear tetrahedron.

use super::reference::{Element, ReferenceFace};
use super::simplex::{barycentric, barycentric_gradient};
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, tetrahedron};

/// Tetrahedron ξ, η, ζ ≥ 0, ξ + η + ζ ≤ 1; corners (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1).
/// Faces opposite to the corners 2, 0, 1, 3.
#[derive(Clone, Copy, Debug)]
pub struct Tet4;

pub(super) const NODES: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
];

impl Element for Tet4 {
    fn dimension(&self) -> usize {
        3
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        values.copy_from_slice(&barycentric::<4>(xi));
    }

    fn gradients(&self, _xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        for (i, gradient) in gradients.iter_mut().enumerate() {
            *gradient = barycentric_gradient::<4>(i);
        }
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn face(nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace {
                kind: CellKind::Tri3,
                nodes,
            }
        }
        const FACES: [ReferenceFace; 4] = [
            face(&[0, 1, 3]),
            face(&[1, 2, 3]),
            face(&[2, 0, 3]),
            face(&[0, 2, 1]),
        ];
        &FACES
    }

    fn rule(&self) -> Rule {
        tetrahedron(1)
    }

    fn mass_rule(&self) -> Rule {
        tetrahedron(2)
    }

    fn stress_points(&self) -> Rule {
        tetrahedron(1)
    }
}
