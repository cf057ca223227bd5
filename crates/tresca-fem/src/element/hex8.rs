//! The trilinear hexahedron.

use super::reference::{Element, ReferenceFace};
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, gauss_cube};

/// Cube [−1, 1]³; nodes 0–3 counter-clockwise on the bottom ζ = −1 from (−1, −1),
/// nodes 4–7 above them. Faces in the order ξ−, ξ+, η−, η+, ζ−, ζ+.
#[derive(Clone, Copy, Debug)]
pub struct Hex8;

pub(super) const NODES: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

impl Element for Hex8 {
    fn dimension(&self) -> usize {
        3
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, [x, y, z]: [f64; 3], values: &mut [f64]) {
        for (value, [a, b, c]) in values.iter_mut().zip(NODES) {
            *value = 0.125 * (1.0 + a * x) * (1.0 + b * y) * (1.0 + c * z);
        }
    }

    fn gradients(&self, [x, y, z]: [f64; 3], gradients: &mut [[f64; 3]]) {
        for (gradient, [a, b, c]) in gradients.iter_mut().zip(NODES) {
            let (fx, fy, fz) = (1.0 + a * x, 1.0 + b * y, 1.0 + c * z);
            *gradient = [
                0.125 * a * fy * fz,
                0.125 * b * fx * fz,
                0.125 * c * fx * fy,
            ];
        }
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn quad(nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace {
                kind: CellKind::Quad4,
                nodes,
            }
        }
        const QUADS: [ReferenceFace; 6] = [
            quad(&[0, 4, 7, 3]),
            quad(&[1, 2, 6, 5]),
            quad(&[0, 1, 5, 4]),
            quad(&[3, 7, 6, 2]),
            quad(&[0, 3, 2, 1]),
            quad(&[4, 5, 6, 7]),
        ];
        &QUADS
    }

    fn rule(&self) -> Rule {
        gauss_cube(2)
    }

    fn stress_points(&self) -> Rule {
        gauss_cube(1)
    }
}
