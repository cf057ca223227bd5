//! The two-node line, the edge of plane elements.

use super::reference::{Element, ReferenceFace};
use crate::quadrature::{Rule, gauss_line};

/// Line [−1, 1] with nodes at its ends.
#[derive(Clone, Copy, Debug)]
pub struct Line2;

impl Element for Line2 {
    fn dimension(&self) -> usize {
        1
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &[[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        values.copy_from_slice(&[0.5 * (1.0 - xi[0]), 0.5 * (1.0 + xi[0])]);
    }

    fn gradients(&self, _xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        gradients.copy_from_slice(&[[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]]);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        &[]
    }

    fn rule(&self) -> Rule {
        gauss_line(2)
    }

    fn stress_points(&self) -> Rule {
        gauss_line(1)
    }
}
