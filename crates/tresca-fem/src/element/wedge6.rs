//! The linear wedge (triangular prism), with faces of two kinds.

use super::reference::{Element, ReferenceFace};
use super::simplex::{barycentric, barycentric_gradient};
use crate::mesh::kind::CellKind;
use crate::quadrature::{Rule, wedge};

/// Triangle ξ, η ≥ 0, ξ + η ≤ 1 times line −1 ≤ ζ ≤ 1; nodes 0–2 on the bottom ζ = −1, nodes 3–5
/// above them. Faces: bottom, top, then the three sides.
///
/// The order is that of VTK's documentation and faces: the normal of (0, 1, 2) by the right-hand rule
/// points *out of* the wedge. Gmsh, Abaqus and EnSight number each triangle the other way round; nodes
/// 1, 2 and 4, 5 of theirs are to be swapped.
#[derive(Clone, Copy, Debug)]
pub struct Wedge6;

const NODES: [[f64; 3]; 6] = [
    [0.0, 0.0, -1.0],
    [0.0, 1.0, -1.0],
    [1.0, 0.0, -1.0],
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [1.0, 0.0, 1.0],
];

/// For each node of a triangle its barycentric coordinate.
const COORDINATE: [usize; 3] = [0, 2, 1];

impl Element for Wedge6 {
    fn dimension(&self) -> usize {
        3
    }

    fn nodes(&self) -> &'static [[f64; 3]] {
        &NODES
    }

    fn shape(&self, xi: [f64; 3], values: &mut [f64]) {
        let l = barycentric::<3>(xi);
        for (a, value) in values.iter_mut().enumerate() {
            *value = 0.5 * l[COORDINATE[a % 3]] * (1.0 + NODES[a][2] * xi[2]);
        }
    }

    fn gradients(&self, xi: [f64; 3], gradients: &mut [[f64; 3]]) {
        let l = barycentric::<3>(xi);
        for (a, gradient) in gradients.iter_mut().enumerate() {
            let (i, side) = (COORDINATE[a % 3], NODES[a][2]);
            let [gx, gy, _] = barycentric_gradient::<3>(i);
            let along = 0.5 * (1.0 + side * xi[2]);
            *gradient = [gx * along, gy * along, 0.5 * side * l[i]];
        }
    }

    fn faces(&self) -> &'static [ReferenceFace] {
        const fn face(kind: CellKind, nodes: &'static [usize]) -> ReferenceFace {
            ReferenceFace { kind, nodes }
        }
        const FACES: [ReferenceFace; 5] = [
            face(CellKind::Tri3, &[0, 1, 2]),
            face(CellKind::Tri3, &[3, 5, 4]),
            face(CellKind::Quad4, &[0, 3, 4, 1]),
            face(CellKind::Quad4, &[1, 4, 5, 2]),
            face(CellKind::Quad4, &[2, 5, 3, 0]),
        ];
        &FACES
    }

    fn rule(&self) -> Rule {
        wedge(2, 2)
    }

    fn stress_points(&self) -> Rule {
        wedge(1, 1)
    }
}
