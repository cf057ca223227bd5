//! The three-node line, the edge of quadratic plane elements.

use super::lagrange;
use super::reference::{Element, ReferenceFace};
use crate::quadrature::{Rule, gauss_line};

/// Line [−1, 1] with nodes at its ends, then its middle.
#[derive(Clone, Copy, Debug)]
pub struct Line3;

const NODES: [[f64; 3]; 3] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];

impl Element for Line3 {
    fn dimension(&self) -> usize {
        1
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        lagrange::shape::<1>(&NODES, xi, values);
    }

    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        lagrange::gradients::<1>(&NODES, xi, gradients);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        &[]
    }

    fn rule(&self) -> Rule {
        gauss_line(3)
    }

    fn stress_points(&self) -> Rule {
        gauss_line(2)
    }
}
