//! The biquadratic quadrilateral, also the face of [`super::Hex27`].

use super::nodes::with_means;
use super::reference::{Element, ReferenceFace};
use super::{lagrange, quad8};
use crate::quadrature::{Rule, gauss_square};

/// Square [−1, 1]²; corners and edge middles like [`super::Quad8`]'s, then the centre.
#[derive(Clone, Copy, Debug)]
pub struct Quad9;

const NODES: [[f64; 3]; 9] = with_means(&quad8::NODES, &[&[0, 1, 2, 3]]);

impl Element for Quad9 {
    fn dimension(&self) -> usize {
        2
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        lagrange::shape::<2>(&NODES, xi, values);
    }

    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        lagrange::gradients::<2>(&NODES, xi, gradients);
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        &quad8::EDGES
    }

    fn rule(&self) -> Rule {
        gauss_square(3)
    }

    fn stress_points(&self) -> Rule {
        gauss_square(2)
    }
}
