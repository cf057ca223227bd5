//! The triquadratic hexahedron.

use super::nodes::with_means;
use super::reference::{Element, ReferenceFace};
use super::{hex20, lagrange};
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, gauss_cube};

/// Cube [−1, 1]³; corners, edge middles and faces like [`super::Hex20`]'s, then the centres of the
/// faces ξ−, ξ+, η−, η+, ζ−, ζ+, then the centre.
#[derive(Clone, Copy, Debug)]
pub struct Hex27;

const NODES: [[f64; 3]; 27] = with_means(
    &hex20::NODES,
    &[
        &[0, 3, 4, 7],
        &[1, 2, 5, 6],
        &[0, 1, 4, 5],
        &[2, 3, 6, 7],
        &[0, 1, 2, 3],
        &[4, 5, 6, 7],
        &[0, 1, 2, 3, 4, 5, 6, 7],
    ],
);

impl Element for Hex27 {
    fn dimension(&self) -> usize {
        3
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        lagrange::shape::<3>(&NODES, xi, values);
    }

    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        lagrange::gradients::<3>(&NODES, xi, gradients);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn face(nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace {
                kind: CellKind::Quad9,
                nodes,
            }
        }
        const FACES: [ReferenceFace; 6] = [
            face(&[0, 4, 7, 3, 16, 15, 19, 11, 20]),
            face(&[1, 2, 6, 5, 9, 18, 13, 17, 21]),
            face(&[0, 1, 5, 4, 8, 17, 12, 16, 22]),
            face(&[3, 7, 6, 2, 19, 14, 18, 10, 23]),
            face(&[0, 3, 2, 1, 11, 10, 9, 8, 24]),
            face(&[4, 5, 6, 7, 12, 13, 14, 15, 25]),
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
